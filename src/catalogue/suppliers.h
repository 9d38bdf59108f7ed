// SPDX-License-Identifier: Apache-2.0
//
// Who sells parts, and for how much: two files in the folder of an overlay.
//
// suppliers.csv, what an order there costs beside the parts:
//
//   supplier,shipping_fee,minimum_order,currency
//   Shop A,12,50,USD                an order of less than 50 USD is filled up to 50
//   ,5,,USD                         everything that names no supplier
//
// offers.csv, parts of any catalogue that are sold elsewhere too, or at another price:
//
//   manufacturer,part_number,supplier,price,price_per_length [1/m],currency,price_basis,price_breaks,pack_size
//   OMC,17HS19-2004S1,Shop A,8.90,,USD,"list, read 2026-09-03",10: 8.10,
//
// and of what is cut: stock_length [mm],cutting_loss [mm],cut_price,end_machining_price, as in catalogues.
//
// The row of the catalogue itself is an offer too: by its own supplier, or by nobody in particular. Suppliers without
// a line in suppliers.csv ask for no shipping and no minimum. A later overlay's word on a supplier, or on the offer of
// a part by a supplier, replaces an earlier one's.
#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "catalogue/table.h"
#include "text/csv.h"
#include "text/diagnostic.h"

namespace millwright::catalogue {

class Catalogue;

struct Supplier {
  std::string name;           ///< empty: of what names no supplier
  double shipping_fee = 0.0;  ///< of an order, in `currency`
  double minimum_order = 0.0;
  std::string currency;
  text::SourceSpan where;
  [[nodiscard]] bool charges() const { return shipping_fee > 0.0 || minimum_order > 0.0; }
};

/// A part of a catalogue as somebody sells it.
struct Offer {
  Family family{};
  std::string manufacturer, part_number, supplier;
  double price = std::numeric_limits<double>::quiet_NaN();
  double price_per_length = std::numeric_limits<double>::quiet_NaN();  ///< 1/m
  std::string currency, price_basis, price_breaks;
  double pack_size = std::numeric_limits<double>::quiet_NaN();
  CuttingTerms cutting;
  text::SourceSpan where;
};

struct Suppliers {
  /// Every set of suppliers that charge something is searched: there may be so many of them.
  static constexpr std::size_t most_charging = 6;

  std::vector<Supplier> suppliers;
  std::vector<Offer> offers;

  [[nodiscard]] bool empty() const { return suppliers.empty() && offers.empty(); }
  /// Null if there is no such line.
  [[nodiscard]] const Supplier* find(std::string_view name) const;
  /// Whether an order there costs more than what is ordered.
  [[nodiscard]] bool charges(std::string_view name) const {
    const Supplier* found = find(name);
    return found != nullptr && found->charges();
  }
};

/// The files of a place as given to Catalogue::load: the place itself, or in its folder; suppliers first.
std::vector<std::filesystem::path> supplier_files(const std::filesystem::path& place);
/// Whether a file is one of them, by its name.
bool is_supplier_file(const std::filesystem::path& file);

/// Adds what a file says. Reported: unknown columns, what is no price, parts that no catalogue has or that are not
/// sold so, lines that stand twice, too many suppliers that charge.
void read_suppliers(const std::filesystem::path& file,
                    const Catalogue& catalogue,
                    Suppliers& suppliers,
                    text::Diagnostics& diagnostics);
/// Reports what is wrong with the lines of the file of that name, whatever parts they are about.
void check_supplier_lines(const text::CsvTable& csv, std::string_view file_name, text::Diagnostics& diagnostics);
/// After all files: offers by suppliers that suppliers.csv does not know, and suppliers that sell nothing, are
/// warnings.
void check_suppliers(const Catalogue& catalogue, const Suppliers& suppliers, text::Diagnostics& diagnostics);

}  // namespace millwright::catalogue
