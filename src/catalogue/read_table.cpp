// SPDX-License-Identifier: Apache-2.0
#include "catalogue/read_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "catalogue/column_unit.h"
#include "catalogue/gathered_columns.h"
#include "catalogue/header.h"
#include "catalogue/standing.h"
#include "catalogue/stock.h"
#include "text/csv_reader.h"

namespace millwright::catalogue {
namespace {

/// One file on its way into a table, some rows at a time. Members are of those rows, but where they say so; numbers of
/// rows count from the first of them.
class TableFileReader {
 public:
  /// The table has room for so many rows.
  TableFileReader(const text::CsvReader& reader,
                  Family family,
                  const Header& header,
                  text::Diagnostics& diagnostics,
                  std::size_t room)
      : csv_(reader.table()),
        family_(family),
        header_(header),
        diagnostics_(diagnostics),
        all_(column_count(family), room) {
    columns_.numbers.resize(column_count(family));
    columns_.texts.resize(column_count(family));
    columns_.tolerances.resize(column_count(family));
    columns_.sources.resize(column_count(family));
    columns_.confidences.resize(column_count(family));
    columns_.file.text = csv_.text();
    columns_.file.separator = csv_.separator();
    columns_.file.field_of_column = header_.field_of_column;
    for (const Companion& each : header_.companions)
      columns_.file.companions.push_back({each.figure.index, each.kind, static_cast<int>(each.field)});
    for (std::size_t index = 0; index < column_count(family); ++index) {
      const Kind kind = declaration(at(index)).kind;
      if (field(at(index)) < 0 || (kind != Kind::number && kind != Kind::money)) continue;
      numbers_.push_back({cell_column(at(index)), {}, {}, {}});
      numbers_of_.push_back(at(index));
    }
  }

  /// Reads the rows that the CSV reader holds now.
  void read() {
    keep_.assign(csv_.row_count(), true);
    read_numbers();
    read_texts();
    for (std::size_t index = 0; index < column_count(family_); ++index) {
      const Column each = at(index);
      if (field(each) < 0) continue;
      const Kind kind = declaration(each).kind;
      if (kind == Kind::flag) read_flags(each);
      if (kind == Kind::number || kind == Kind::money) check_numbers(each);
      if (declaration(each).need == Need::required) check_required(each);
    }
    check_prices();
    const Column confidence = column(family_, "confidence");
    if (field(confidence) >= 0) check_confidences(columns_.texts[confidence.index], cell_column(confidence));
    read_companions();
    columns_.file.unescaped = unescaped_;
    columns_.offsets.clear();
    for (std::size_t row = 0; row < csv_.row_count(); ++row)
      columns_.offsets.push_back(static_cast<std::uint32_t>(csv_.record_offset(row)));
    all_.add(columns_);
    keep_all_.insert(keep_all_.end(), keep_.begin(), keep_.end());
  }

  /// All rows that were read.
  Table table(int layer) {
    TableColumns all = all_.take();
    all.file.layer = layer;
    Table table(family_, std::move(all));
    if (std::find(keep_all_.begin(), keep_all_.end(), false) != keep_all_.end()) table.keep_only(keep_all_);
    return table;
  }

 private:
  Column at(std::size_t index) const { return Column{family_, static_cast<std::uint8_t>(index)}; }
  int field(Column column) const { return header_.field_of_column[column.index]; }
  std::size_t cell_column(Column column) const { return static_cast<std::size_t>(field(column)); }

  void refuse(std::size_t row, Column column, const std::string& message, const std::string& hint) {
    refuse_cell(row, cell_column(column), message, hint);
  }

  void refuse_cell(std::size_t row, std::size_t field, const std::string& message, const std::string& hint) {
    keep_[row] = false;
    if (diagnostics_.is_full(csv_.text().get())) {
      diagnostics_.error(text::whole(csv_.text()), message);  // counted, not kept: no place has to be worked out
    } else {
      diagnostics_.error(csv_.cell_span(row, field), message, hint);
    }
  }

  void read_numbers() {
    for (text::NumberColumn& each : numbers_) each.values.clear();
    csv_.read_numbers(numbers_, diagnostics_);
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
      std::vector<double>& values = columns_.numbers[numbers_of_[i].index];
      values.swap(numbers_[i].values);
      header_.units[numbers_of_[i].index]->to_si(values);
    }
  }

  /// Refuses what no part can have: negative figures, and zero where zero makes no sense. What was no number was
  /// reported by the CSV reader; its row goes too.
  void check_numbers(Column column) {
    const ColumnDeclaration& declared = declaration(column);
    const bool signed_scale = display_unit(column).kind() == scalar::UnitKind::temperature;
    const std::vector<double>& values = columns_.numbers[column.index];
    for (std::size_t row = 0; row < values.size(); ++row) {
      const double value = values[row];
      if (value > 0.0) continue;
      if (std::isnan(value)) {
        if (!csv_.is_empty(row, cell_column(column))) keep_[row] = false;
      } else if (signed_scale || declared.lower < 0.0) {
        continue;
      } else if (value < 0.0) {
        refuse(row, column, fmt::format("{} is negative", declared.name), "leave the cell empty if it is not known");
      } else if (declared.lower > 0.0) {
        refuse(row, column, fmt::format("{} is zero", declared.name), "leave the cell empty if it is not known");
      }
    }
  }

  void check_required(Column column) {
    const ColumnDeclaration& declared = declaration(column);
    for (std::size_t row = 0; row < csv_.row_count(); ++row) {
      const bool is_text = declared.kind == Kind::text;
      if (is_text ? columns_.texts[column.index][row].length > 0 : !std::isnan(columns_.numbers[column.index][row]))
        continue;
      if (!csv_.is_empty(row, cell_column(column))) continue;
      refuse(
          row,
          column,
          fmt::format("{} is missing", declared.name),
          declared.name == "manufacturer" ? "write generic if the maker is not named" : std::string(declared.meaning));
    }
  }

  /// All texts, record by record: a column at a time would go through the whole file for each.
  void read_texts() {
    struct Wanted {
      std::size_t field;
      std::vector<TextCell>* cells;
    };
    std::vector<Wanted> wanted;
    for (std::size_t index = 0; index < column_count(family_); ++index) {
      if (field(at(index)) < 0 || declaration(at(index)).kind != Kind::text) continue;
      columns_.texts[index].resize(csv_.row_count());
      wanted.push_back({cell_column(at(index)), &columns_.texts[index]});
    }
    for (std::size_t row = 0; row < csv_.row_count(); ++row) {
      for (const Wanted& each : wanted) (*each.cells)[row] = text_cell(csv_.cell(row, each.field));
    }
  }

  TextCell text_cell(std::string_view content) {
    if (content.empty()) return {};
    const std::string_view all = csv_.text()->contents();
    const std::less<const char*> before;
    if (!before(content.data(), all.data()) && before(content.data(), all.data() + all.size())) {
      return {static_cast<std::uint32_t>(content.data() - all.data()), static_cast<std::uint32_t>(content.size())};
    }
    if (!unescaped_) unescaped_ = std::make_shared<std::deque<std::string>>();
    unescaped_->emplace_back(content);
    return {static_cast<std::uint32_t>(unescaped_->size() - 1), TextCell::unescaped};
  }

  void read_flags(Column column) {
    std::vector<double>& flags = columns_.numbers[column.index];
    flags.assign(csv_.row_count(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t row = 0; row < csv_.row_count(); ++row) {
      const std::string_view cell = csv_.cell(row, cell_column(column));
      if (cell.empty()) continue;
      if (cell == "yes" || cell == "true" || cell == "1") {
        flags[row] = 1.0;
      } else if (cell == "no" || cell == "false" || cell == "0") {
        flags[row] = 0.0;
      } else {
        refuse(row,
               column,
               fmt::format("{}: {} is neither yes nor no", declaration(column).name, text::in_quotes(cell)),
               "write yes or no");
      }
    }
  }

  /// Each price that the family is sold by must be there (a warning: such a row can be checked, but not chosen), with a
  /// currency.
  void check_prices() {
    const FamilyDeclaration& sold = declaration(family_);
    if (!sold.priced()) return;
    check_pieces();
    const Column currency = column(family_, "currency");
    const bool is_sold[] = {sold.priced_per_piece, sold.priced_per_length, sold.priced_per_mass};
    const Column prices[] = {
        column(family_, "price"), column(family_, "price_per_length"), column(family_, "price_per_mass")};
    for (std::size_t row = 0; row < csv_.row_count(); ++row) {
      for (std::size_t way = 0; way < std::size(prices); ++way) {
        if (is_sold[way] && std::isnan(columns_.numbers[prices[way].index][row])) price_missing(prices[way], row);
      }
      const std::string_view code = text_of(currency, row);
      if (code.empty()) {
        refuse(row, currency, "currency is missing", "for example USD");
      } else if (code.size() != 3 ||
                 !std::all_of(code.begin(), code.end(), [](char c) { return c >= 'A' && c <= 'Z'; })) {
        refuse(row,
               currency,
               fmt::format("{} is not a currency", text::in_quotes(code)),
               "three capital letters, for example USD or EUR");
      }
    }
  }

  /// Price breaks, packs and owned pieces are of what is sold by the piece alone.
  void check_pieces() {
    const FamilyDeclaration& sold = declaration(family_);
    const bool by_piece = can_be_owned(family_);
    const auto not_sold_so = [&](std::size_t row, Column each) {
      refuse(row,
             each,
             fmt::format("{} are not sold by the piece alone", sold.title),
             fmt::format("leave {} empty", declaration(each).name));
    };
    const Column breaks = column(family_, "price_breaks");
    for (std::size_t row = 0; field(breaks) >= 0 && row < csv_.row_count(); ++row) {
      if (text_of(breaks, row).empty()) continue;
      if (!by_piece)
        not_sold_so(row, breaks);
      else if (!parse_price_breaks(text_of(breaks, row)))
        refuse(row,
               breaks,
               fmt::format("{} are no price breaks", text::in_quotes(text_of(breaks, row))),
               "pieces and the price of one from there on, rising: 10: 4.50; 100: 3.90");
    }
    for (const Column each : {column(family_, "pack_size"), column(family_, "owned_quantity")}) {
      for (std::size_t row = 0; field(each) >= 0 && row < csv_.row_count(); ++row) {
        const double pieces = columns_.numbers[each.index][row];
        if (std::isnan(pieces)) continue;
        if (!by_piece)
          not_sold_so(row, each);
        else if (pieces != std::floor(pieces))
          refuse(row, each, fmt::format("{} is {} pieces", declaration(each).name, pieces), "write a whole number");
      }
    }
    const Column availability = column(family_, "availability");
    for (std::size_t row = 0; field(availability) >= 0 && row < csv_.row_count(); ++row) {
      const std::string_view word = text_of(availability, row);
      if (!word.empty() && word != unavailable && word != preferred && !diagnostics_.is_full(csv_.text().get()))
        diagnostics_.warning(
            csv_.cell_span(row, cell_column(availability)),
            fmt::format("availability {} changes nothing", text::in_quotes(word)),
            "write unavailable if it cannot be had, or preferred; what is owned goes into owned_quantity");
    }
  }

  void read_companions() {
    for (const Companion& companion : header_.companions) {
      if (companion.kind == CompanionKind::tolerance) {
        read_tolerances(companion);
        continue;
      }
      auto& all = companion.kind == CompanionKind::source ? columns_.sources : columns_.confidences;
      std::vector<TextCell>& cells = all[companion.figure.index];
      cells.resize(csv_.row_count());
      for (std::size_t row = 0; row < cells.size(); ++row) cells[row] = text_cell(csv_.cell(row, companion.field));
      if (companion.kind == CompanionKind::confidence) check_confidences(cells, companion.field);
    }
  }

  /// Brings "High" to the word that is compared, high, and refuses what is none of them: it would count as sure.
  void check_confidences(std::vector<TextCell>& cells, std::size_t field) {
    std::map<std::string_view, TextCell> kept;  // one copy of each for all rows
    for (std::size_t row = 0; row < cells.size(); ++row) {
      const std::string_view said = text_of(cells[row]);
      if (said.empty()) continue;
      const std::optional<std::string_view> word = confidence_word(said);
      if (!word) {
        refuse_cell(row,
                    field,
                    fmt::format("{}: {} is no confidence", csv_.columns()[field].name, text::in_quotes(said)),
                    confidence_hint(said));
      } else if (*word != said) {
        TextCell& cell = kept[*word];
        if (cell.length == 0) cell = text_cell(*word);
        cells[row] = cell;
      }
    }
  }

  void read_tolerances(const Companion& companion) {
    std::vector<double>& widths = columns_.tolerances[companion.figure.index];
    widths.assign(csv_.row_count(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t row = 0; row < widths.size(); ++row) {
      const double figure = columns_.numbers[companion.figure.index][row];
      if (csv_.is_empty(row, companion.field) || std::isnan(figure)) continue;
      std::string reason;
      const std::string_view cell = csv_.cell(row, companion.field);
      if (const auto width = parse_tolerance(cell, companion, figure, reason)) {
        widths[row] = *width;
        continue;
      }
      refuse_cell(
          row,
          companion.field,
          fmt::format("tolerance {} of {}: {}", text::in_quotes(cell), declaration(companion.figure).name, reason),
          companion.unit ? "a plain number, in the unit of the column"
                         : "a share such as 25 %, or a width with its unit");
    }
  }

  void price_missing(Column price, std::size_t row) {
    if (!keep_[row] || !csv_.is_empty(row, cell_column(price))) return;
    if (diagnostics_.is_full(csv_.text().get())) return;
    diagnostics_.warning(csv_.cell_span(row, cell_column(price)),
                         fmt::format("{} is not known, so this part cannot be chosen", declaration(price).name),
                         "write a price, 0 if you own it");
  }

  std::string_view text_of(Column column, std::size_t row) const { return text_of(columns_.texts[column.index][row]); }

  std::string_view text_of(TextCell cell) const {
    if (cell.length == 0) return {};
    if (cell.length == TextCell::unescaped) return (*unescaped_)[cell.begin];
    return csv_.text()->contents().substr(cell.begin, cell.length);
  }

  const text::CsvTable& csv_;
  Family family_;
  const Header& header_;
  text::Diagnostics& diagnostics_;
  std::vector<bool> keep_;
  TableColumns columns_;
  GatheredColumns all_;  ///< of all rows so far, as the next
  std::vector<bool> keep_all_;
  std::vector<text::NumberColumn> numbers_;
  std::vector<Column> numbers_of_;  ///< the column of each
  std::shared_ptr<std::deque<std::string>> unescaped_;
};

}  // namespace

Table read_table(const std::shared_ptr<const text::SourceText>& text,
                 Family family,
                 int layer,
                 text::Diagnostics& diagnostics,
                 double room) {
  const std::size_t errors = diagnostics.error_count();
  text::CsvReader reader(text, diagnostics, text::CsvReader::few);
  const text::CsvTable& csv = reader.table();
  if (csv.columns().empty()) {
    if (diagnostics.error_count() == errors) {
      diagnostics.error(
          text::whole(text), "the catalogue is empty: no header and no parts", "see catalogue list for the families");
    }
    return Table(family);
  }
  const std::optional<Header> header = match_header(csv, family, diagnostics);
  if (!header) {
    while (reader.next()) {
    }  // what is wrong with the other rows is told too
    return Table(family);
  }
  if (csv.row_count() == 0 && diagnostics.error_count() == errors) {
    diagnostics.error(csv.header_span(), "the catalogue is empty: no parts below the header", "one line a part");
  }
  const auto rows = static_cast<std::size_t>(std::max(room, 1.0) * static_cast<double>(reader.most_rows()));
  TableFileReader table(reader, family, *header, diagnostics, rows);
  do {
    table.read();
  } while (reader.next());
  return table.table(layer);
}

}  // namespace millwright::catalogue
