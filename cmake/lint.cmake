# Target `lint`: clang-tidy over every source of the rooms, in batches (lint_batch.sh). Each batch has a stamp that depends
# on what it includes (the preprocessor writes the list), so only what changed since it passed is looked at again.
find_program(CLANG_TIDY NAMES clang-tidy-14 clang-tidy)
find_program(CLANG_FOR_TIDY NAMES clang++-14 clang++)
if(NOT CLANG_TIDY OR NOT CLANG_FOR_TIDY)
  return()
endif()

set(batch_size 32)
set(stamps)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/lint)
foreach(target IN ITEMS ${room_targets} millwright)
  if(NOT TARGET ${target})
    continue()
  endif()
  get_target_property(type ${target} TYPE)
  if(type STREQUAL INTERFACE_LIBRARY)
    continue()
  endif()
  get_target_property(sources ${target} SOURCES)
  if(target STREQUAL millwright)
    list(APPEND sources ${PROJECT_SOURCE_DIR}/src/app/allocator.cpp)  # not in the sanitised program
  endif()
  # Registrations only list formulas, and take a quarter of the time; the formulas' headers are read with what uses them.
  list(FILTER sources EXCLUDE REGEX "_formulas\\.cpp$|/(page|template)_assets\\.cpp$")
  set(includes "$<REMOVE_DUPLICATES:$<TARGET_PROPERTY:${target},INCLUDE_DIRECTORIES>>")
  set(definitions "$<REMOVE_DUPLICATES:$<TARGET_PROPERTY:${target},COMPILE_DEFINITIONS>>")
  # pkg-config hands some definitions on as options.
  set(options "$<FILTER:$<REMOVE_DUPLICATES:$<TARGET_PROPERTY:${target},COMPILE_OPTIONS>>,INCLUDE,^-D>")
  set(number 0)
  while(sources)
    list(SUBLIST sources 0 ${batch_size} batch)
    list(REMOVE_ITEM sources ${batch})
    math(EXPR number "${number} + 1")
    set(stamp ${PROJECT_BINARY_DIR}/lint/${target}_${number})
    add_custom_command(OUTPUT ${stamp}
      COMMAND ${PROJECT_SOURCE_DIR}/cmake/lint_batch.sh ${stamp} ${CLANG_FOR_TIDY} ${CLANG_TIDY} ${PROJECT_SOURCE_DIR}/.clang-tidy
        -std=c++20 "-I$<JOIN:${includes},;-I>" "$<$<BOOL:${definitions}>:-D$<JOIN:${definitions},;-D>>" "${options}" -- ${batch}
      DEPENDS ${batch} ${PROJECT_SOURCE_DIR}/.clang-tidy ${PROJECT_SOURCE_DIR}/cmake/lint_batch.sh
      DEPFILE ${stamp}.d
      COMMENT "clang-tidy ${target}, batch ${number}" COMMAND_EXPAND_LISTS VERBATIM)
    list(APPEND stamps ${stamp})
  endwhile()
endforeach()
add_custom_target(lint DEPENDS ${stamps})
