// SPDX-License-Identifier: Apache-2.0
#include "catalogue/suppliers.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "catalogue/catalogue.h"
#include "catalogue/file_names.h"
#include "catalogue/known_columns.h"
#include "catalogue/offers_file.h"
#include "text/nearest.h"

namespace millwright::catalogue {
namespace {

constexpr std::string_view suppliers_name = "suppliers.csv";

namespace supplier_fields {
enum Field : std::size_t { supplier, shipping_fee, minimum_order, currency };
constexpr KnownColumn columns[] = {{"supplier", "", true}, {"shipping_fee"}, {"minimum_order"}, {"currency"}};
}  // namespace supplier_fields

void read_supplier_lines(const text::CsvTable& csv, Suppliers& result, text::Diagnostics& diagnostics) {
  using namespace supplier_fields;
  KnownColumns reader(csv, suppliers_name, columns, diagnostics);
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
                        fmt::format("{} stands in this file twice", text::in_quotes(each.name)),
                        fmt::format("first in line {}", csv.row_span(earlier->second).line));
    if (diagnostics.error_count() != errors) continue;
    std::erase_if(result.suppliers, [&](const Supplier& known) { return known.name == each.name; });
    result.suppliers.push_back(std::move(each));
  }
}

}  // namespace

const Supplier* Suppliers::find(std::string_view name) const {
  const auto found =
      std::find_if(suppliers.begin(), suppliers.end(), [&](const Supplier& each) { return each.name == name; });
  return found == suppliers.end() ? nullptr : &*found;
}

bool is_supplier_file(const std::filesystem::path& file) {
  return is_named(file, suppliers_name) || is_named(file, offers_name);
}

std::vector<std::filesystem::path> supplier_files(const std::filesystem::path& place) {
  if (is_supplier_file(place)) return {place};
  std::vector<std::filesystem::path> files;
  for (const std::string_view name : {suppliers_name, offers_name})
    if (auto file = named_in(place, name)) files.push_back(std::move(*file));
  return files;
}

void read_suppliers(const std::filesystem::path& file,
                    const Catalogue& catalogue,
                    Suppliers& suppliers,
                    text::Diagnostics& diagnostics) {
  const auto csv = text::read_csv_file(file.string(), diagnostics);
  if (!csv) return;
  if (is_named(file, offers_name))
    read_offers(*csv, catalogue, suppliers, diagnostics);
  else
    read_supplier_lines(*csv, suppliers, diagnostics);
}

void check_supplier_lines(const text::CsvTable& csv, std::string_view file_name, text::Diagnostics& diagnostics) {
  Suppliers unused;
  if (is_named(file_name, offers_name))
    check_offer_lines(csv, diagnostics);
  else
    read_supplier_lines(csv, unused, diagnostics);
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
                          fmt::format("{} sells no part of the catalogues", text::in_quotes(each.name)),
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
          fmt::format("suppliers.csv has no {}: orders there cost no shipping", text::in_quotes(offer.supplier)),
          text::did_you_mean(offer.supplier, names, "give it a line there"));
}

}  // namespace millwright::catalogue
