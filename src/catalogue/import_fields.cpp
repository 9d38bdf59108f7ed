// SPDX-License-Identifier: Apache-2.0
#include "catalogue/import_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "catalogue/column_unit.h"
#include "catalogue/import_companions.h"
#include "catalogue/import_sheet.h"
#include "catalogue/standing.h"
#include "text/characters.h"
#include "text/number.h"

namespace millwright::catalogue {
namespace {

/// Digits with at most one point between them: already a number of ours.
bool is_plain(std::string_view cell) {
  bool point = false;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    if (cell[i] >= '0' && cell[i] <= '9') continue;
    if (cell[i] != '.' || point || i == 0 || i + 1 == cell.size()) return false;
    point = true;
  }
  return !cell.empty() && cell.size() < 40;
}

/// Signs of a diameter before a number.
bool is_diameter_sign(std::string_view before) {
  constexpr std::array<std::string_view, 5> signs = {"\xC3\x98", "\xC3\xB8", "\xE2\x8C\x80", "\xCF\x86", "\xCE\xA6"};
  return std::find(signs.begin(), signs.end(), before) != signs.end();
}

}  // namespace

void append_csv_cell(std::string& line, std::string_view text) {
  const bool special =
      std::any_of(text.begin(), text.end(), [](char c) { return c == ',' || c == '"' || c == '\n' || c == '\r'; });
  const bool quoted = special || (!text.empty() && (text.front() == ' ' || text.back() == ' ' || text.front() == '#'));
  if (!quoted) {
    line += text;
    return;
  }
  line += '"';
  for (const char c : text) {
    if (c == '"') line += '"';
    line += c;
  }
  line += '"';
}

ImportFields::ImportFields(const ImportMapping& mapping, text::Diagnostics& diagnostics)
    : mapping_(mapping), diagnostics_(diagnostics), units_(mapping.columns.size()) {
  for (std::size_t index = 0; index < column_count(mapping.family); ++index)
    add(Column{mapping.family, static_cast<std::uint8_t>(index)});
  for (std::size_t i = 0; i < mapping.columns.size(); ++i) {
    const SourceColumn& column = mapping.columns[i];
    if (column.target) continue;
    const auto is = [&](CompanionKind kind) { return column.companion && column.companion->kind == kind; };
    fields_.push_back({is(CompanionKind::tolerance)    ? ImportField::Kind::tolerance
                       : is(CompanionKind::confidence) ? ImportField::Kind::confidence
                                                       : ImportField::Kind::kept,
                       column.unit.empty() ? column.kept_name : fmt::format("{} [{}]", column.kept_name, column.unit),
                       i,
                       {},
                       {}});
  }
}

void ImportFields::add(Column target) {
  const ColumnDeclaration& declared = declaration(target);
  ImportField field;
  const auto source = std::find_if(
      mapping_.columns.begin(), mapping_.columns.end(), [&](const auto& each) { return each.target == target; });
  const auto constant = std::find_if(
      mapping_.constants.begin(), mapping_.constants.end(), [&](const auto& each) { return each.first == target; });
  field.header = std::string(declared.name);
  if (source != mapping_.columns.end()) {
    field.source = static_cast<std::size_t>(source - mapping_.columns.begin());
    field.kind = declared.kind == Kind::number   ? ImportField::Kind::number
                 : declared.kind == Kind::money  ? ImportField::Kind::money
                 : declared.kind == Kind::flag   ? ImportField::Kind::flag
                 : declared.name == "frame"      ? ImportField::Kind::frame
                 : declared.name == "confidence" ? ImportField::Kind::confidence
                                                 : ImportField::Kind::text;
    field.out_unit = source->converts || source->unit.empty() ? std::string(declared.unit) : source->unit;
  } else if (constant != mapping_.constants.end()) {
    field.kind = ImportField::Kind::constant;
    field.constant = constant->second;
    field.out_unit = std::string(declared.unit);
  }
  if (declared.name == "currency") {
    const bool in_prices = std::any_of(mapping_.columns.begin(), mapping_.columns.end(), [](const SourceColumn& each) {
      return each.target && declaration(*each.target).kind == Kind::money &&
             (!each.currency.empty() || !each.cell_units.empty());
    });
    if (!field.source && constant == mapping_.constants.end() && !in_prices) return;
    field.kind = ImportField::Kind::currency;
  } else if (!field.source && constant == mapping_.constants.end()) {
    return;
  }
  if (is_number_column(target) && !field.out_unit.empty()) field.header += " [" + field.out_unit + "]";
  fields_.push_back(std::move(field));
}

std::string ImportFields::header_line() const {
  std::string line;
  for (const ImportField& field : fields_) {
    if (!line.empty()) line += ',';
    append_csv_cell(line, field.header);
  }
  return line + "\n";
}

void ImportFields::refuse(const SheetRows& row,
                          std::size_t source,
                          const std::string& message,
                          const std::string& hint) {
  row_is_good_ = false;
  const std::string name = mapping_.columns[source].target
                               ? std::string(declaration(*mapping_.columns[source].target).name)
                               : mapping_.columns[source].kept_name;
  diagnostics_.error(row.span(source), name + ": " + message, hint);
}

bool ImportFields::append(const SheetRows& row, std::string& lines) {
  const std::size_t before = lines.size();
  row_is_good_ = true;
  row_currency_.clear();
  // Prices say the currency, which stands behind them: the order of the columns is that of their declaration.
  bool first = true;
  for (const ImportField& field : fields_) {
    if (!first) lines += ',';
    first = false;
    const std::string_view cell = field.source ? row.cell(*field.source) : std::string_view();
    if (cell.size() > longest_cell) {
      refuse(row, *field.source, fmt::format("a cell of {} bytes", cell.size()), "is a quote missing somewhere?");
      continue;
    }
    switch (field.kind) {
      case ImportField::Kind::constant:
        append_csv_cell(lines, field.constant);
        break;
      case ImportField::Kind::text:
      case ImportField::Kind::kept:
        append_csv_cell(lines, cell);
        break;
      case ImportField::Kind::frame:
        append_frame(cell, lines);
        break;
      case ImportField::Kind::number:
      case ImportField::Kind::money:
        append_number(row, field, lines);
        break;
      case ImportField::Kind::tolerance:
        append_tolerance(row, field, lines);
        break;
      case ImportField::Kind::flag:
        append_flag(row, field, lines);
        break;
      case ImportField::Kind::confidence:
        append_confidence(row, field, lines);
        break;
      case ImportField::Kind::currency:
        append_csv_cell(lines, currency_of_row(row, field));
        break;
    }
  }
  for (std::size_t i = mapping_.columns.size(); i < row.cells(); ++i) {
    if (row.cell(i).empty()) continue;
    row_is_good_ = false;
    diagnostics_.error(row.span(i),
                       fmt::format("a cell beyond the {} columns of the header", mapping_.columns.size()),
                       "is a separator inside an unquoted text? or does a column lack its header?");
    break;
  }
  lines += '\n';
  if (!row_is_good_) lines.resize(before);
  return row_is_good_;
}

const ImportFields::KnownUnit& ImportFields::unit_of(const std::string& words, std::size_t source) {
  std::vector<KnownUnit>& known = units_[source];
  for (const KnownUnit& each : known)
    if (each.words == words) return each;
  constexpr std::size_t most_known = 64;
  if (known.size() >= most_known) known.clear();
  KnownUnit unit;
  unit.words = words;
  unit.unit = shop_unit(words, *mapping_.columns[source].target, unit.reason);
  known.push_back(std::move(unit));
  return known.back();
}

/// With a decimal point; empty, and reported, if it is none.
std::string ImportFields::read_plain(const SheetRows& row,
                                     std::size_t source,
                                     std::string_view number,
                                     DecimalMark mark) {
  if (number.empty()) {
    const std::string_view cell = row.cell(source);
    refuse(row, source, fmt::format("not a number: {}", text::in_quotes(cell)), text::number_hint(cell));
    return {};
  }
  std::string plain = plain_number(number, mark);
  if (plain.empty())
    refuse(row,
           source,
           fmt::format("{} is no number with a decimal {}",
                       text::in_quotes(number),
                       mark == DecimalMark::comma ? "comma" : "point"),
           number.size() > 400 ? fmt::format("{} characters are no number", number.size()) : "");
  return plain;
}

/// The unit of a column, of a figure that says none: of a price 1/m, which shop_unit() takes only with a currency.
bool ImportFields::take_own_unit(const SheetRows& row, std::size_t source, scalar::Unit& meaning) {
  const std::string& unit = mapping_.columns[source].unit;
  if (unit.empty()) return true;
  std::string reason;
  const auto own = scalar::Unit::parse(unit, reason);
  if (own)
    meaning = *own;
  else
    refuse(row, source, reason);
  return own.has_value();
}

void ImportFields::append_number(const SheetRows& row, const ImportField& field, std::string& line) {
  const std::size_t source = *field.source;
  const std::string_view cell = row.cell(source);
  const SourceColumn& column = mapping_.columns[source];
  const bool money = field.kind == ImportField::Kind::money;
  if (cell.empty()) return;
  const DecimalMark mark = row.is_number(source) ? DecimalMark::point : column.mark;
  const bool price_of_piece = money && declaration(*column.target).unit.empty();
  const bool bare_is_known = price_of_piece ||
                             (column.unit_origin != UnitOrigin::none && column.unit_origin != UnitOrigin::cells) ||
                             declaration(*column.target).unit == "1";
  if (mark == DecimalMark::point && !column.converts && bare_is_known && is_plain(cell)) {
    line += cell;
    take_currency(row, field, column.currency);
    return;
  }
  if (says_unknown(cell)) return;
  const CellParts parts = cut_cell(cell);
  const std::string plain = read_plain(row, source, parts.number, mark);
  if (plain.empty()) return;
  std::string words =
      std::string(is_diameter_sign(parts.before) ? std::string_view() : parts.before) + std::string(parts.after);
  if (words.empty()) {
    if (!bare_is_known)
      return refuse(row,
                    source,
                    "a figure without a unit; others of its column have one",
                    fmt::format("say --unit {}=UNIT for those that have none", declaration(*column.target).name));
    take_currency(row, field, column.currency);
    if (!column.converts) {
      line += plain;
      return;
    }
    if (!money) words = column.unit;
  }
  scalar::Unit meaning;
  if (words.empty() && !take_own_unit(row, source, meaning)) return;
  if (!words.empty()) {
    const KnownUnit& known = unit_of(words, source);
    if (!known.unit) return refuse(row, source, fmt::format("{}: {}", text::in_quotes(words), known.reason));
    take_currency(row, field, known.unit->currency);
    if (known.unit->unit == field.out_unit || (known.unit->unit.empty() && field.out_unit == "1")) {
      line += plain;
      return;
    }
    meaning = known.unit->meaning;
  }
  std::string reason;
  const auto out = scalar::Unit::parse(field.out_unit, reason);
  const auto value = text::parse_number(plain);
  if (!out || !value) return refuse(row, source, reason);
  line += fmt::format("{:.12g}", out->from_si(meaning.to_si(*value)));
}

void ImportFields::append_tolerance(const SheetRows& row, const ImportField& field, std::string& line) {
  const SourceColumn& column = mapping_.columns[*field.source];
  const auto figure = std::find_if(mapping_.columns.begin(), mapping_.columns.end(), [&](const SourceColumn& each) {
    return each.target == column.companion->figure;
  });
  const DecimalMark usual =
      row.is_number(*field.source) || figure == mapping_.columns.end() ? DecimalMark::point : figure->mark;
  std::string reason;
  if (const auto cell = tolerance_cell(row.cell(*field.source), column, usual, reason))
    append_csv_cell(line, *cell);
  else
    refuse(
        row, *field.source, reason, "5 %, or a width with its unit; without its column in a mapping file it is kept");
}

void ImportFields::append_flag(const SheetRows& row, const ImportField& field, std::string& line) {
  const std::string_view cell = row.cell(*field.source);
  if (cell.empty() || says_unknown(cell)) return;
  const std::string word = text::lower_case(cell.substr(0, 8));
  constexpr std::array<std::string_view, 7> yes = {"yes", "true", "1", "y", "x", "ja", "ya"};
  constexpr std::array<std::string_view, 6> no = {"no", "false", "0", "n", "nein", "tidak"};
  if (std::find(yes.begin(), yes.end(), word) != yes.end())
    line += "yes";
  else if (std::find(no.begin(), no.end(), word) != no.end())
    line += "no";
  else
    refuse(row, *field.source, fmt::format("{} is neither yes nor no", text::in_quotes(cell)));
}

/// Words of the closed list, also in German and Indonesian.
void ImportFields::append_confidence(const SheetRows& row, const ImportField& field, std::string& line) {
  const std::string_view cell = row.cell(*field.source);
  if (cell.empty() || says_unknown(cell)) return;
  if (const auto word = confidence_word(cell)) {
    line += *word;
    return;
  }
  constexpr std::array<std::pair<std::string_view, std::string_view>, 8> others = {{{"hoch", "high"},
                                                                                    {"mittel", "medium"},
                                                                                    {"niedrig", "low"},
                                                                                    {"gering", "low"},
                                                                                    {"tinggi", "high"},
                                                                                    {"sedang", "medium"},
                                                                                    {"menengah", "medium"},
                                                                                    {"rendah", "low"}}};
  const std::string said = text::lower_case(cell.substr(0, 16));
  for (const auto& [word, ours] : others)
    if (said == word && cell.size() == word.size()) {
      line += ours;
      return;
    }
  refuse(row,
         *field.source,
         fmt::format("{} is no confidence", text::in_quotes(cell)),
         confidence_hint(cell) + "; without its column in a mapping file it is kept");
}

/// "NEMA 23" and "Nema-23" are NEMA23; everything else stays.
void ImportFields::append_frame(std::string_view cell, std::string& line) {
  std::string letters;
  std::string digits;
  for (const char c : cell.substr(0, 12)) {
    if (c >= '0' && c <= '9')
      digits += c;
    else if (c != ' ' && c != '-' && c != '_')
      letters += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  if (letters == "NEMA" && digits.size() == 2 && cell.size() <= 12)
    line += letters + digits;
  else
    append_csv_cell(line, cell);
}

void ImportFields::take_currency(const SheetRows& row, const ImportField& field, const std::string& currency) {
  if (currency.empty() || field.kind != ImportField::Kind::money) return;
  if (row_currency_.empty() || row_currency_ == "?") row_currency_ = currency;
  if (currency != "?" && row_currency_ != currency)
    refuse(row, *field.source, fmt::format("{}, but the row's other price is in {}", currency, row_currency_));
}

std::string ImportFields::currency_of_row(const SheetRows& row, const ImportField& field) {
  std::string said = field.constant;
  if (field.source) {
    const std::string_view cell = row.cell(*field.source);
    said = currency_of(cell);
    if (said.empty() || said == "?") said = std::string(cell);
  } else if (const auto constant =
                 std::find_if(mapping_.constants.begin(),
                              mapping_.constants.end(),
                              [](const auto& each) { return declaration(each.first).name == "currency"; });
             constant != mapping_.constants.end()) {
    said = constant->second;
    const auto beside = column_beside_constant(mapping_, constant->first);
    const std::string other = beside ? currency_of(row.cell(*beside)) : std::string();
    if (!other.empty() && other != "?" && !said.empty() && other != said)
      refuse(row,
             *beside,
             fmt::format("{}, but the currency is said to be {} for all rows", other, said),
             "leave the constant out: the table has the currency of each row");
  }
  const auto price = std::find_if(mapping_.columns.begin(), mapping_.columns.end(), [](const SourceColumn& each) {
    return each.target && declaration(*each.target).kind == Kind::money;
  });
  const auto at = static_cast<std::size_t>(price - mapping_.columns.begin());
  if (said.empty() && row_currency_ == "?") {
    refuse(row, at, "the sign stands for several currencies", "say which: --constant currency=USD");
  } else if (!said.empty() && !row_currency_.empty() && row_currency_ != "?" && said != row_currency_) {
    refuse(row, at, fmt::format("the price is in {}, but the currency is said to be {}", row_currency_, said));
  }
  if (!said.empty()) return said;
  return row_currency_.empty() ? currency_without_price(row, mapping_) : row_currency_;
}

}  // namespace millwright::catalogue
