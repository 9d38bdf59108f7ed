// SPDX-License-Identifier: Apache-2.0
#include "report/incomplete.h"

#include <fmt/format.h>

#include <algorithm>

#include "report/html.h"

namespace millwright::report {
namespace {

/// "88 of 171 ball_screws (nut_mass, nut_length), 8 of 40 lead_nuts (materials.yield_strength)"
std::string incomplete_words(const std::vector<evaluation::IncompleteParts>& all, const Texts& t) {
  std::vector<std::string> words;
  for (auto group = all.begin(); group != all.end();) {
    const std::string& family = group->family;
    const std::size_t known = group->known;
    std::size_t parts = 0;
    std::vector<std::string> missing;  // in the order in which they are met
    for (; group != all.end() && group->family == family; ++group) {
      parts += group->parts.size();
      for (const std::string& figure : group->missing)
        if (std::find(missing.begin(), missing.end(), figure) == missing.end()) missing.push_back(figure);
    }
    words.push_back(fmt::format(fmt::runtime(t("certificate.incomplete_of")), parts, known, family));
    if (!missing.empty()) words.back() += fmt::format(" ({})", fmt::join(missing, ", "));
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

std::string incomplete_text(const std::vector<evaluation::IncompleteParts>& parts, const Style& style, const Texts& t) {
  std::string out;
  const auto line = [&](const std::string& text) { out += "  " + wrapped(text, style.width - 2, 2) + "\n"; };
  if (parts.empty()) return out;
  line(fmt::format(fmt::runtime(t("certificate.incomplete")), incomplete_words(parts, t)));
  for (const evaluation::IncompleteParts& each : parts)
    if (style.full)
      line(fmt::format("{}{}{}: {}",
                       each.family,
                       each.missing.empty() ? "" : ", ",
                       fmt::join(each.missing, ", "),
                       fmt::join(each.parts, "; ")));
  return out;
}

std::string incomplete_html(const std::vector<evaluation::IncompleteParts>& parts, const Texts& t) {
  return parts.empty() ? std::string() : "<p class=\"hint\">" + escaped(incomplete_text(parts, Style{}, t)) + "</p>\n";
}

Json incomplete_of(const std::vector<evaluation::IncompleteParts>& parts) {
  Json json = Json::array();
  for (const evaluation::IncompleteParts& each : parts)
    json.push_back({{"family", each.family}, {"of", each.known}, {"missing", each.missing}, {"parts", each.parts}});
  return json;
}

}  // namespace millwright::report
