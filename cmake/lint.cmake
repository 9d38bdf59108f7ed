# Target `lint`: clang-tidy over every source of the rooms. Each file has a stamp that depends on what it includes (the
# preprocessor writes the list), so only what changed since it passed is looked at again.
find_program(CLANG_TIDY NAMES clang-tidy-14 clang-tidy)
find_program(CLANG_FOR_TIDY NAMES clang++-14 clang++)
if(NOT CLANG_TIDY OR NOT CLANG_FOR_TIDY)
  return()
endif()

# Without precompiled headers: what a source does not include itself is missed.
set(commands ${PROJECT_BINARY_DIR}/lint/compile_commands.json)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/lint)
add_custom_command(OUTPUT ${commands}
  COMMAND sed -E "s/-Xclang -include(-pch)? -Xclang [^ ]+ //g" ${PROJECT_BINARY_DIR}/compile_commands.json > ${commands}
  DEPENDS ${PROJECT_BINARY_DIR}/build.ninja VERBATIM)
add_custom_target(lint_commands DEPENDS ${commands})
set(stamps)
foreach(target IN ITEMS ${room_targets} millwright)
  if(NOT TARGET ${target})
    continue()
  endif()
  get_target_property(type ${target} TYPE)
  if(type STREQUAL INTERFACE_LIBRARY)
    continue()
  endif()
  get_target_property(sources ${target} SOURCES)
  # Registrations only list formulas, and take a quarter of the time; the formulas' headers are read with what uses them.
  list(FILTER sources EXCLUDE REGEX "_formulas\\.cpp$|/(page|template)_assets\\.cpp$")
  set(includes "$<REMOVE_DUPLICATES:$<TARGET_PROPERTY:${target},INCLUDE_DIRECTORIES>>")
  set(definitions "$<REMOVE_DUPLICATES:$<TARGET_PROPERTY:${target},COMPILE_DEFINITIONS>>")
  # pkg-config hands some definitions on as options.
  set(options "$<FILTER:$<REMOVE_DUPLICATES:$<TARGET_PROPERTY:${target},COMPILE_OPTIONS>>,INCLUDE,^-D>")
  foreach(source IN LISTS sources)
    file(RELATIVE_PATH name ${PROJECT_SOURCE_DIR}/src ${source})
    set(stamp ${PROJECT_BINARY_DIR}/lint/${name}.stamp)
    get_filename_component(directory ${stamp} DIRECTORY)
    file(MAKE_DIRECTORY ${directory})
    add_custom_command(OUTPUT ${stamp}
      COMMAND ${CLANG_FOR_TIDY} -std=c++20 "-I$<JOIN:${includes},;-I>" "$<$<BOOL:${definitions}>:-D$<JOIN:${definitions},;-D>>" "${options}"
        -MM -MT ${stamp} -MF ${stamp}.d ${source}
      COMMAND ${CLANG_TIDY} --quiet --config-file=${PROJECT_SOURCE_DIR}/.clang-tidy -p ${PROJECT_BINARY_DIR}/lint ${source}
      COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
      DEPENDS ${source} ${PROJECT_SOURCE_DIR}/.clang-tidy lint_commands
      DEPFILE ${stamp}.d
      COMMENT "clang-tidy ${name}" COMMAND_EXPAND_LISTS VERBATIM)
    list(APPEND stamps ${stamp})
  endforeach()
endforeach()
add_custom_target(lint DEPENDS ${stamps})
