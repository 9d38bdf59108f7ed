// SPDX-License-Identifier: Apache-2.0
#include "catalogue/stock.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "catalogue/catalogue.h"
#include "catalogue/file_names.h"
#include "catalogue/known_columns.h"

namespace millwright::catalogue {
namespace {

constexpr std::string_view stock_file_name = "stock.csv";
namespace stock_fields {
enum Field : std::size_t { manufacturer, part_number, owned, available };
constexpr KnownColumn columns[] = {{"manufacturer"}, {"part_number", "", true}, {"owned"}, {"available"}};
}  // namespace stock_fields

class StockReader {
 public:
  /// Without a catalogue the lines are checked, but not for the parts that they name.
  StockReader(const text::CsvTable& csv, const Catalogue* catalogue, Stock& stock, text::Diagnostics& diagnostics)
      : csv_(csv),
        catalogue_(catalogue),
        stock_(stock),
        diagnostics_(diagnostics),
        reader_(csv, stock_file_name, stock_fields::columns, diagnostics) {}

  void read() {
    if (!reader_.match_header()) return;
    for (std::size_t row = 0; row < csv_.row_count(); ++row) read_row(row);
  }

 private:
  void read_row(std::size_t row) {
    using namespace stock_fields;
    const std::size_t errors = diagnostics_.error_count();
    StockMark mark;
    mark.where = reader_.span(row, part_number);
    if (!reader_.says(row, owned) && !reader_.says(row, available))
      diagnostics_.error(csv_.row_span(row),
                         "nothing is said about this part",
                         "owned: how many pieces you have; available: no if it cannot be had, or preferred");
    const double pieces = reader_.count(
        row, owned, 0, 1e6, [&](double) { return fmt::format("{} pieces cannot be owned", reader_.cell(row, owned)); });
    mark.owned = std::isnan(pieces) ? 0.0 : pieces;
    if (const std::string_view word = reader_.cell(row, available); !word.empty()) {
      mark.available = word != "no";
      mark.preferred = word == preferred;
      if (word != "yes" && word != "no" && !mark.preferred)
        diagnostics_.error(reader_.span(row, available),
                           fmt::format("available: {} is none of yes, no and preferred", text::in_quotes(word)),
                           "write yes, no or preferred");
    }
    if (!mark.available && mark.owned > 0.0)
      diagnostics_.error(reader_.span(row, available),
                         "a part that is not available is not chosen at all, and this one is owned",
                         "leave 'available' empty to use what you own");
    if (catalogue_ == nullptr) {
      check_once(row, std::string(reader_.cell(row, manufacturer)), std::string(reader_.cell(row, part_number)));
      return;
    }
    const FoundParts found = part_of(row, mark.owned > 0.0);
    if (diagnostics_.error_count() != errors) return;
    for (const Part& part : found.parts) {
      const Table& table = catalogue_->table(part.family);
      keep_unsaid(row, table, part.row, mark);
      stock_.set(part.family, table.manufacturer(part.row), table.part_number(part.row), mark);
    }
  }

  void check_once(std::size_t row, const std::string& maker, const std::string& number) {
    const auto [earlier, is_new] = seen_.try_emplace(std::pair(maker, number), row);
    if (is_new || earlier->second == row) return;
    diagnostics_.error(reader_.span(row, stock_fields::part_number),
                       fmt::format("{}{}{} stands in this file twice", maker, maker.empty() ? "" : " ", number),
                       fmt::format("first in line {}", csv_.row_span(earlier->second).line));
  }

  /// An empty cell leaves what an earlier line or the part's own row says.
  void keep_unsaid(std::size_t row, const Table& table, int part, StockMark& mark) const {
    using namespace stock_fields;
    if (!reader_.says(row, owned)) mark.owned = owned_pieces(table, part, stock_);
    if (reader_.says(row, available)) return;
    const StockMark* earlier = stock_.find(table.family(), table.manufacturer(part), table.part_number(part));
    mark.preferred = is_preferred(table, part, stock_);
    mark.available = earlier == nullptr || earlier->available;
  }

  /// The rows that a line names, of families that are for sale.
  FoundParts part_of(std::size_t row, bool some_owned) {
    using namespace stock_fields;
    FoundParts found = catalogue_->find(reader_.cell(row, part_number), reader_.cell(row, manufacturer));
    std::erase_if(found.parts, [](const Part& part) { return !declaration(part.family).priced(); });
    if (found.parts.empty()) {
      diagnostics_.error(
          reader_.span(row, part_number), found.error.empty() ? "this is not for sale" : found.error, found.hint);
      return found;
    }
    for (const Part& part : found.parts) {
      const Table& table = catalogue_->table(part.family);
      const auto name = std::pair(std::string(table.manufacturer(part.row)), std::string(table.part_number(part.row)));
      check_once(row, name.first, name.second);
      if (part.family == Family::materials)
        diagnostics_.error(reader_.span(row, part_number),
                           fmt::format("{} is a material, and those are chosen by the problem", name.second),
                           "name another one there");
      else if (some_owned && !can_be_owned(part.family))
        diagnostics_.error(
            reader_.span(row, owned),
            fmt::format("{} are cut to length: pieces of them cannot be owned here", declaration(part.family).title),
            "give the part a price of 0 in an overlay if what you have is long enough");
      else if (some_owned && std::isnan(table.price(part.row).piece))
        diagnostics_.error(reader_.span(row, owned),
                           fmt::format("{} {} has no price for more pieces than are owned", name.first, name.second),
                           "give it one in an overlay; without a price it is not chosen");
    }
    return found;
  }

  const text::CsvTable& csv_;
  const Catalogue* catalogue_;
  Stock& stock_;
  text::Diagnostics& diagnostics_;
  KnownColumns reader_;
  std::map<std::pair<std::string, std::string>, std::size_t> seen_;
};

}  // namespace

const StockMark* Stock::find(Family family, std::string_view manufacturer, std::string_view part_number) const {
  if (marks_.empty()) return nullptr;
  const auto found = marks_.find(Key{family, std::string(manufacturer), std::string(part_number)});
  return found == marks_.end() ? nullptr : &found->second;
}

void Stock::set(Family family, std::string_view manufacturer, std::string_view part_number, StockMark mark) {
  marks_[Key{family, std::string(manufacturer), std::string(part_number)}] = std::move(mark);
}

double owned_pieces(const Table& table, int row, const Stock& stock) {
  if (!can_be_owned(table.family())) return 0.0;
  const StockMark* mark = stock.find(table.family(), table.manufacturer(row), table.part_number(row));
  if (mark != nullptr) return mark->owned;
  const double pieces = table.number(column(table.family(), "owned_quantity"), row);
  return pieces > 0.0 ? pieces : 0.0;
}

bool is_preferred(const Table& table, int row, const Stock& stock) {
  if (const StockMark* mark = stock.find(table.family(), table.manufacturer(row), table.part_number(row)))
    return mark->preferred;
  return table.text(column(table.family(), "availability"), row) == preferred;
}

bool is_stock_file(const std::filesystem::path& file) { return is_named(file, stock_file_name); }

std::optional<std::filesystem::path> stock_file(const std::filesystem::path& place) {
  if (is_stock_file(place)) return place;
  return named_in(place, stock_file_name);
}

void read_stock(const std::filesystem::path& file,
                const Catalogue& catalogue,
                Stock& stock,
                text::Diagnostics& diagnostics) {
  if (const auto csv = text::read_csv_file(file.string(), diagnostics))
    StockReader(*csv, &catalogue, stock, diagnostics).read();
}

void check_stock_lines(const text::CsvTable& csv, text::Diagnostics& diagnostics) {
  Stock unused;
  StockReader(csv, nullptr, unused, diagnostics).read();
}

}  // namespace millwright::catalogue
