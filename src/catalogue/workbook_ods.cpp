// SPDX-License-Identifier: Apache-2.0
// OpenDocument spreadsheets (OASIS ODF 1.2). liborcus 0.17 drops repeated rows, percentages, amounts of money and the
// results of text formulas.

#include <fmt/format.h>

#include "catalogue/workbook_cells.h"
#include "text/number.h"
#include "text/xml.h"

namespace millwright::catalogue {
namespace {

/// The content of all sheets; cells are kept of one of them.
struct Content : text::XmlListener {
  WorkbookCells& cells;
  int kept;  ///< index of the sheet, -1: only names are wanted
  std::vector<std::string> names;

  std::int64_t row = 0;
  std::int64_t column = 0;
  bool in_cell = false;
  int paragraphs = 0;
  int annotations = 0;
  int tables = 0;
  std::string text;

  // Attributes of the element that begins.
  std::string table_name, type, value, date, boolean, string_value, currency;
  std::int64_t rows_repeated = 1;
  std::int64_t columns_repeated = 1;
  std::int64_t blanks = 1;
  bool has_formula = false;
  bool has_error = false;
  // Kept until the row, or cell, ends.
  std::int64_t row_count = 1;
  bool row_has_cells = false;

  Content(WorkbookCells& target, int sheet) : cells(target), kept(sheet) {}

  bool wanted() const { return kept >= 0 && static_cast<int>(names.size()) - 1 == kept && tables == 1; }

  void attribute(const text::XmlAttribute& attribute) override {
    if (attribute.ns == "table" && attribute.name == "name") table_name = attribute.value;
    if (attribute.name == "value-type" && attribute.ns == "office") type = attribute.value;
    if (attribute.name == "value-type" && attribute.value == "error") has_error = true;  // calcext, of LibreOffice
    if (attribute.name == "value") value = attribute.value;
    if (attribute.name == "date-value") date = attribute.value;
    if (attribute.name == "boolean-value") boolean = attribute.value;
    if (attribute.name == "string-value") string_value = attribute.value;
    if (attribute.name == "currency") currency = attribute.value;
    if (attribute.name == "formula") has_formula = true;
    if (attribute.name == "number-rows-repeated") rows_repeated = attribute_number(attribute.value, 1);
    if (attribute.name == "number-columns-repeated") columns_repeated = attribute_number(attribute.value, 1);
    if (attribute.name == "c" && attribute.ns == "text") blanks = attribute_number(attribute.value, 1);
  }

  void start_element(const text::XmlElement& element) override {
    if (element.name == "table" && element.ns == "table") {
      if (++tables == 1) names.push_back(table_name);
      row = 0;
    } else if (element.name == "table-row") {
      row_count = rows_repeated;
      row_has_cells = false;
      column = 0;
    } else if (element.name == "table-cell" || element.name == "covered-table-cell") {
      in_cell = true;
      paragraphs = 0;
      text.clear();
      return;  // its attributes are needed when it ends
    } else if (element.name == "annotation") {
      ++annotations;
    } else if (in_cell && annotations == 0) {
      if (element.name == "p" && paragraphs++ > 0) text += ' ';
      if (element.name == "s") text.append(static_cast<std::size_t>(blanks > 0 && blanks < 1000 ? blanks : 1), ' ');
      if (element.name == "tab" || element.name == "line-break") text += ' ';
      blanks = 1;
      return;
    }
    if (!in_cell) forget();
  }

  void end_element(const text::XmlElement& element) override {
    if (element.name == "table" && element.ns == "table") --tables;
    if (element.name == "annotation") --annotations;
    if (element.name == "table-cell" || element.name == "covered-table-cell") {
      if (wanted()) add_cells();
      column += columns_repeated;
      in_cell = false;
      forget();
    }
    if (element.name == "table-row") {
      if (wanted() && row_has_cells && row_count > 1) cells.repeat_last_row(row_count - 1);
      row += row_count;
    }
  }

  void characters(std::string_view characters) override {
    if (in_cell && annotations == 0 && paragraphs > 0) text += characters;
  }

  void add_cells() {
    if (has_error)
      throw WorkbookProblem{
          fmt::format(
              "the cell in row {}, column {} holds the error {}", row + 1, column + 1, text::in_quotes(text, 20)),
          "mend its formula or clear it, and save the workbook"};
    const bool number = type == "float" || type == "percentage" || type == "currency";
    const std::optional<double> parsed = number ? text::parse_number(value) : std::nullopt;
    const std::string words = type == "date" ? date : text.empty() ? string_value : text;
    if (!parsed && type != "boolean" && words.empty()) {
      if (has_formula && type.empty())
        throw WorkbookProblem{"a formula in row " + std::to_string(row + 1) + " has no stored result",
                              "open the workbook in a spreadsheet program and save it"};
      return;
    }
    row_has_cells = true;
    for (std::int64_t i = 0; i < columns_repeated; ++i) {
      if (parsed)
        cells.add_number(row, column + i, *parsed, type == "percentage" ? "%" : currency);
      else if (type == "boolean")
        cells.add_boolean(row, column + i, boolean == "true");
      else
        cells.add_text(row, column + i, words);
    }
  }

  void forget() {
    table_name.clear();
    type.clear();
    value.clear();
    date.clear();
    boolean.clear();
    string_value.clear();
    currency.clear();
    rows_repeated = columns_repeated = blanks = 1;
    has_formula = false;
    has_error = false;
  }
};

}  // namespace

void read_ods(const WorkbookParts& parts, const std::string& wanted, WorkbookSheet& sheet, WorkbookCells& cells) {
  const std::string xml = parts.part("content.xml");
  Content names(cells, -1);
  text::read_xml(xml, names);
  sheet.names = names.names;
  const std::size_t index = wanted_sheet(wanted, sheet.names);
  sheet.name = sheet.names[index];
  Content content(cells, static_cast<int>(index));
  text::read_xml(xml, content);
}

}  // namespace millwright::catalogue
