# What keeps a full build short: headers that a room or the tests include everywhere are parsed once, sources are compiled
# in batches, and code that no search runs through is not optimised to the last.

# millwright_precompile(<target> <headers...> | REUSE_FROM <other target>): both targets need the same optimisation.
function(millwright_precompile target)
  if(ARGV1 STREQUAL "REUSE_FROM")
    target_precompile_headers(${target} REUSE_FROM ${ARGV2})
  else()
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
  # Without the first ones ccache does not take files with precompiled headers (its manual, "Precompiled headers"). The
  # warnings are g++ 12's about its own std::string, which it keeps to itself unless the header is precompiled.
  target_compile_options(${target} PRIVATE
    "$<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess;-Wno-array-bounds;-Wno-stringop-overflow>"
    "$<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>")
endfunction()

# The sources of a target in batches, each compiled as one: what they all include is read once, and what they all use of
# templates is compiled once. A full build takes half the time that way. Names in anonymous namespaces have to be different
# within a room, as a new source moves the borders of the batches. OFF compiles every source by itself.
option(MILLWRIGHT_UNITY "Compile sources in batches" ON)
function(millwright_unite target)
  if(MILLWRIGHT_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 16)
    # A class hidden in a source may have members that are hidden there: a batch is no header.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()
endfunction()

# The optimised build takes -O1 for this target. Results are the same: neither level reorders arithmetic.
function(millwright_optimise_less target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# With the sanitizers a stack frame is kept for a while after its function returned, so that a use of it is found. Not in
# what a search asks a million times, where that is a tenth of the time and more: a use after return is missed there.
function(millwright_forget_frames target)
  target_compile_options(${target} PRIVATE $<$<AND:$<BOOL:${MILLWRIGHT_SANITIZE}>,$<CXX_COMPILER_ID:Clang>>:-fsanitize-address-use-after-return=never>)
endfunction()
