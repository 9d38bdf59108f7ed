// SPDX-License-Identifier: Apache-2.0
#include "machine/bill_of_materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "machine/quantity_reader.h"
#include "text/csv.h"
#include "text/nearest.h"
#include "text/utf8.h"

namespace millwright::machine {

namespace {

using text::CsvTable;
using text::Diagnostics;

const std::vector<std::string> known_columns{
    "axis", "slot", "manufacturer", "part_number", "quantity", "length", "value", "origin"};
const std::vector<std::string> origins{"paper", "ours"};
constexpr double most_pieces_of_a_line = 10000.0;

/// What decides about a check is not left out because its column is called otherwise: other names, in small letters.
constexpr std::pair<std::string_view, const char*> other_names[] = {{"quantity", "quantity"},
                                                                    {"quantities", "quantity"},
                                                                    {"quanity", "quantity"},
                                                                    {"qty", "quantity"},
                                                                    {"qty.", "quantity"},
                                                                    {"count", "quantity"},
                                                                    {"pcs", "quantity"},
                                                                    {"pieces", "quantity"},
                                                                    {"length", "length"},
                                                                    {"lengths", "length"},
                                                                    {"lenght", "length"},
                                                                    {"len", "length"},
                                                                    {"value", "value"},
                                                                    {"values", "value"}};

/// The deciding column that is meant by another name, if any.
std::optional<std::string> deciding_column_meant(std::string name) {
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const auto& [other, column] : other_names)
    if (name == other) return column;
  return std::nullopt;
}

bool is_among(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

class BillReader {
 public:
  BillReader(const CsvTable& table, const Problem& problem, Diagnostics& diagnostics)
      : table_(table), problem_(problem), diagnostics_(diagnostics) {}

  BillOfMaterials read() {
    BillOfMaterials bom;
    bom.file = table_.text()->path();
    if (!find_columns() || is_of_another_machine()) return bom;
    for (std::size_t row = 0; row < table_.row_count(); ++row)
      if (auto line = read_line(row)) bom.lines.push_back(std::move(*line));
    return bom;
  }

 private:
  /// False: it would decide something.
  bool take_unknown(const text::CsvColumn& column) {
    const std::string message = fmt::format("column '{}' is not used", column.name);
    if (const auto meant = deciding_column_meant(column.name); meant && !table_.find_column(*meant)) {
      diagnostics_.error(column.name_span, message, fmt::format("did you mean '{}'?", *meant));
      return false;
    }
    diagnostics_.warning(
        column.name_span,
        message,
        text::did_you_mean(column.name, known_columns, fmt::format("those used: {}", fmt::join(known_columns, ", "))));
    return true;
  }

  bool find_columns() {
    bool good = true;
    for (const text::CsvColumn& column : table_.columns())
      if (!is_among(known_columns, column.name)) good = take_unknown(column) && good;
    for (const char* name : {"axis", "slot", "part_number"}) {
      if (table_.find_column(name)) continue;
      diagnostics_.error(table_.header_span(),
                         fmt::format("the bill of materials has no column '{}'", name),
                         "the header is axis,slot,manufacturer,part_number,quantity,length,value");
      good = false;
    }
    return good;
  }

  std::string cell(std::size_t row, const char* name) const {
    const auto column = table_.find_column(name);
    return column ? std::string(table_.cell(row, *column)) : std::string();
  }
  SourceSpan span(std::size_t row, const char* name) const {
    const auto column = table_.find_column(name);
    return column ? table_.cell_span(row, *column) : table_.row_span(row);
  }

  const Axis* find_axis(const std::string& name) const {
    const auto found =
        std::find_if(problem_.axes.begin(), problem_.axes.end(), [&](const Axis& a) { return a.name == name; });
    return found == problem_.axes.end() ? nullptr : &*found;
  }

  /// A list in which no axis is one of the problem's was meant for another machine: one complaint says it all.
  bool is_of_another_machine() {
    std::vector<std::string> names;
    std::size_t first = 0;
    for (std::size_t row = 0; row < table_.row_count(); ++row) {
      const std::string axis = cell(row, "axis");
      if (find_axis(axis) != nullptr) return false;
      if (axis.empty() || axis == "machine" || is_among(names, axis)) continue;
      if (names.empty()) first = row;
      names.push_back(axis);
    }
    if (names.size() < 2) return false;
    std::vector<std::string> wanted;
    for (const Axis& axis : problem_.axes) wanted.push_back(axis.name);
    diagnostics_.error(span(first, "axis"),
                       fmt::format("this bill of materials is for another machine: its axes are {}",
                                   text::printable(fmt::format("{}", fmt::join(names, ", ")))),
                       fmt::format("the axes of the problem are {}", fmt::join(wanted, ", ")));
    return true;
  }

  /// A quantity in a cell. Where ';' separates, a decimal comma is understood.
  std::optional<double> quantity(std::size_t row, const char* name, std::string_view unit, std::string_view example) {
    std::string text = cell(row, name);
    if (text.empty()) return std::nullopt;
    if (table_.separator() == ';' && std::count(text.begin(), text.end(), ',') == 1 &&
        text.find('.') == std::string::npos)
      text[text.find(',')] = '.';
    QuantityFault fault;
    if (const auto value = read_quantity(text, unit, Sign::positive, fault)) return value;
    if (fault.hint.starts_with("write for example")) fault.hint = fmt::format("write for example {}", example);
    diagnostics_.error(part(row, name, fault), fmt::format("{}: {}", name, fault.message), fault.hint);
    return std::nullopt;
  }

  /// The place of a part of a cell, where the text shows the cell as it is.
  SourceSpan part(std::size_t row, const char* name, const QuantityFault& fault) const {
    SourceSpan place = span(row, name);
    const std::string text = cell(row, name);
    if (place.length != static_cast<int>(text::count_characters(text))) return place;
    place.column += static_cast<int>(text::count_characters(std::string_view(text).substr(0, fault.offset)));
    place.length = std::max(
        1, static_cast<int>(text::count_characters(std::string_view(text).substr(fault.offset, fault.length))));
    return place;
  }

  std::optional<double> pieces(std::size_t row) {
    const auto value = quantity(row, "quantity", "1", "4");
    if (!value || (*value == std::floor(*value) && *value <= most_pieces_of_a_line)) return value;
    diagnostics_.error(span(row, "quantity"),
                       fmt::format("quantity: {:.6g} pieces", *value),
                       *value > most_pieces_of_a_line ? "is this another column's value?"
                                                      : "a whole number of pieces; what is cut to length has a length");
    return std::nullopt;
  }

  bool known_axis(std::size_t row, const std::string& name) {
    if (name == "machine" || find_axis(name) != nullptr) return true;
    if (name.empty()) {
      diagnostics_.error(span(row, "axis"), "axis: the cell is empty", "name an axis, or machine for what they share");
      return false;
    }
    if (!unknown_axes_.insert(name).second) return false;  // said already
    std::vector<std::string> names{"machine"};
    for (const Axis& axis : problem_.axes) names.push_back(axis.name);
    std::size_t lines = 0;
    for (std::size_t other = row; other < table_.row_count(); ++other) lines += cell(other, "axis") == name ? 1U : 0U;
    diagnostics_.error(span(row, "axis"),
                       fmt::format("axis: the problem has no axis {}{}",
                                   text::in_quotes(name),
                                   lines > 1 ? fmt::format(" ({} lines)", lines) : ""),
                       text::did_you_mean(name, names, fmt::format("axes: {}", fmt::join(names, ", "))));
    return false;
  }

  /// The slots and settings of an axis; of the machine: its supply and supply_voltage.
  bool known_slot(std::size_t row, const std::string& axis, const std::string& slot) {
    std::vector<std::string> slots{"supply"};
    std::vector<std::string> settings{"supply_voltage"};
    if (const Axis* found = find_axis(axis); found != nullptr && axis != "machine") {
      slots = slot_names(*found);
      settings = setting_names(*found);
    }
    is_setting_ = is_among(settings, slot);
    if (is_setting_ || is_among(slots, slot)) return true;
    slots.insert(slots.end(), settings.begin(), settings.end());
    const std::string all = fmt::format("slots: {}", fmt::join(slots, ", "));
    if (slot.empty())
      diagnostics_.error(span(row, "slot"), "slot: the cell is empty", all);
    else
      diagnostics_.error(span(row, "slot"),
                         fmt::format("slot: axis '{}' has no {}", axis, text::in_quotes(slot)),
                         text::did_you_mean(slot, slots, all));
    return false;
  }

  bool is_first(std::size_t row, const BomLine& line) {
    const auto [first, added] = seen_.try_emplace({line.axis, line.slot}, row);
    if (added) return true;
    text::Diagnostic twice;
    twice.where = span(row, "slot");
    twice.message = fmt::format("slot: {} of axis '{}' is given twice", line.slot, line.axis);
    twice.hint = "one line a slot";
    twice.related = span(first->second, "slot");
    twice.related_message = "first given here";
    diagnostics_.add(std::move(twice));
    return false;
  }

  /// A setting has a value and nothing else.
  void check_setting(std::size_t row, const BomLine& line) {
    const std::string_view unit = unit_of_setting(line.slot);
    const std::string example(unit == "mm" ? "12 mm" : usual_values(unit).example);
    if (!line.part_number.empty())
      diagnostics_.error(span(row, "part_number"),
                         fmt::format("part_number: {} of axis '{}' is a setting, not a part", line.slot, line.axis),
                         fmt::format("leave the cell empty and write {} into the column value", example));
    else if (cell(row, "value").empty())
      diagnostics_.error(span(row, "value"),
                         fmt::format("value: {} of axis '{}' has none", line.slot, line.axis),
                         fmt::format("write for example {}, or remove the line", example));
    for (const char* name : {"quantity", "length"})
      if (!cell(row, name).empty())
        diagnostics_.warning(
            span(row, name), fmt::format("{}: not used, {} is a setting", name, line.slot), "leave the cell empty");
  }

  /// A slot has a part and no value.
  void check_part(std::size_t row, const BomLine& line) {
    if (line.part_number.empty())
      diagnostics_.error(span(row, "part_number"),
                         fmt::format("part_number: {} of axis '{}' names no part", line.slot, line.axis),
                         "name a part of the catalogues, or remove the line");
    if (!cell(row, "value").empty())
      diagnostics_.error(span(row, "value"),
                         fmt::format("value: {} of axis '{}' is a part and has none", line.slot, line.axis),
                         "a cut length stands in the column length");
  }

  void check_origin(std::size_t row, const std::string& origin) {
    if (origin.empty() || is_among(origins, origin)) return;
    diagnostics_.warning(span(row, "origin"),
                         fmt::format("origin: {} means nothing here", text::in_quotes(origin)),
                         text::did_you_mean(origin, origins, "paper, ours, or empty"));
  }

  std::optional<BomLine> read_line(std::size_t row) {
    BomLine line;
    line.axis = cell(row, "axis");
    line.slot = cell(row, "slot");
    line.manufacturer = cell(row, "manufacturer");
    line.part_number = cell(row, "part_number");
    line.origin = cell(row, "origin");
    check_origin(row, line.origin);
    const bool known = known_axis(row, line.axis) && known_slot(row, line.axis, line.slot) && is_first(row, line);
    if (!known) return std::nullopt;
    const std::size_t before = diagnostics_.error_count();
    line.length = quantity(row, "length", "mm", "820 mm");
    if (is_setting_) {
      line.value = quantity(row, "value", unit_of_setting(line.slot), usual_values(unit_of_setting(line.slot)).example);
      check_setting(row, line);
    } else {
      line.quantity = pieces(row);
      check_part(row, line);
    }
    line.where = span(row, line.value ? "value" : "part_number");
    if (diagnostics_.error_count() > before) return std::nullopt;
    return line;
  }

  const CsvTable& table_;
  const Problem& problem_;
  Diagnostics& diagnostics_;
  std::map<std::pair<std::string, std::string>, std::size_t> seen_;
  std::set<std::string> unknown_axes_;
  bool is_setting_ = false;  ///< of the line that is being read
};

}  // namespace

std::string_view unit_of_setting(const std::string& name) {
  if (name == "acceleration_time") return "s";
  if (name == "supply_voltage") return "V";
  if (name == "motor_current") return "A";
  return "mm";
}

std::vector<std::string> slot_names(const Axis& axis) {
  std::vector<std::string> names;
  if (axis.guide) names.push_back("guide");
  for (const Member& member : axis.members)
    if (!member.sections.empty() || member.kind == MemberKind::bolts) names.push_back(member.name);
  if (axis.mechanism.kind == MechanismKind::belt) {
    names.insert(names.end(), {"belt", "pulley_drive", "pulley_idle", "motor", "driver"});
  } else if (axis.mechanism.kind == MechanismKind::rack) {
    names.insert(names.end(), {"rack", "pinion", "motor", "driver"});
  } else if (axis.mechanism.kind == MechanismKind::rotary) {
    names.insert(names.end(), {"motor", "driver"});
  } else {
    names.insert(names.end(), {"screw", "nut", "motor", "driver"});
    if (has_coupling(axis.mechanism)) names.push_back("coupling");
    names.push_back("support_fixed");
    if (axis.mechanism.ends != Ends::fixed_free) names.push_back("support_free");
  }
  // One without a name is stated in the problem and there is no other to choose.
  const std::vector<Reduction>& reductions = axis.mechanism.reductions;
  if (!reductions.empty() && !reductions.front().name.empty()) names.push_back("reduction");
  return names;
}

std::vector<std::string> setting_names(const Axis& axis) {
  std::vector<std::string> names{"acceleration_time", "motor_current"};
  for (const Member& member : axis.members) {
    if (member.kind == MemberKind::round_shaft) names.push_back(member.name + ".diameter");
    if (member.kind == MemberKind::rectangular_bar) {
      names.push_back(member.name + ".width");
      names.push_back(member.name + ".height");
    }
    if (member.kind == MemberKind::weld) names.push_back(member.name + ".leg");
    if (member.kind == MemberKind::plate) names.push_back(member.name + ".thickness");
  }
  return names;
}

std::optional<BillOfMaterials> read_bill_of_materials(std::shared_ptr<const text::SourceText> text,
                                                      const Problem& problem,
                                                      Diagnostics& diagnostics) {
  const std::size_t errors = diagnostics.error_count();
  const CsvTable table = text::read_csv(std::move(text), diagnostics);
  const bool whole = diagnostics.error_count() == errors;
  if (!whole && table.columns().empty()) return std::nullopt;
  BillOfMaterials bom = BillReader(table, problem, diagnostics).read();
  if (whole && table.row_count() == 0 && diagnostics.error_count() == errors)
    diagnostics.error(table.header_span(),
                      "the bill of materials is empty",
                      "add lines such as x,motor,StepperOnline,23HS22-2804S,1,,");
  if (diagnostics.error_count() > errors) return std::nullopt;
  return bom;
}

}  // namespace millwright::machine
