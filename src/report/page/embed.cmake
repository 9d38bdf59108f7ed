# SPDX-License-Identifier: Apache-2.0
# cmake -D STYLE=... -D SCRIPT=... -D OUTPUT=... -P embed.cmake: writes both files into a C++ source. Literals have a
# least length that every compiler takes, so they are written in pieces.
set(piece_length 30000)

function(literals file name result)
  set(text "const std::string_view ${name}[] = {\n")
  file(READ ${file} content)
  string(LENGTH "${content}" length)
  set(at 0)
  while(at LESS length)
    string(SUBSTRING "${content}" ${at} ${piece_length} piece)
    string(APPEND text "    R\"millwright(${piece})millwright\",\n")
    math(EXPR at "${at} + ${piece_length}")
  endwhile()
  set(${result} "${text}};\n" PARENT_SCOPE)
endfunction()

literals(${STYLE} style_pieces style)
literals(${SCRIPT} script_pieces script)
file(WRITE ${OUTPUT}.new "// Written by src/report/page/embed.cmake.
#include \"report/page_assets.h\"

#include <string_view>

namespace millwright::report {

namespace {
${style}
${script}
template <std::size_t count>
std::string joined(const std::string_view (&pieces)[count]) {
  std::string text;
  for (const std::string_view piece : pieces) text += piece;
  return text;
}
}  // namespace

std::string page_style() { return joined(style_pieces); }
std::string page_script() { return joined(script_pieces); }

}  // namespace millwright::report
")
file(RENAME ${OUTPUT}.new ${OUTPUT})
