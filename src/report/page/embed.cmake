# SPDX-License-Identifier: Apache-2.0
# cmake -D LITERALS=cmake/text_literals.cmake -D STYLE=... -D SCRIPT=... -D SOURCES=... -D OUTPUT=... -P
# embed.cmake: writes these files into a C++ source.
include(${LITERALS})
text_literals(${STYLE} style)
text_literals(${SCRIPT} script)
text_literals(${SOURCES} sources)
file(WRITE ${OUTPUT}.new "// Written by src/report/page/embed.cmake.
#include \"report/page_assets.h\"

#include <string_view>

namespace millwright::report {

namespace {
const std::string_view style_pieces[] = {
${style}};
const std::string_view script_pieces[] = {
${script}};
const std::string_view sources_pieces[] = {
${sources}};

template <std::size_t count>
std::string joined(const std::string_view (&pieces)[count]) {
  std::string text;
  for (const std::string_view piece : pieces) text += piece;
  return text;
}
}  // namespace

std::string page_style() { return joined(style_pieces); }
std::string page_script() { return joined(script_pieces); }
std::string sources_bib() { return joined(sources_pieces); }

}  // namespace millwright::report
")
file(RENAME ${OUTPUT}.new ${OUTPUT})
