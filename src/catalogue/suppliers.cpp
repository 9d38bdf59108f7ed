// SPDX-License-Identifier: Apache-2.0
#include "catalogue/suppliers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <tuple>

#include "catalogue/catalogue.h"
#include "text/csv.h"
#include "text/nearest.h"

namespace millwright::catalogue {
namespace {

constexpr std::string_view suppliers_name = "suppliers.csv";
constexpr std::string_view offers_name = "offers.csv";

struct KnownColumn {
  std::string_view name;
  std::string_view unit = {};
  bool needed = false;
};

/// What both files have in common: a header of known columns, texts, sums of money.
class LineReader {
 public:
  LineReader(const text::CsvTable& csv,
             std::string_view file_name,
             std::span<const KnownColumn> columns,
             text::Diagnostics& diagnostics)
      : csv_(csv), file_name_(file_name), columns_(columns), diagnostics_(diagnostics), fields_(columns.size()) {}

  bool match_header() {
    if (csv_.columns().empty()) return false;  // reported
    const std::size_t errors = diagnostics_.error_count();
    std::vector<std::string_view> names;
    for (const KnownColumn& each : columns_) names.push_back(each.name);
    for (std::size_t i = 0; i < csv_.columns().size(); ++i) match(csv_.columns()[i], i, names);
    for (std::size_t i = 0; i < columns_.size(); ++i)
      if (columns_[i].needed && !fields_[i])
        diagnostics_.error(csv_.header_span(),
                           fmt::format("{} has no column {}", file_name_, columns_[i].name),
                           fmt::format("its columns: {}", fmt::join(names, ", ")));
    return diagnostics_.error_count() == errors;
  }

  [[nodiscard]] std::string_view cell(std::size_t row, std::size_t field) const {
    return fields_[field] ? csv_.cell(row, *fields_[field]) : std::string_view();
  }
  [[nodiscard]] text::SourceSpan span(std::size_t row, std::size_t field) const {
    return fields_[field] ? csv_.cell_span(row, *fields_[field]) : csv_.row_span(row);
  }

  /// Not negative; NaN where nothing is written.
  double amount(std::size_t row, std::size_t field, std::string_view hint) {
    if (cell(row, field).empty()) return std::numeric_limits<double>::quiet_NaN();
    const auto number = csv_.number(row, *fields_[field], diagnostics_);
    if (number && (*number < 0.0 || !std::isfinite(*number)))
      diagnostics_.error(
          span(row, field), fmt::format("{} cannot be {}", columns_[field].name, *number), std::string(hint));
    return number.value_or(0.0);
  }

  void check_currency(std::size_t row, std::size_t field) {
    const std::string_view code = cell(row, field);
    if (code.empty())
      diagnostics_.error(span(row, field), "currency is missing", "for example USD");
    else if (code.size() != 3 || !std::all_of(code.begin(), code.end(), [](char c) { return c >= 'A' && c <= 'Z'; }))
      diagnostics_.error(span(row, field),
                         fmt::format("{} is not a currency", text::quoted(code)),
                         "three capital letters, for example USD or EUR");
  }

 private:
  void match(const text::CsvColumn& column, std::size_t at, const std::vector<std::string_view>& names) {
    const auto known = std::find(names.begin(), names.end(), column.name);
    if (known == names.end()) {
      diagnostics_.error(
          column.name_span,
          fmt::format("{} has no column {}", file_name_, text::quoted(column.name)),
          text::did_you_mean(column.name, names, fmt::format("its columns: {}", fmt::join(names, ", "))));
      return;
    }
    const auto index = static_cast<std::size_t>(known - names.begin());
    fields_[index] = at;
    const std::string_view unit = column.unit ? std::string_view(*column.unit) : std::string_view();
    const bool pieces = unit == "1" && columns_[index].unit.empty();
    if (unit != columns_[index].unit && !pieces)
      diagnostics_.error(column.unit_span,
                         fmt::format("{} is read in [{}]", column.name, columns_[index].unit),
                         columns_[index].unit.empty()
                             ? fmt::format("write {}", column.name)
                             : fmt::format("write {} [{}]", column.name, columns_[index].unit));
  }

  const text::CsvTable& csv_;
  std::string_view file_name_;
  std::span<const KnownColumn> columns_;
  text::Diagnostics& diagnostics_;
  std::vector<std::optional<std::size_t>> fields_;
};

namespace supplier_fields {
enum Field : std::size_t { supplier, shipping_fee, minimum_order, currency };
constexpr KnownColumn columns[] = {{"supplier", "", true}, {"shipping_fee"}, {"minimum_order"}, {"currency"}};
}  // namespace supplier_fields

void read_supplier_lines(const text::CsvTable& csv, Suppliers& result, text::Diagnostics& diagnostics) {
  using namespace supplier_fields;
  LineReader reader(csv, suppliers_name, columns, diagnostics);
  if (!reader.match_header()) return;
  std::map<std::string, std::size_t, std::less<>> seen;
  for (std::size_t row = 0; row < csv.row_count(); ++row) {
    const std::size_t errors = diagnostics.error_count();
    Supplier each;
    each.name = reader.cell(row, supplier);
    each.where = reader.span(row, supplier);
    const auto sum = [&](std::size_t field) {
      const double amount = reader.amount(row, field, "0 or more; leave it empty where nothing is asked");
      return amount > 0.0 ? amount : 0.0;
    };
    each.shipping_fee = sum(shipping_fee);
    each.minimum_order = sum(minimum_order);
    each.currency = reader.cell(row, currency);
    if (each.charges() || !each.currency.empty()) reader.check_currency(row, currency);
    const auto [earlier, is_new] = seen.try_emplace(each.name, row);
    if (!is_new)
      diagnostics.error(each.where,
                        fmt::format("{} stands in this file twice", text::quoted(each.name)),
                        fmt::format("first in line {}", csv.row_span(earlier->second).line));
    if (diagnostics.error_count() != errors) continue;
    std::erase_if(result.suppliers, [&](const Supplier& known) { return known.name == each.name; });
    result.suppliers.push_back(std::move(each));
  }
}

namespace offer_fields {
enum Field : std::size_t {
  manufacturer,
  part_number,
  supplier,
  price,
  price_per_length,
  currency,
  price_basis,
  price_breaks,
  pack_size
};
constexpr KnownColumn columns[] = {{"manufacturer"},
                                   {"part_number", "", true},
                                   {"supplier", "", true},
                                   {"price"},
                                   {"price_per_length", "1/m"},
                                   {"currency", "", true},
                                   {"price_basis"},
                                   {"price_breaks"},
                                   {"pack_size"}};
}  // namespace offer_fields

class OfferReader {
 public:
  OfferReader(const text::CsvTable& csv, const Catalogue& catalogue, Suppliers& result, text::Diagnostics& diagnostics)
      : csv_(csv),
        catalogue_(catalogue),
        result_(result),
        diagnostics_(diagnostics),
        reader_(csv, offers_name, offer_fields::columns, diagnostics) {}

  void read() {
    if (!reader_.match_header()) return;
    for (std::size_t row = 0; row < csv_.row_count(); ++row) read_row(row);
  }

 private:
  void read_row(std::size_t row) {
    using namespace offer_fields;
    const std::size_t errors = diagnostics_.error_count();
    Offer offer;
    offer.where = reader_.span(row, part_number);
    offer.supplier = reader_.cell(row, supplier);
    offer.price = reader_.amount(row, price, "0 or more");
    offer.price_per_length = reader_.amount(row, price_per_length, "0 or more");
    offer.currency = reader_.cell(row, currency);
    offer.price_basis = reader_.cell(row, price_basis);
    offer.price_breaks = reader_.cell(row, price_breaks);
    offer.pack_size = reader_.amount(row, pack_size, "a whole number");
    reader_.check_currency(row, currency);
    if (offer.supplier.empty())
      diagnostics_.error(reader_.span(row, supplier), "supplier is missing", "say who sells it at this price");
    if (!std::isnan(offer.pack_size) && (offer.pack_size < 1.0 || offer.pack_size != std::floor(offer.pack_size)))
      diagnostics_.error(
          reader_.span(row, pack_size), fmt::format("pack_size is {} pieces", offer.pack_size), "write a whole number");
    if (!parse_price_breaks(offer.price_breaks))
      diagnostics_.error(reader_.span(row, price_breaks),
                         fmt::format("{} are no price breaks", text::quoted(offer.price_breaks)),
                         "pieces and the price of one from there on, rising: 10: 4.50; 100: 3.90");
    FoundParts found = catalogue_.find(reader_.cell(row, part_number), reader_.cell(row, manufacturer));
    std::erase_if(found.parts, [](const Part& part) { return !declaration(part.family).priced(); });
    if (found.parts.empty())
      diagnostics_.error(offer.where, found.error.empty() ? "this is not for sale" : found.error, found.hint);
    for (const Part& part : found.parts) take(row, part, offer);
    if (diagnostics_.error_count() != errors) return;
    for (const Part& part : found.parts) put(part, offer);
  }

  /// Reports what does not go together with the part.
  void take(std::size_t row, const Part& part, const Offer& offer) {
    using namespace offer_fields;
    const FamilyDeclaration& family = declaration(part.family);
    const Table& table = catalogue_.table(part.family);
    if (family.priced_per_mass) {
      diagnostics_.error(offer.where,
                         fmt::format("{} are sold by mass: offers of them are not compared", family.title));
      return;
    }
    const auto sold_so = [&](bool is_sold, double amount, std::size_t field) {
      const std::string_view name = columns[field].name;
      if (is_sold && std::isnan(amount))
        diagnostics_.error(
            reader_.span(row, field), fmt::format("{} is missing", name), fmt::format("{} have one", family.title));
      if (!is_sold && !std::isnan(amount))
        diagnostics_.error(reader_.span(row, field),
                           fmt::format("{} have no {}", family.title, name),
                           fmt::format("leave {} empty", name));
    };
    sold_so(family.priced_per_piece, offer.price, price);
    sold_so(family.priced_per_length, offer.price_per_length, price_per_length);
    if (!can_be_owned(part.family) && (!offer.price_breaks.empty() || !std::isnan(offer.pack_size)))
      diagnostics_.error(offer.where,
                         fmt::format("{} are not sold by the piece alone", family.title),
                         "leave price_breaks and pack_size empty");
    if (table.text("supplier", part.row) == offer.supplier)
      diagnostics_.error(reader_.span(row, supplier),
                         fmt::format("the catalogue says itself what it costs from {}", text::quoted(offer.supplier)),
                         "change the price in an overlay's row");
    const auto [earlier, is_new] = seen_.try_emplace(std::tuple(part.family,
                                                                std::string(table.manufacturer(part.row)),
                                                                std::string(table.part_number(part.row)),
                                                                offer.supplier),
                                                     row);
    if (!is_new && earlier->second != row)
      diagnostics_.error(offer.where,
                         fmt::format("{} offers {} twice", text::quoted(offer.supplier), table.part_number(part.row)),
                         fmt::format("first in line {}", csv_.row_span(earlier->second).line));
  }

  void put(const Part& part, Offer offer) {
    const Table& table = catalogue_.table(part.family);
    offer.family = part.family;
    offer.manufacturer = table.manufacturer(part.row);
    offer.part_number = table.part_number(part.row);
    std::erase_if(result_.offers, [&](const Offer& known) {
      return known.family == offer.family && known.manufacturer == offer.manufacturer &&
             known.part_number == offer.part_number && known.supplier == offer.supplier;
    });
    result_.offers.push_back(std::move(offer));
  }

  const text::CsvTable& csv_;
  const Catalogue& catalogue_;
  Suppliers& result_;
  text::Diagnostics& diagnostics_;
  LineReader reader_;
  std::map<std::tuple<Family, std::string, std::string, std::string>, std::size_t> seen_;
};

}  // namespace

const Supplier* Suppliers::find(std::string_view name) const {
  const auto found =
      std::find_if(suppliers.begin(), suppliers.end(), [&](const Supplier& each) { return each.name == name; });
  return found == suppliers.end() ? nullptr : &*found;
}

bool is_supplier_file(const std::filesystem::path& file) {
  return file.filename() == suppliers_name || file.filename() == offers_name;
}

std::vector<std::filesystem::path> supplier_files(const std::filesystem::path& place) {
  if (is_supplier_file(place)) return {place};
  std::vector<std::filesystem::path> files;
  std::error_code ignored;
  if (!std::filesystem::is_directory(place, ignored)) return files;
  for (const std::string_view name : {suppliers_name, offers_name})
    if (std::filesystem::exists(place / name, ignored)) files.push_back(place / name);
  return files;
}

void read_suppliers(const std::filesystem::path& file,
                    const Catalogue& catalogue,
                    Suppliers& suppliers,
                    text::Diagnostics& diagnostics) {
  const auto csv = text::read_csv_file(file.string(), diagnostics);
  if (!csv) return;
  if (file.filename() == offers_name)
    OfferReader(*csv, catalogue, suppliers, diagnostics).read();
  else
    read_supplier_lines(*csv, suppliers, diagnostics);
}

void check_suppliers(const Catalogue& catalogue, const Suppliers& suppliers, text::Diagnostics& diagnostics) {
  if (suppliers.empty()) return;
  std::set<std::string, std::less<>> selling = {""};
  for (const Offer& offer : suppliers.offers) selling.insert(offer.supplier);
  for (const FamilyDeclaration& family : families) {
    const Table& table = catalogue.table(family.family);
    for (int row = 0; row < table.rows(); ++row)
      if (const std::string_view name = table.text(column(family.family, "supplier"), row); !name.empty())
        selling.emplace(name);
  }
  std::vector<std::string_view> names;
  std::size_t charging = 0;
  for (const Supplier& each : suppliers.suppliers) {
    names.push_back(each.name);
    if (!selling.contains(each.name))
      diagnostics.warning(each.where,
                          fmt::format("{} sells no part of the catalogues", text::quoted(each.name)),
                          text::did_you_mean(each.name, selling, "say in offers.csv what it sells"));
    else if (each.charges() && ++charging == Suppliers::most_charging + 1)
      diagnostics.error(each.where,
                        fmt::format("more than {} suppliers charge shipping or a minimum", Suppliers::most_charging),
                        "every set of them is searched: leave some out");
  }
  std::set<std::string_view> said;
  for (const Offer& offer : suppliers.offers)
    if (!names.empty() && suppliers.find(offer.supplier) == nullptr && said.insert(offer.supplier).second)
      diagnostics.warning(
          offer.where,
          fmt::format("suppliers.csv has no {}: orders there cost no shipping", text::quoted(offer.supplier)),
          text::did_you_mean(offer.supplier, names, "give it a line there"));
}

}  // namespace millwright::catalogue
