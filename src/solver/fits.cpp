// SPDX-License-Identifier: Apache-2.0
#include "solver/fits.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace millwright::solver {
namespace {

constexpr std::size_t word_bits = 64;

struct KeyOrder {
  bool operator()(const FitKey& a, const FitKey& b) const {
    return a.first != b.first ? a.first < b.first : a.second < b.second;
  }
};

}  // namespace

Fits::Kinds Fits::kinds_of(const Stage& stage, std::span<const Row> shared, std::size_t slot, std::size_t other) {
  Kinds kinds;
  std::map<FitKey, std::uint32_t, KeyOrder> known;
  auto latest = known.end();  // rows next to each other are mostly of one kind: one screw with many nuts
  for (Row row = 0; row < stage.slots()[slot].rows; ++row) {
    const FitKey key = stage.fit_key(shared, slot, row, other);
    if (latest == known.end() || !(latest->first == key)) {
      bool is_new = false;
      std::tie(latest, is_new) = known.try_emplace(key, static_cast<std::uint32_t>(kinds.first.size()));
      if (is_new) kinds.first.push_back(row);
    }
    kinds.of_row.push_back(latest->second);
  }
  return kinds;
}

template <class Fit>
Fits::Pairs Fits::pairs_of(const Kinds& own, const Kinds& other, Fit&& fit) {
  Pairs pairs;
  pairs.words = (other.first.size() + word_bits - 1) / word_bits;
  pairs.kinds = own.first.size();
  pairs.kind = own.of_row;
  pairs.bits.assign(pairs.kinds * pairs.words, 0);
  for (std::size_t kind = 0; kind < pairs.kinds; ++kind) {
    std::uint64_t* bits = pairs.bits.data() + kind * pairs.words;
    for (std::size_t of_other = 0; of_other < other.first.size(); ++of_other)
      if (fit(kind, of_other)) bits[of_other / word_bits] |= std::uint64_t{1} << (of_other % word_bits);
  }
  return pairs;
}

Fits::Fits(const Stage& stage, std::span<const Row> shared)
    : stage_(&stage), shared_(shared), slots_(stage.slots().size()), pairs_(slots_ * slots_) {
  for (std::size_t a = 0; a < slots_; ++a) {
    for (std::size_t b = a + 1; b < slots_; ++b) {
      if (stage.may_misfit(a, b)) ask(stage, shared, a, b);
    }
  }
  for (std::size_t slot = 0; slot < slots_; ++slot) find_kinds(slot);
}

void Fits::find_kinds(std::size_t slot) {
  std::map<std::vector<std::uint32_t>, std::uint32_t> known;
  std::vector<std::uint32_t> towards_others;
  auto latest = known.end();
  auto& kinds = kinds_.emplace_back();
  for (Row row = 0; row < stage_->slots()[slot].rows; ++row) {
    towards_others.clear();
    for (std::size_t other = 0; other < slots_; ++other)
      if (!pairs(slot, other).bits.empty()) towards_others.push_back(pairs(slot, other).kind[row]);
    if (latest == known.end() || latest->first != towards_others)
      latest = known.try_emplace(towards_others, static_cast<std::uint32_t>(known.size())).first;
    kinds.push_back(latest->second);
  }
}

void Fits::ask(const Stage& stage, std::span<const Row> shared, std::size_t a, std::size_t b) {
  const Kinds kinds_a = kinds_of(stage, shared, a, b);
  const Kinds kinds_b = kinds_of(stage, shared, b, a);
  const std::size_t width = kinds_b.first.size();
  std::vector<bool> fit;
  fit.reserve(kinds_a.first.size() * width);
  for (const Row row_a : kinds_a.first)
    for (const Row row_b : kinds_b.first) fit.push_back(stage.fits(shared, a, row_a, b, row_b));
  if (std::find(fit.begin(), fit.end(), false) == fit.end()) return;
  everything_fits_ = false;
  pairs(a, b) = pairs_of(kinds_a, kinds_b, [&](std::size_t k, std::size_t l) { return fit[k * width + l]; });
  pairs(b, a) = pairs_of(kinds_b, kinds_a, [&](std::size_t l, std::size_t k) { return fit[k * width + l]; });
}

bool Fits::keep_partners(std::span<const std::vector<Row>*> alive,
                         std::vector<std::vector<Row>>& fewer,
                         std::size_t changed,
                         std::size_t other,
                         bool& smaller) const {
  const Pairs& partners = pairs(changed, other);
  if (partners.bits.empty()) return true;
  // Rows of one kind have the same partners, and there are few kinds: sizes, bores, frames.
  thread_local std::vector<bool> seen;
  thread_local std::vector<std::uint64_t> reached;
  seen.assign(partners.kinds, false);
  reached.assign(partners.words, 0);
  for (const Row row : *alive[changed]) {
    const std::uint32_t kind = partners.kind[row];
    if (seen[kind]) continue;
    seen[kind] = true;
    const std::uint64_t* bits = partners.bits.data() + kind * partners.words;
    for (std::size_t w = 0; w < partners.words; ++w) reached[w] |= bits[w];
  }
  const std::vector<std::uint32_t>& kind_of = pairs(other, changed).kind;
  const auto has_partner = [&](Row row) {
    return ((reached[kind_of[row] / word_bits] >> (kind_of[row] % word_bits)) & 1U) != 0;
  };
  const std::vector<Row>& rows = *alive[other];
  std::size_t kept = 0;
  for (const Row row : rows) kept += has_partner(row) ? 1 : 0;
  if (kept == rows.size()) return true;
  if (kept == 0) return false;
  std::vector<Row> rest;
  rest.reserve(kept);
  for (const Row row : rows) {
    if (has_partner(row)) rest.push_back(row);
  }
  fewer[other] = std::move(rest);
  alive[other] = &fewer[other];
  smaller = true;
  return true;
}

bool Fits::narrow(const Region& region, std::size_t changed, std::vector<std::vector<Row>>& fewer) const {
  std::vector<const std::vector<Row>*> alive;
  for (const RowSet& set : region.rows) alive.push_back(&set->all());
  fewer.assign(slots_, {});
  std::vector<bool> pending(slots_, changed >= slots_);
  if (changed < slots_) pending[changed] = true;
  for (bool any = true; any;) {
    any = false;
    for (std::size_t slot = 0; slot < slots_; ++slot) {
      if (!pending[slot]) continue;
      pending[slot] = false;
      for (std::size_t other = 0; other < slots_; ++other) {
        bool smaller = false;
        if (other != slot && !keep_partners(alive, fewer, slot, other, smaller)) return false;
        if (smaller) pending[other] = any = true;
      }
    }
  }
  return true;
}

bool Fits::possible(const Region& region, std::size_t changed) const {
  if (everything_fits_) return true;
  std::vector<std::vector<Row>> fewer;
  return narrow(region, changed, fewer);
}

bool Fits::filter(Region& region, std::size_t changed) const {
  if (everything_fits_) return true;
  std::vector<std::vector<Row>> fewer;
  if (!narrow(region, changed, fewer)) return false;
  for (std::size_t slot = 0; slot < slots_; ++slot)
    if (!fewer[slot].empty()) region.rows[slot] = make_rows(*stage_, shared_, slot, std::move(fewer[slot]));
  return true;
}

}  // namespace millwright::solver
