// SPDX-License-Identifier: Apache-2.0
#include "catalogue/import_mapping_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "catalogue/column_unit.h"
#include "catalogue/header.h"
#include "catalogue/import_companions.h"
#include "catalogue/import_unit.h"
#include "catalogue/standing.h"
#include "text/document.h"
#include "text/nearest.h"
#include "text/number.h"
#include "text/table_reader.h"

namespace millwright::catalogue {
namespace {

std::optional<Column> column_named(Family family,
                                   std::string_view name,
                                   const text::SourceSpan& where,
                                   text::Diagnostics& diagnostics) {
  if (const auto found = find_column(family, name)) return found;
  std::vector<std::string_view> names;
  for (std::size_t index = 0; index < column_count(family); ++index)
    names.push_back(declaration(Column{family, static_cast<std::uint8_t>(index)}).name);
  diagnostics.error(where,
                    fmt::format("{} have no column {}", declaration(family).name, text::in_quotes(name)),
                    text::did_you_mean(name, names, "its columns: 'millwright catalogue show' of any part names them"));
  return std::nullopt;
}

/// A unit as it may be said for a column; reports one that does not fit.
bool check_unit(Column column, std::string_view unit, const text::SourceSpan& where, text::Diagnostics& diagnostics) {
  std::string reason;
  if (!is_number_column(column)) {
    diagnostics.error(where, fmt::format("{} is no number and has no unit", declaration(column).name));
    return false;
  }
  if (shop_unit(unit, column, reason)) return true;
  diagnostics.error(where,
                    fmt::format("{}: {}", declaration(column).name, reason),
                    fmt::format("for example {}", header_cell(column)));
  return false;
}

/// A constant as our file holds it; reports one that is none.
std::optional<std::string> constant_of(Column column,
                                       std::string_view value,
                                       const text::SourceSpan& where,
                                       text::Diagnostics& diagnostics) {
  const ColumnDeclaration& declared = declaration(column);
  if (declared.name == "confidence" && !value.empty()) {
    if (const auto word = confidence_word(value)) return std::string(*word);
    diagnostics.error(
        where, fmt::format("{}: {} is no confidence", declared.name, text::in_quotes(value)), confidence_hint(value));
    return std::nullopt;
  }
  if (value.empty() || !is_number_column(column)) return std::string(value);
  if (declared.kind == Kind::money || declared.unit == "1") {
    if (text::parse_number(value)) return std::string(value);
    diagnostics.error(
        where, fmt::format("{}: not a number: {}", declared.name, text::in_quotes(value)), text::number_hint(value));
    return std::nullopt;
  }
  std::string reason;
  if (const auto quantity = scalar::parse_quantity(value, display_unit(column), reason))
    return fmt::format("{:.12g}", display_unit(column).from_si(quantity->si));
  diagnostics.error(where, fmt::format("{}: {}", declared.name, reason));
  return std::nullopt;
}

std::optional<DecimalMark> mark_of(const std::optional<std::string>& word) {
  if (!word) return std::nullopt;
  return *word == "comma" ? DecimalMark::comma : DecimalMark::point;
}

class MappingFile {
 public:
  MappingFile(const text::Node& root, ImportRequest& request, text::Diagnostics& diagnostics)
      : top_(root, "the mapping", diagnostics),
        request_(request),
        diagnostics_(diagnostics),
        typed_constants_(request.choices.constants) {}

  void read() {
    if (const auto name = top_.string({"family", "part family of the table"})) {
      const auto family = family_named(*name, top_.node().find("family")->span(), diagnostics_);
      if (family && request_.family && *request_.family != *family)
        diagnostics_.error(
            top_.node().find("family")->span(),
            fmt::format("the mapping is for {}, but --family says {}", *name, declaration(*request_.family).name));
      if (!request_.family) request_.family = family;
    } else if (!request_.family && !top_.node().find("family")) {
      diagnostics_.error(
          top_.node().span(), "the mapping does not say which family it is for", "family = \"steppers\"");
    }
    read_format();
    const text::Node* constants = top_.table({"constants", "values of columns that the table does not have"});
    const text::Node* columns =
        top_.table({"columns", "which column of the table is which of ours"}, text::Presence::required);
    top_.finish();
    if (!request_.family) return;
    if (constants) read_constants(*constants);
    if (columns) read_columns(*columns);
  }

 private:
  void read_format() {
    SheetFormat& format = request_.format;
    if (const auto sheet = top_.string({"sheet", "of a workbook"}); sheet && format.sheet.empty())
      format.sheet = *sheet;
    const auto encoding = top_.word({"encoding", "of a text"}, {"utf-8", "utf-16", "windows-1252"});
    if (encoding && format.encoding.empty()) format.encoding = *encoding;
    const auto separator = top_.word({"separator", "between the cells"}, {",", ";", "\t"});
    if (separator && format.separator == 0) format.separator = separator->front();
    const auto mark = mark_of(top_.word({"decimal", "decimal mark of all columns"}, {"point", "comma"}));
    if (mark && request_.choices.mark == DecimalMark::unknown) request_.choices.mark = *mark;
  }

  void read_constants(const text::Node& table) {
    for (const text::TableEntry& entry : table.entries()) {
      const auto column = column_named(*request_.family, entry.key, entry.key_span, diagnostics_);
      if (!column || names(typed_constants_, *column)) continue;
      for (const GivenColumn& typed : request_.choices.columns)
        if (typed.target == *column)
          diagnostics_.error(typed.where,
                             fmt::format("the mapping file has {} as a constant, which has its own unit", entry.key),
                             fmt::format("say --constant {}='VALUE UNIT' instead, or mend the file", entry.key));
      std::optional<std::string> value = entry.value.as_string();
      if (!value && entry.value.as_date()) value = entry.value.as_date();
      if (!value && entry.value.as_number()) value = fmt::format("{}", *entry.value.as_number());
      if (!value) {
        text::report_kind(entry.value, "a constant", text::NodeKind::string, diagnostics_);
        continue;
      }
      if (const auto constant = constant_of(*column, *value, entry.value.span(), diagnostics_))
        request_.choices.constants.emplace_back(*column, *constant);
    }
  }

  static bool names(const std::vector<std::pair<Column, std::string>>& constants, Column column) {
    return std::any_of(constants.begin(), constants.end(), [&](const auto& each) { return each.first == column; });
  }

  void read_columns(const text::Node& table) {
    request_.choices.complete = true;
    for (const text::TableEntry& entry : table.entries()) {
      if (const auto companion = companion_named(entry.key, *request_.family)) {
        read_companion(entry, *companion);
        continue;
      }
      const auto column = column_named(*request_.family, entry.key, entry.key_span, diagnostics_);
      if (!column) continue;
      text::TableReader reader(entry.value, fmt::format("columns.{}", entry.key), diagnostics_);
      GivenColumn given;
      given.target = *column;
      given.where = entry.value.span();
      const auto from =
          reader.string({"from", "its header in the table, as it is written there"}, text::Presence::required);
      const auto occurrence = reader.integer({"occurrence", "if several columns have that header: 1, 2, ..."});
      const auto unit = reader.string({"unit", "of figures without a unit of their own"});
      const auto mark = mark_of(reader.word({"decimal", "decimal mark"}, {"point", "comma"}));
      reader.finish();
      if (unit && !check_unit(*column, *unit, entry.value.find("unit")->span(), diagnostics_)) continue;
      if (occurrence && (*occurrence < 1 || *occurrence > 1024)) {
        diagnostics_.error(entry.value.find("occurrence")->span(), "occurrences count from 1");
        continue;
      }
      if (!from) continue;
      if (const text::Node* place = entry.value.find("from")) given.where = place->span();
      given.from = *from;
      given.unit = unit;
      given.occurrence = static_cast<int>(occurrence.value_or(1));
      given.mark = mark.value_or(DecimalMark::unknown);
      if (names(typed_constants_, *column)) continue;  // the command line goes before
      if (names(request_.choices.constants, *column)) {
        diagnostics_.error(entry.key_span,
                           fmt::format("{} is among the constants and among the columns", entry.key),
                           "leave it out of one of them");
        continue;
      }
      merge(std::move(given));
    }
    for (const GivenColumn& typed : request_.choices.columns)
      if (typed.from.empty() && !names(request_.choices.constants, typed.target))
        diagnostics_.error(typed.where,
                           fmt::format("the mapping file has no column {}", declaration(typed.target).name),
                           "a unit is said of figures that the file names");
  }

  void read_companion(const text::TableEntry& entry, const ImportCompanion& companion) {
    text::TableReader reader(entry.value, fmt::format("columns.{}", entry.key), diagnostics_);
    GivenCompanion given;
    given.companion = companion;
    const auto from =
        reader.string({"from", "its header in the table, as it is written there"}, text::Presence::required);
    const auto occurrence = reader.integer({"occurrence", "if several columns have that header: 1, 2, ..."});
    const auto unit = reader.string({"unit", "of tolerances without a unit of their own"});
    reader.finish();
    if (!from) return;
    given.where = entry.value.find("from")->span();
    given.from = *from;
    if (occurrence && (*occurrence < 1 || *occurrence > 1024))
      diagnostics_.error(entry.value.find("occurrence")->span(), "occurrences count from 1");
    given.occurrence = static_cast<int>(occurrence.value_or(1));
    std::string reason;
    if (unit && companion.kind == CompanionKind::tolerance) {
      given.unit = tolerance_unit(*unit, companion.figure, reason);
      if (!given.unit)
        diagnostics_.error(entry.value.find("unit")->span(), fmt::format("{}: {}", entry.key, reason), "for example %");
    } else if (unit) {
      diagnostics_.error(entry.value.find("unit")->span(), fmt::format("{} is a text and has no unit", entry.key));
    }
    request_.choices.companions.push_back(std::move(given));
  }

  /// A unit from the command line goes before that of the file.
  void merge(GivenColumn given) {
    for (GivenColumn& each : request_.choices.columns) {
      if (each.target != given.target) continue;
      if (each.unit) given.unit = each.unit;
      each = std::move(given);
      return;
    }
    request_.choices.columns.push_back(std::move(given));
  }

  text::TableReader top_;
  ImportRequest& request_;
  text::Diagnostics& diagnostics_;
  const std::vector<std::pair<Column, std::string>> typed_constants_;  ///< on the command line
};

/// A column that the command line speaks of for the second time; reports it.
bool is_said_twice(const ImportRequest& request,
                   Column column,
                   const text::SourceSpan& where,
                   text::Diagnostics& diagnostics) {
  const auto& choices = request.choices;
  const bool constant = std::any_of(
      choices.constants.begin(), choices.constants.end(), [&](const auto& each) { return each.first == column; });
  const bool unit = std::any_of(
      choices.columns.begin(), choices.columns.end(), [&](const auto& each) { return each.target == column; });
  if (constant || unit)
    diagnostics.error(
        where,
        fmt::format(
            "{} is named twice: its {} is said already", declaration(column).name, constant ? "constant" : "unit"),
        "say it once; a constant has its own unit: --constant mass='3 kg'");
  return constant || unit;
}

/// A TOML basic string.
std::string toml_string(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    if (static_cast<unsigned char>(c) < 0x20)
      result += fmt::format("\\u{:04X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    else
      result += c;
  }
  return result + "\"";
}

std::string unit_said(const SourceColumn& column) {
  if (column.target && declaration(*column.target).kind == Kind::money && !column.currency.empty()) {
    const std::string currency = column.currency == "?" ? "$" : column.currency;
    return column.unit.size() > 2 ? currency + column.unit.substr(1) : currency;  // 1/m becomes EUR/m
  }
  return column.unit;
}

}  // namespace

std::optional<Family> family_named(std::string_view name,
                                   const text::SourceSpan& where,
                                   text::Diagnostics& diagnostics) {
  if (const auto family = find_family(name)) return family;
  std::vector<std::string_view> names;
  for (const FamilyDeclaration& each : families) names.push_back(each.name);
  diagnostics.error(where,
                    "there is no part family " + text::in_quotes(name),
                    text::did_you_mean(name, names, fmt::format("families: {}", fmt::join(names, ", "))));
  return std::nullopt;
}

void read_mapping(const std::string& path, ImportRequest& request, text::Diagnostics& diagnostics) {
  const auto text = text::SourceText::load(path, diagnostics, std::uintmax_t{4} << 20U);
  if (!text) return;
  const auto document = text::read_toml(text, diagnostics);
  if (document) MappingFile(document->root(), request, diagnostics).read();
}

void add_constant(ImportRequest& request,
                  std::string_view name,
                  std::string_view value,
                  const text::SourceSpan& where,
                  text::Diagnostics& diagnostics) {
  const auto column = column_named(*request.family, name, where, diagnostics);
  if (!column || is_said_twice(request, *column, where, diagnostics)) return;
  if (const auto constant = constant_of(*column, value, where, diagnostics))
    request.choices.constants.emplace_back(*column, *constant);
}

void add_unit(ImportRequest& request,
              std::string_view name,
              std::string_view unit,
              const text::SourceSpan& where,
              text::Diagnostics& diagnostics) {
  const auto column = column_named(*request.family, name, where, diagnostics);
  if (!column || !check_unit(*column, unit, where, diagnostics)) return;
  if (is_said_twice(request, *column, where, diagnostics)) return;
  GivenColumn given;
  given.target = *column;
  given.unit = std::string(unit);
  given.where = where;
  request.choices.columns.push_back(std::move(given));
}

std::string mapping_text(const ImportMapping& mapping, const ImportRequest& request, bool confirmed) {
  std::string text =
      "# How a table becomes ours: millwright catalogue import TABLE --mapping THIS_FILE --output FILE\n";
  text += fmt::format("family = {}\n", toml_string(declaration(mapping.family).name));
  if (!request.format.sheet.empty()) text += fmt::format("sheet = {}\n", toml_string(request.format.sheet));
  if (!request.format.encoding.empty()) text += fmt::format("encoding = {}\n", toml_string(request.format.encoding));
  if (request.format.separator != 0)
    text += fmt::format("separator = {}\n", toml_string(std::string(1, request.format.separator)));
  if (request.choices.mark != DecimalMark::unknown)
    text += fmt::format("decimal = \"{}\"\n", request.choices.mark == DecimalMark::comma ? "comma" : "point");
  if (!request.choices.constants.empty()) {
    text += "\n[constants]\n";
    for (const auto& [column, value] : request.choices.constants) {
      const ColumnDeclaration& declared = declaration(column);
      const bool quantity = declared.kind == Kind::number && declared.unit != "1" && !value.empty();
      text += fmt::format(
          "{} = {}\n", declared.name, toml_string(quantity ? fmt::format("{} {}", value, declared.unit) : value));
    }
  }
  text += "\n[columns]\n";
  std::string kept;
  for (const SourceColumn& column : mapping.columns) {
    if (!column.target && !column.companion) {
      kept += fmt::format("# {}: kept as {}\n", text::printable(toml_string(column.header)), column.kept_name);
      continue;
    }
    text += fmt::format("{} = {{ from = {}",
                        column.target ? declaration(*column.target).name : std::string_view(column.kept_name),
                        toml_string(column.header));
    if (column.occurrence > 1) text += fmt::format(", occurrence = {}", column.occurrence);
    const bool open = column.unit_origin == UnitOrigin::assumed && !confirmed;
    const std::string unit = unit_said(column);
    const bool known = column.unit_origin != UnitOrigin::none && column.unit_origin != UnitOrigin::cells;
    if (known && !open && !unit.empty()) text += fmt::format(", unit = {}", toml_string(unit));
    if (column.mark == DecimalMark::comma) text += ", decimal = \"comma\"";
    text += open ? fmt::format(" }}  # unit = {}? nothing says it\n", toml_string(unit)) : std::string(" }\n");
  }
  return text + kept;
}

}  // namespace millwright::catalogue
