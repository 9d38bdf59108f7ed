// SPDX-License-Identifier: Apache-2.0
#include "catalogue/offers_file.h"

#include <map>
#include <tuple>

#include "catalogue/catalogue.h"
#include "catalogue/known_columns.h"

namespace millwright::catalogue {
namespace {

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
  pack_size,
  stock_length,
  cutting_loss,
  cut_price,
  end_machining_price
};
constexpr KnownColumn columns[] = {{"manufacturer"},
                                   {"part_number", "", true},
                                   {"supplier", "", true},
                                   {"price"},
                                   {"price_per_length", "1/m"},
                                   {"currency", "", true},
                                   {"price_basis"},
                                   {"price_breaks"},
                                   {"pack_size"},
                                   {"stock_length", "mm"},
                                   {"cutting_loss", "mm"},
                                   {"cut_price"},
                                   {"end_machining_price"}};
}  // namespace offer_fields

class OfferReader {
 public:
  /// Without a catalogue the lines are checked, but not for the parts that they name.
  OfferReader(const text::CsvTable& csv, const Catalogue* catalogue, Suppliers& result, text::Diagnostics& diagnostics)
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
    offer.pack_size =
        reader_.count(row, pack_size, 1, 1e6, [](double n) { return fmt::format("pack_size is {} pieces", n); });
    constexpr double mm = 1e-3;
    offer.cutting = {mm * reader_.amount(row, stock_length, "a length"),
                     mm * reader_.amount(row, cutting_loss, "a length"),
                     reader_.amount(row, cut_price, "0 or more"),
                     reader_.amount(row, end_machining_price, "0 or more")};
    reader_.check_currency(row, currency);
    if (offer.supplier.empty())
      diagnostics_.error(reader_.span(row, supplier), "supplier is missing", "say who sells it at this price");
    if (!parse_price_breaks(offer.price_breaks))
      diagnostics_.error(reader_.span(row, price_breaks),
                         fmt::format("{} are no price breaks", text::in_quotes(offer.price_breaks)),
                         "pieces and the price of one from there on, rising: 10: 4.50; 100: 3.90");
    if (catalogue_ == nullptr) {
      check_terms(row, offer.cutting);
      check_once(
          row, {}, std::string(reader_.cell(row, manufacturer)), std::string(reader_.cell(row, part_number)), offer);
      return;
    }
    FoundParts found = catalogue_->find(reader_.cell(row, part_number), reader_.cell(row, manufacturer));
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
    const Table& table = catalogue_->table(part.family);
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
    check_cutting(row, part.family, offer.cutting);
    if (table.text("supplier", part.row) == offer.supplier)
      diagnostics_.error(
          reader_.span(row, supplier),
          fmt::format("the catalogue says itself what it costs from {}", text::in_quotes(offer.supplier)),
          "change the price in an overlay's row");
    check_once(
        row, part.family, std::string(table.manufacturer(part.row)), std::string(table.part_number(part.row)), offer);
  }

  /// `family`: of a part that is known.
  void check_once(std::size_t row,
                  std::optional<Family> family,
                  const std::string& maker,
                  const std::string& number,
                  const Offer& offer) {
    const auto [earlier, is_new] = seen_.try_emplace(std::tuple(family, maker, number, offer.supplier), row);
    if (!is_new && earlier->second != row)
      diagnostics_.error(offer.where,
                         fmt::format("{} offers {} twice", text::in_quotes(offer.supplier), number),
                         fmt::format("first in line {}", csv_.row_span(earlier->second).line));
  }

  /// Only what is cut has pieces to cut and ends to machine.
  void check_cutting(std::size_t row, Family family, const CuttingTerms& terms) {
    using namespace offer_fields;
    const auto check = [&](double amount, Field field) {
      if (std::isnan(amount) || find_column(family, columns[field].name)) return;
      diagnostics_.error(reader_.span(row, field),
                         fmt::format("{} have no {}", declaration(family).title, columns[field].name),
                         fmt::format("leave {} empty", columns[field].name));
    };
    check(terms.stock_length, stock_length);
    check(terms.cutting_loss, cutting_loss);
    check(terms.cut_price, cut_price);
    check(terms.end_machining_price, end_machining_price);
    check_terms(row, terms);
  }

  void check_terms(std::size_t row, const CuttingTerms& terms) {
    using namespace offer_fields;
    if (terms.cutting_loss >= terms.stock_length)
      diagnostics_.error(reader_.span(row, cutting_loss), "the saw takes the whole bar", "check the unit");
    if (terms.stock_length >= 0.0 && terms.stock_length < 0.1)
      diagnostics_.error(reader_.span(row, stock_length), "a bar of less than 100 mm is none", "check the unit");
  }

  void put(const Part& part, Offer offer) {
    const Table& table = catalogue_->table(part.family);
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
  const Catalogue* catalogue_;
  Suppliers& result_;
  text::Diagnostics& diagnostics_;
  KnownColumns reader_;
  std::map<std::tuple<std::optional<Family>, std::string, std::string, std::string>, std::size_t> seen_;
};

}  // namespace

void read_offers(const text::CsvTable& csv,
                 const Catalogue& catalogue,
                 Suppliers& suppliers,
                 text::Diagnostics& diagnostics) {
  OfferReader(csv, &catalogue, suppliers, diagnostics).read();
}

void check_offer_lines(const text::CsvTable& csv, text::Diagnostics& diagnostics) {
  Suppliers unused;
  OfferReader(csv, nullptr, unused, diagnostics).read();
}

}  // namespace millwright::catalogue
