// SPDX-License-Identifier: Apache-2.0
#include "report/catalogue_gaps.h"

#include "report/json_value.h"

namespace millwright::report {

std::string gaps_text(const std::vector<catalogue::Gap>& gaps, const Style& style) {
  if (gaps.empty()) return "nothing that is looked for is missing\n";
  std::string text;
  std::string_view family;
  for (const catalogue::Gap& gap : gaps) {
    const std::string_view name = catalogue::declaration(gap.family).name;
    if (name != family) text += (text.empty() ? "" : "\n") + style.heading(name) + "\n";
    family = name;
    text += "  " + wrapped("no " + gap.missing, style.width - 8, 6) + "\n";
    text += style.faint("    " + wrapped(gap.reason, style.width - 8, 6)) + "\n";
  }
  return text;
}

std::string gaps_json(const std::vector<catalogue::Gap>& gaps) {
  Json json = result_of("catalogue list");
  json["gaps"] = Json::array();
  for (const catalogue::Gap& gap : gaps)
    json["gaps"].push_back({{"family", catalogue::declaration(gap.family).name},
                            {"missing", gap.missing},
                            {"sizes", gap.sizes},
                            {"reason", gap.reason}});
  return text_of(json);
}

}  // namespace millwright::report
