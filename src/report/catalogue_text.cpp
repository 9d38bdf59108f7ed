// SPDX-License-Identifier: Apache-2.0
#include "report/catalogue_text.h"

#include <fmt/format.h>

#include <cmath>

namespace millwright::report {

namespace {

std::string share(double value) { return fmt::format("{:.0f} %", 100.0 * value); }

/// "12.50 USD", "3.20 USD/m", whichever kinds of price there are.
std::string price_text(const catalogue::PartLine& part, const Style& style) {
  const catalogue::Price& price = part.price;
  const char* separator = style.width < 120 ? "\n+ " : " + ";
  const std::string mark = part.price_estimate ? "~" : "";
  std::string out;
  const auto add = [&](double value, const char* per) {
    if (!std::isnan(value))
      out += fmt::format("{}{}{:.2f} {}{}", out.empty() ? "" : separator, mark, value, price.currency, per);
  };
  add(price.piece, "");
  add(price.length, "/m");
  add(price.mass, "/kg");
  return out;
}

std::string range_text(const catalogue::PriceRange& range) {
  const std::string per = range.per.empty() ? "" : "/" + std::string(range.per.substr(2));
  return fmt::format("{:.2f} to {:.2f} {}{}", range.lowest, range.highest, range.currency, per);
}

}  // namespace

namespace {

std::string remarks_text(const catalogue::Inventory& inventory) {
  const auto counted = [](std::size_t count, const char* what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
  };
  std::string text;
  for (const catalogue::LayerRecord& layer : inventory.layers) {
    if (layer.remarks.empty()) continue;
    text += text::printable(layer.place) + ": ";
    text += layer.files == 0 ? "no parts of its own"
                             : counted(static_cast<std::size_t>(layer.rows), "row") + " of parts in " +
                                   counted(static_cast<std::size_t>(layer.files), "file");
    for (const catalogue::RemarkFile& each : layer.remarks)
      text += fmt::format(", {} with {}", each.name, counted(each.lines, "line"));
    text += '\n';
  }
  return text.empty() ? text : "\n" + text;
}

}  // namespace

std::string families_text(const std::vector<catalogue::FamilySummary>& families,
                          const catalogue::Inventory& inventory,
                          const Style& style) {
  TextTable table({{"family"},
                   {"what"},
                   {"rows", Align::right},
                   {"makers", Align::right},
                   {"prices"},
                   {"estimated", Align::right}});
  for (const catalogue::FamilySummary& family : families) {
    bool first = true;
    const auto add = [&](const std::string& prices) {
      if (first)
        table.add({std::string(family.name),
                   std::string(family.title),
                   std::to_string(family.rows),
                   std::to_string(family.manufacturers),
                   prices,
                   share(family.estimated_share)});
      else
        table.add({"", "", "", "", prices});
      first = false;
    };
    for (const catalogue::PriceRange& range : family.prices) add(range_text(range));
    if (first) add("");
  }
  return table.str(0, style) + remarks_text(inventory);
}

std::string parts_list_text(const std::vector<catalogue::PartLine>& parts, const Style& style) {
  TextTable table({{"manufacturer"}, {"part number"}, {"price", Align::right}, {"figures", Align::left, 70}});
  for (const catalogue::PartLine& part : parts)
    table.add({std::string(part.manufacturer), std::string(part.part_number), price_text(part, style), part.figures});
  return table.str(0, style) + fmt::format("{} {}; ~ estimate\n", parts.size(), parts.size() == 1 ? "row" : "rows");
}

std::string sheet_text(const catalogue::PartSheet& sheet, const Style& style) {
  std::string out = style.heading(fmt::format("{} {}", sheet.manufacturer, sheet.part_number)) +
                    fmt::format("\n  {}, {}\n\n", catalogue::declaration(sheet.family).title, sheet.place);
  TextTable table({{""}, {"", Align::right}, {""}, {""}, {"", Align::left, 48}});
  bool estimates = false;
  for (const catalogue::Figure& figure : sheet.figures) {
    estimates = estimates || figure.estimate;
    const bool is_text = std::isnan(figure.si);
    std::string origin =
        figure.standing == catalogue::Standing::unstated ? "" : std::string(to_string(figure.standing));
    if (!std::isnan(figure.tolerance)) origin += fmt::format(" ±{:.3g} %", 100.0 * figure.tolerance);
    if (!figure.confidence.empty()) origin += fmt::format(", {}", figure.confidence);
    table.add({std::string(figure.column),
               is_text ? "" : (figure.estimate ? "~" : "") + figure.value,
               figure.unit == "1" ? "" : figure.unit,
               origin,
               is_text ? figure.value : std::string(figure.meaning)});
  }
  return out + table.str(2, style) + (estimates ? "\n  ~ estimate\n" : "");
}

}  // namespace millwright::report
