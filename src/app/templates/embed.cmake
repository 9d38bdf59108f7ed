# SPDX-License-Identifier: Apache-2.0
# cmake -D LITERALS=cmake/text_literals.cmake -D OUTPUT=... -P embed.cmake: writes the templates of this folder into a C++
# source.
include(${LITERALS})
file(GLOB files ${CMAKE_CURRENT_LIST_DIR}/*.toml)  # by name
set(entries "")
foreach(file IN LISTS files)
  get_filename_component(name ${file} NAME_WE)
  file(SIZE ${file} size)
  if(size GREATER text_literal_length)
    message(FATAL_ERROR "${file} is too long for one literal")
  endif()
  text_literals(${file} text)
  string(APPEND entries "    {\"${name}\",\n${text}    },\n")
endforeach()
file(WRITE ${OUTPUT}.new "// Written by src/app/templates/embed.cmake.
#include \"app/templates.h\"

namespace millwright::app {

namespace {
constexpr Template all[] = {
${entries}};
}  // namespace

std::span<const Template> templates() { return all; }

}  // namespace millwright::app
")
file(RENAME ${OUTPUT}.new ${OUTPUT})
