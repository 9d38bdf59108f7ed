// SPDX-License-Identifier: Apache-2.0
// Office Open XML workbooks (ECMA-376). liborcus 0.17 drops texts that stand in their cells, which is how many programs
// write them, and ends the program on some damaged files.
#include <fmt/format.h>

#include <cmath>
#include <map>

#include "catalogue/workbook_cells.h"
#include "text/number.h"
#include "text/xml.h"

namespace millwright::catalogue {
namespace {

void parse(const std::string& xml, text::XmlListener& listener) {
  if (!xml.empty()) text::read_xml(xml, listener);
}

/// Attributes come before their element.
class Attributes {
 public:
  void add(const text::XmlAttribute& attribute) {
    values_[std::string(attribute.ns.empty() ? "" : std::string(attribute.ns) + ":") + std::string(attribute.name)] =
        std::string(attribute.value);
  }
  std::string get(const std::string& name) const {
    const auto found = values_.find(name);
    return found == values_.end() ? std::string() : found->second;
  }
  /// The first attribute of that local name with any prefix.
  std::string prefixed(const std::string& name) const {
    for (const auto& [key, value] : values_)
      if (key.ends_with(":" + name)) return value;
    return {};
  }
  void clear() { values_.clear(); }

 private:
  std::map<std::string, std::string> values_;
};

/// What several parts have in common: names, and the attributes of the element that begins.
struct Listener : text::XmlListener {
  Attributes attributes;
  void attribute(const text::XmlAttribute& attribute) override { attributes.add(attribute); }
};

struct Sheets : Listener {
  std::vector<std::string> names;
  std::vector<std::string> ids;
  bool from_1904 = false;
  void start_element(const text::XmlElement& element) override {
    if (element.name == "sheet") {
      names.push_back(attributes.get("name"));
      ids.push_back(attributes.prefixed("id"));
    }
    if (element.name == "workbookPr") {
      const std::string flag = attributes.get("date1904");
      from_1904 = flag == "1" || flag == "true";
    }
    attributes.clear();
  }
};

struct Relations : Listener {
  std::map<std::string, std::string> targets;
  std::string shared_strings, styles;
  void start_element(const text::XmlElement& element) override {
    if (element.name == "Relationship") {
      std::string target = attributes.get("Target");
      target = target.starts_with("/") ? target.substr(1) : "xl/" + target;
      const std::string type = attributes.get("Type");
      if (type.ends_with("/sharedStrings")) shared_strings = target;
      if (type.ends_with("/styles")) styles = target;
      targets[attributes.get("Id")] = target;
    }
    attributes.clear();
  }
};

struct SharedStrings : Listener {
  std::vector<std::string> texts;
  bool in_text = false;
  int phonetic = 0;  ///< how a text is pronounced is no part of it
  void start_element(const text::XmlElement& element) override {
    if (element.name == "si") {
      if (texts.size() >= workbook_cell_limit)
        throw WorkbookProblem{fmt::format("has more than {} shared texts", workbook_cell_limit),
                              "save the sheet as CSV (UTF-8) and import that"};
      texts.emplace_back();
    }
    if (element.name == "rPh") ++phonetic;
    in_text = element.name == "t" && phonetic == 0;
    attributes.clear();
  }
  void end_element(const text::XmlElement& element) override {
    if (element.name == "rPh") --phonetic;
    in_text = false;
  }
  void characters(std::string_view text) override {
    if (in_text && !texts.empty()) texts.back() += text;
  }
};

enum class Look { plain, date, percent };

/// Of a format code such as `yyyy-mm-dd`, `0.0%`, `#,##0.00 "pcs"`: texts in quotes and brackets do not count.
Look look_of(std::string_view code) {
  bool quoted = false;
  bool bracketed = false;
  for (std::size_t i = 0; i < code.size(); ++i) {
    const char c = code[i];
    // These take the next character: as it is, as a blank of its width, as a filling.
    if (!quoted && !bracketed && (c == '\\' || c == '_' || c == '*')) {
      ++i;
      continue;
    }
    if (c == '"') quoted = !quoted;
    if (c == '[' && !quoted) bracketed = true;
    if (c == ']' && !quoted) bracketed = false;
    if (quoted || bracketed) continue;
    if (c == ';') break;
    if (c == '%') return Look::percent;
    if (c == 'y' || c == 'd' || c == 'Y' || c == 'D') return Look::date;
  }
  return Look::plain;
}

/// The formats that every workbook knows by number (ECMA-376, 18.8.30).
Look built_in(std::int64_t id) {
  if (id == 9 || id == 10) return Look::percent;
  const bool date = (id >= 14 && id <= 17) || id == 22 || (id >= 27 && id <= 36) || (id >= 50 && id <= 58);
  return date ? Look::date : Look::plain;
}

struct Styles : Listener {
  std::map<std::int64_t, Look> own;
  std::vector<Look> cell_formats;
  bool in_cell_formats = false;
  void start_element(const text::XmlElement& element) override {
    if (element.name == "numFmt")
      own[attribute_number(attributes.get("numFmtId"), -1)] = look_of(attributes.get("formatCode"));
    if (element.name == "cellXfs") in_cell_formats = true;
    if (element.name == "xf" && in_cell_formats) {
      const std::int64_t id = attribute_number(attributes.get("numFmtId"), 0);
      const auto found = own.find(id);
      cell_formats.push_back(found == own.end() ? built_in(id) : found->second);
    }
    attributes.clear();
  }
  void end_element(const text::XmlElement& element) override {
    if (element.name == "cellXfs") in_cell_formats = false;
  }
};

/// A count of days as a date (H. Hinnant, "chrono-compatible low-level date algorithms").
std::string date_text(double serial, bool from_1904) {
  const long z = static_cast<long>(std::floor(serial)) - (from_1904 ? 24107 : 25569) + 719468;
  const long era = (z >= 0 ? z : z - 146096) / 146097;
  const long of_era = z - era * 146097;
  const long year_of_era = (of_era - of_era / 1460 + of_era / 36524 - of_era / 146096) / 365;
  const long of_year = of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
  const long month_index = (5 * of_year + 2) / 153;
  const long day = of_year - (153 * month_index + 2) / 5 + 1;
  const long month = month_index < 10 ? month_index + 3 : month_index - 9;
  std::string text = fmt::format("{:04}-{:02}-{:02}", year_of_era + era * 400 + (month <= 2 ? 1 : 0), month, day);
  const long seconds = std::lround((serial - std::floor(serial)) * 86400.0);
  if (seconds > 0 && seconds < 86400)
    text += fmt::format("T{:02}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
  return text;
}

struct SheetCells : Listener {
  const SharedStrings& strings;
  const Styles& styles;
  bool from_1904;
  WorkbookCells& cells;

  std::int64_t row = -1;
  std::int64_t column = -1;
  std::string type;
  std::string value;
  std::int64_t format = 0;
  bool has_formula = false;
  bool reads = false;
  int phonetic = 0;

  SheetCells(const SharedStrings& texts, const Styles& looks, bool old_calendar, WorkbookCells& target)
      : strings(texts), styles(looks), from_1904(old_calendar), cells(target) {}

  void start_element(const text::XmlElement& element) override {
    if (element.name == "row") {
      row = attribute_number(attributes.get("r"), row + 2) - 1;
      column = -1;
    } else if (element.name == "c") {
      place(attributes.get("r"));
      type = attributes.get("t");
      format = attribute_number(attributes.get("s"), 0);
      value.clear();
      has_formula = false;
    } else if (element.name == "f") {
      has_formula = true;
    } else if (element.name == "rPh") {
      ++phonetic;
    }
    reads = element.name == "v" || (element.name == "t" && phonetic == 0);
    attributes.clear();
  }
  void end_element(const text::XmlElement& element) override {
    reads = false;
    if (element.name == "rPh") --phonetic;
    if (element.name == "c") finish();
  }
  void characters(std::string_view text) override {
    if (reads) value += text;
  }

  /// The column of an address such as C14; without one the next column.
  void place(std::string_view address) {
    std::int64_t named = 0;
    for (const char c : address) {
      if (c < 'A' || c > 'Z' || named > 100000) break;
      named = named * 26 + (c - 'A' + 1);
    }
    column = named > 0 ? named - 1 : column + 1;
  }

  void finish() {
    if (value.empty()) {
      if (has_formula && type != "str")
        throw WorkbookProblem{fmt::format("the formula in row {}, column {} has no stored result", row + 1, column + 1),
                              "open the workbook in a spreadsheet program and save it"};
      return;
    }
    if (type == "s") {
      const std::int64_t index = attribute_number(value, -1);
      if (index < 0 || index >= static_cast<std::int64_t>(strings.texts.size()))
        throw WorkbookProblem{
            fmt::format("the cell in row {}, column {} names a text that is not there", row + 1, column + 1), {}};
      return cells.add_text(row, column, strings.texts[static_cast<std::size_t>(index)]);
    }
    if (type == "e")
      throw WorkbookProblem{
          fmt::format(
              "the cell in row {}, column {} holds the error {}", row + 1, column + 1, text::in_quotes(value, 20)),
          "mend its formula or clear it, and save the workbook"};
    if (type == "b") return cells.add_boolean(row, column, value == "1" || value == "true");
    const std::optional<double> number = type.empty() || type == "n" ? text::parse_number(value) : std::nullopt;
    if (!number) return cells.add_text(row, column, value);
    const Look look = format >= 0 && format < static_cast<std::int64_t>(styles.cell_formats.size())
                          ? styles.cell_formats[static_cast<std::size_t>(format)]
                          : Look::plain;
    if (look == Look::date && *number >= 1.0 && *number < 2958466.0)  // up to the year 9999
      cells.add_text(row, column, date_text(*number, from_1904));
    else
      cells.add_number(row, column, *number, look == Look::percent ? "%" : "");
  }
};

}  // namespace

void read_xlsx(const WorkbookParts& parts, const std::string& wanted, WorkbookSheet& sheet, WorkbookCells& cells) {
  Sheets sheets;
  parse(parts.part("xl/workbook.xml"), sheets);
  Relations relations;
  parse(parts.part("xl/_rels/workbook.xml.rels"), relations);
  sheet.names = sheets.names;
  const std::size_t index = wanted_sheet(wanted, sheet.names);
  sheet.name = sheet.names[index];
  SharedStrings strings;
  if (!relations.shared_strings.empty()) parse(parts.part(relations.shared_strings, false), strings);
  Styles styles;
  if (!relations.styles.empty()) parse(parts.part(relations.styles, false), styles);
  const auto target = relations.targets.find(sheets.ids[index]);
  if (target == relations.targets.end()) throw WorkbookProblem{"does not say where its sheet is", {}};
  SheetCells reader(strings, styles, sheets.from_1904, cells);
  parse(parts.part(target->second), reader);
}

}  // namespace millwright::catalogue
