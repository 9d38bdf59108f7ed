// SPDX-License-Identifier: Apache-2.0
// A table with a row more for each offer of its parts.
#include <cmath>
#include <map>
#include <stdexcept>

#include "catalogue/catalogue.h"

namespace millwright::catalogue {

/// What is said of the figures of a row once more, for the row that was appended; of its prices nothing is said there.
void Table::repeat_companions(std::size_t row) {
  const auto repeat = [row](auto& columns) {
    for (auto& column : columns)
      if (!column.empty()) column.push_back(column[row]);
  };
  repeat(tolerances_);
  repeat(figure_sources_);
  repeat(figure_confidences_);
  for (const char* price : {"price", "price_per_length"})
    for (auto* said : {&figure_sources_, &figure_confidences_}) {
      const std::size_t index = column(family_, price).index;
      if (index < said->size() && !(*said)[index].empty()) (*said)[index].back() = TextCell();
    }
}

/// Of the last row; a family that is not cut has no such columns.
void Table::set_cutting_terms(const CuttingTerms& terms) {
  const auto set = [&](std::string_view name, double value) {
    if (const auto found = find_column(family_, name)) numbers_[found->index].back() = value;
  };
  set("stock_length", terms.stock_length);
  set("cutting_loss", terms.cutting_loss);
  set("cut_price", terms.cut_price);
  set("end_machining_price", terms.end_machining_price);
}

void Table::append_offers(const std::vector<OfferedRow>& offers) {
  if (offers.empty()) return;
  spread_texts();
  const auto text_column = [&](std::string_view name) {
    std::vector<TextCell>& cells = texts_[column(family_, name).index];
    cells.resize(offsets_.size());
    return &cells;
  };
  std::vector<TextCell>* const texts[] = {
      text_column("supplier"), text_column("currency"), text_column("price_basis"), text_column("price_breaks")};
  ownership_.resize(offsets_.size(), Ownership::usual);
  for (const char* name :
       {"price", "price_per_length", "pack_size", "stock_length", "cutting_loss", "cut_price", "end_machining_price"})
    if (const auto found = find_column(family_, name)) make_column(found->index);
  // Texts that are in no file stand with those that are not verbatim in theirs.
  std::map<std::uint32_t, std::uint32_t> file_of_offers;
  std::map<std::uint32_t, std::shared_ptr<std::deque<std::string>>> own_texts;
  for (const OfferedRow& offer : offers) {
    const auto row = static_cast<std::size_t>(offer.row);
    for (auto& values : numbers_)
      if (!values.empty()) values.push_back(values[row]);
    for (auto& cells : texts_)
      if (!cells.empty()) cells.push_back(cells[row]);
    const std::uint32_t file = file_of_[row];
    if (!own_texts.contains(file)) {
      const auto& known = files_[file].unescaped;
      own_texts[file] =
          known ? std::make_shared<std::deque<std::string>>(*known) : std::make_shared<std::deque<std::string>>();
      file_of_offers[file] = static_cast<std::uint32_t>(files_.size());
      SourceFile copy = files_[file];
      copy.unescaped = own_texts[file];
      files_.push_back(std::move(copy));
    }
    std::deque<std::string>& words = *own_texts[file];
    const std::string* const written[] = {&offer.supplier, &offer.currency, &offer.price_basis, &offer.price_breaks};
    for (std::size_t i = 0; i < std::size(texts); ++i) {
      texts[i]->back() =
          written[i]->empty() ? TextCell() : TextCell{static_cast<std::uint32_t>(words.size()), TextCell::unescaped};
      if (!written[i]->empty()) words.push_back(*written[i]);
    }
    offsets_.push_back(offsets_[row]);
    file_of_.push_back(file_of_offers[file]);
    numbers_[column(family_, "price").index].back() = offer.price;
    numbers_[column(family_, "price_per_length").index].back() = offer.price_per_length;
    numbers_[column(family_, "pack_size").index].back() = offer.pack_size;
    set_cutting_terms(offer.cutting);
    ownership_.push_back(offer.owned_pieces ? Ownership::only : Ownership::none);
    repeat_companions(row);
  }
  note_absent_columns();
  forget();
}

Table& Catalogue::changeable_table(Family family) {
  if (with_offers_ != nullptr) throw std::logic_error("a catalogue is changed whose offers would not be");
  return tables_[static_cast<std::size_t>(family)];
}

void Catalogue::add_offers() {
  with_offers_.reset();
  if (suppliers_.empty() || has_offers_) return;
  auto whole = std::make_shared<Catalogue>(*this);
  whole->has_offers_ = true;
  bool any = false;
  for (Table& table : whole->tables_) {
    std::vector<OfferedRow> offered;
    for (const Offer& offer : suppliers_.offers) {
      if (offer.family != table.family()) continue;
      for (const int row : table.find(offer.part_number, offer.manufacturer).rows)
        offered.push_back({row,
                           offer.price,
                           offer.price_per_length,
                           offer.pack_size,
                           offer.supplier,
                           offer.currency,
                           offer.price_basis,
                           offer.price_breaks,
                           false,
                           offer.cutting});
    }
    // What is owned costs no order: where the part's own supplier charges for one, owned pieces are a row of their own.
    for (int row = 0; can_be_owned(table.family()) && row < table.rows(); ++row) {
      if (!suppliers_.charges(table.text("supplier", row)) || !(owned_pieces(table, row, stock_) > 0.0)) continue;
      constexpr double none = std::numeric_limits<double>::quiet_NaN();
      const std::string currency(table.price(row).currency);
      offered.push_back({row, 0.0, none, none, "", currency, "owned", "", true});
    }
    any = any || !offered.empty();
    table.append_offers(offered);
  }
  if (any) with_offers_ = std::move(whole);
}

}  // namespace millwright::catalogue
