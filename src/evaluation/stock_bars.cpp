// SPDX-License-Identifier: Apache-2.0
#include "evaluation/stock_bars.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include <fmt/format.h>

#include "evaluation/cuts.h"
#include "evaluation/refusal.h"

namespace millwright::evaluation {
namespace {

/// For so many combinations of pieces the bars are counted beforehand, for every row.
constexpr std::size_t most_codes = std::size_t{1} << 16U;

double sum_of(const std::vector<double>& lengths) { return std::accumulate(lengths.begin(), lengths.end(), 0.0); }

double bars_for(const std::vector<double>& lengths, const BarSize& size) {
  return static_cast<double>(cut_from_bars(lengths, size).bars.size());
}

}  // namespace

bool StockBars::is_cut(const PartUse& use) const {
  return use.stated.empty() && use.length > 0.0 && prices_.bar(catalogue_.table(use.family), use.row).has_value();
}

StockBars::Lengths StockBars::lengths_of(const PartUse& use, const std::string& axis) const {
  Lengths result;
  for (const Cut& cut : cuts_of(problem_, use, axis))
    result.insert(result.end(), static_cast<std::size_t>(std::lround(cut.count)), cut.length);
  std::sort(result.begin(), result.end(), std::greater<>());
  return result;
}

void StockBars::find(std::size_t stage, const std::string& axis, std::span<const SlotTable> tables) {
  axis_of_.resize(std::max(axis_of_.size(), stage + 1));
  axis_of_[stage] = axis;
  for (std::size_t slot = 0; slot < tables.size(); ++slot)
    for (std::size_t row = 0; row < tables[slot].rows(); ++row)
      for (const PartUse& use : tables[slot].candidate(row).parts)
        if (is_cut(use)) {
          const Key key{use.family, use.row};
          const auto [found, is_new] = found_.try_emplace(key);
          if (is_new) in_order_.push_back(key);
          found->second[{stage, slot}].push_back(lengths_of(use, axis));
        }
  for (auto& [row, places] : found_)
    for (auto& [place, lengths] : places) {
      std::sort(lengths.begin(), lengths.end());
      lengths.erase(std::unique(lengths.begin(), lengths.end()), lengths.end());
    }
}

std::size_t StockBars::settle(std::size_t first_state) {
  for (const Key& row : in_order_) settle_row(row, first_state);
  packed_.clear();
  return components_;
}

/// Slots with the same only pieces share a digit.
void StockBars::settle_row(Key row, std::size_t first_state) {
  const catalogue::Table& table = catalogue_.table(row.first);
  const auto bar = prices_.bar(table, row.second);
  const auto& places = found_.at(row);
  std::vector<Digit> digits;
  std::vector<std::pair<Place, std::size_t>> digit_of;
  std::size_t codes = 1;
  for (const auto& [at, pieces] : places) {
    const auto same = std::find_if(digits.begin(), digits.end(), [&pieces = pieces](const Digit& digit) {
      return pieces.size() == 1 && digit.pieces == pieces;
    });
    const std::size_t values = same == digits.end() ? 1 : same->values();
    codes = codes / values * (same == digits.end() ? pieces.size() + 1 : values + 1);
    if (codes > most_codes) refuse(row);
    digit_of.emplace_back(at, static_cast<std::size_t>(same - digits.begin()));
    if (same == digits.end())
      digits.push_back({pieces, 1});
    else
      ++same->most;
  }
  std::vector<double> radix(1, 1.0);
  for (const Digit& digit : digits) radix.push_back(radix.back() * static_cast<double>(digit.values()));
  for (const auto& [at, digit] : digit_of) {
    Code& code = codes_[{row, at}];
    code.stock = stocks_.size();
    for (std::size_t i = 0; i < places.at(at).size(); ++i)
      code.of_pieces.push_back(radix[digit] * static_cast<double>(i + 1));
  }
  BarStock stock;
  stock.family = row.first;
  stock.row = row.second;
  stock.size = bar->size;
  stock.bar_price = bar->price;
  stock.preference = prices_.preference(table, row.second);
  fill(stock, digits);
  if (stock.is_shared()) stock.state = first_state + components_++;
  stocks_.push_back(std::move(stock));
}

/// More combinations of lengths than can be counted beforehand. Counting them apart would give a dearer bill, and one
/// that is proved to be the cheapest would not be.
void StockBars::refuse(Key row) const {
  std::string axes;
  for (const auto& [at, pieces] : found_.at(row)) {
    const std::string& axis = axis_of_[at.stage];
    if (axes.find(axis) == std::string::npos) axes += (axes.empty() ? "" : ", ") + axis;
  }
  const catalogue::Table& table = catalogue_.table(row.first);
  throw Refusal(fmt::format("{} {} ({}) can be cut to so many lengths on the axes {} that its bars are not counted "
                            "over all of them",
                            table.manufacturer(row.second),
                            table.part_number(row.second),
                            catalogue::declaration(row.first).name,
                            axes),
                "leave its stock_length empty: then it costs its length by the metre");
}

/// Bars and metres of every code, then what is charged for it.
void StockBars::fill(BarStock& stock, const std::vector<Digit>& digits) {
  struct Value {
    Lengths pieces;
    double alone = 0.0;  // bars, if no other stage cuts from them
  };
  std::vector<std::vector<Value>> values_of;
  for (const Digit& digit : digits) {
    std::vector<Value>& values = values_of.emplace_back(1);
    for (std::size_t value = 1; value < digit.values(); ++value) {
      const bool times = digit.pieces.size() == 1;
      const Lengths& pieces = digit.pieces[times ? 0 : value - 1];
      const std::size_t count = times ? value : 1;
      Value& next = values.emplace_back();
      for (std::size_t i = 0; i < count; ++i) next.pieces.insert(next.pieces.end(), pieces.begin(), pieces.end());
      next.alone = static_cast<double>(count) * bars_for(pieces, stock.size);
    }
  }
  auto& packed = packed_[{stock.size.stock_length, stock.size.cutting_loss, digits}];
  const bool is_known = !packed.empty();
  bool is_shared = false;
  std::vector<std::size_t> value(digits.size(), 0);
  for (std::size_t code = 0, digit = 0; digit < digits.size(); ++code) {
    Lengths all;
    double alone = 0.0;
    for (std::size_t i = 0; i < digits.size(); ++i) {
      const Value& of = values_of[i][value[i]];
      all.insert(all.end(), of.pieces.begin(), of.pieces.end());
      alone += of.alone;
    }
    if (!is_known) {
      const BarPlan plan = cut_from_bars(all, stock.size);
      all_fewest_ = all_fewest_ && plan.is_fewest;
      packed.emplace_back(static_cast<double>(plan.bars.size()), sum_of(all));
    }
    is_shared = is_shared || packed[code].first != alone;
    for (digit = 0; digit < digits.size() && ++value[digit] == digits[digit].values(); ++digit) value[digit] = 0;
  }
  stock.share = std::numeric_limits<double>::infinity();
  for (const auto& [bars, metres] : packed)
    if (metres > 0.0) stock.share = std::min(stock.share, bars / metres);
  for (const auto& [bars, metres] : packed)
    stock.charge.push_back(is_shared ? std::max(0.0, (bars - stock.share * metres) * stock.bar_price) : 0.0);
  stock.summarise();
}

double StockBars::charged(const BarStock& stock, const std::vector<double>& lengths) const {
  return stock.bar_price * (stock.is_shared() ? stock.share * sum_of(lengths) : bars_for(lengths, stock.size));
}

std::optional<std::size_t> StockBars::stock_of(Place place, const PartUse& use) const {
  if (!use.stated.empty() || !(use.length > 0.0)) return std::nullopt;
  const auto found = codes_.find({{use.family, use.row}, place});
  return found == codes_.end() ? std::nullopt : std::optional(found->second.stock);
}

void StockBars::reprice(std::size_t stage, std::vector<SlotTable>& tables) const {
  for (std::size_t slot = 0; slot < tables.size(); ++slot)
    for (std::size_t row = 0; row < tables[slot].rows(); ++row)
      for (PartUse& use : tables[slot].change_parts(row)) {
        const auto stock = stock_of({stage, slot}, use);
        if (!stock) continue;
        const BarStock& from = stocks_[*stock];
        const Lengths lengths = lengths_of(use, axis_of_[stage]);
        const double more = charged(from, lengths) - sum_of(lengths) * from.bar_price / from.size.stock_length;
        use.price += more;
        tables[slot].add_to_price(row, more);
      }
}

std::vector<PieceCount> StockBars::counts(std::size_t stage, std::span<const SlotTable> tables) const {
  std::vector<PieceCount> result;
  for (std::size_t slot = 0; slot < tables.size(); ++slot) {
    std::map<std::size_t, std::vector<double>> of_stock;
    for (std::size_t row = 0; row < tables[slot].rows(); ++row)
      for (const PartUse& use : tables[slot].candidate(row).parts) {
        const auto code =
            use.length > 0.0 && use.stated.empty() ? codes_.find({{use.family, use.row}, {stage, slot}}) : codes_.end();
        if (code == codes_.end()) continue;
        const auto& pieces = found_.at({use.family, use.row}).at({stage, slot});
        const auto which = std::lower_bound(pieces.begin(), pieces.end(), lengths_of(use, axis_of_[stage]));
        std::vector<double>& of_row = of_stock[code->second.stock];
        of_row.resize(tables[slot].rows(), 0.0);
        of_row[row] = code->second.of_pieces[static_cast<std::size_t>(which - pieces.begin())];
      }
    for (auto& [stock, of_row] : of_stock)
      if (stocks_[stock].is_shared()) result.push_back({slot, stocks_[stock].state, std::move(of_row)});
  }
  return result;
}

void StockBarsLedger::take(StockBars::Place place,
                           const std::string& axis,
                           const PartUse& use,
                           const std::vector<Cut>& cuts) {
  const auto stock = bars_.stock_of(place, use);
  if (!stock) return;
  for (const Cut& cut : cuts)
    for (double piece = 0.5; piece < cut.count; piece += 1.0)
      pieces_[*stock].push_back({axis, std::string(use.slot), cut.length});
}

void StockBarsLedger::finish() {
  for (const auto& [index, pieces] : pieces_) {
    const BarStock& stock = bars_.stocks()[index];
    const catalogue::Table& table = catalogue_.table(stock.family);
    BarPurchase purchase{std::string(catalogue::declaration(stock.family).name),
                         std::string(table.manufacturer(stock.row)),
                         std::string(table.part_number(stock.row)),
                         std::string(table.text(catalogue::column(stock.family, "supplier"), stock.row)),
                         stock.size.stock_length,
                         stock.size.cutting_loss,
                         stock.bar_price,
                         {},
                         true};
    std::vector<double> lengths;
    for (const BarPiece& piece : pieces) lengths.push_back(piece.length);
    const BarPlan plan = cut_from_bars(lengths, stock.size);
    purchase.is_fewest = plan.is_fewest;
    for (const auto& bar : plan.bars) {
      CutBar& cut = purchase.bars.emplace_back();
      cut.left_over = stock.size.stock_length;
      for (const std::size_t piece : bar) {
        cut.pieces.push_back(pieces[piece]);
        cut.left_over = std::max(0.0, cut.left_over - lengths[piece] - stock.size.cutting_loss);
      }
    }
    metre_[index] = static_cast<double>(purchase.bars.size()) * stock.bar_price / sum_of(lengths);
    purchases_.push_back(std::move(purchase));
  }
}

double StockBarsLedger::share(StockBars::Place place, const PartUse& use, const std::vector<Cut>& cuts) const {
  const auto stock = bars_.stock_of(place, use);
  if (!stock) return 0.0;
  std::vector<double> lengths;
  for (const Cut& cut : cuts)
    lengths.insert(lengths.end(), static_cast<std::size_t>(std::lround(cut.count)), cut.length);
  return sum_of(lengths) * metre_.at(*stock) - bars_.charged(bars_.stocks()[*stock], lengths);
}

}  // namespace millwright::evaluation
