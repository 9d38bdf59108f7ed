// SPDX-License-Identifier: Apache-2.0
#include "solver/fits.h"

#include <algorithm>
#include <map>

namespace millwright::solver {
namespace {

constexpr std::size_t word_bits = 64;

void set_bit(std::vector<std::uint64_t>& bits, std::size_t offset, std::size_t index) {
  bits[offset + index / word_bits] |= std::uint64_t{1} << (index % word_bits);
}

}  // namespace

void Fits::Pairs::find_kinds() {
  using Bits = std::span<const std::uint64_t>;
  const auto before = [](Bits a, Bits b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  };
  std::map<Bits, std::uint32_t, decltype(before)> known(before);
  if (words == 0) return;
  const Bits all = bits;
  for (std::size_t from = 0; from < all.size(); from += words)
    kind.push_back(known.try_emplace(all.subspan(from, words), static_cast<std::uint32_t>(known.size())).first->second);
  kinds = known.size();
}

Fits::Fits(const Stage& stage, std::span<const Row> shared)
    : stage_(&stage), shared_(shared), slots_(stage.slots().size()), pairs_(slots_ * slots_) {
  for (std::size_t a = 0; a < slots_; ++a) {
    for (std::size_t b = a + 1; b < slots_; ++b) {
      if (stage.may_misfit(a, b)) ask(stage, shared, a, b);
    }
  }
}

void Fits::ask(const Stage& stage, std::span<const Row> shared, std::size_t a, std::size_t b) {
  const Row rows_a = stage.slots()[a].rows;
  const Row rows_b = stage.slots()[b].rows;
  Pairs forward;
  Pairs backward;
  forward.words = (rows_b + word_bits - 1) / word_bits;
  backward.words = (rows_a + word_bits - 1) / word_bits;
  forward.bits.assign(forward.words * rows_a, 0);
  backward.bits.assign(backward.words * rows_b, 0);
  bool all = true;
  for (Row i = 0; i < rows_a; ++i) {
    for (Row j = 0; j < rows_b; ++j) {
      const bool fit = stage.fits(shared, a, i, b, j);
      all = all && fit;
      if (!fit) continue;
      set_bit(forward.bits, i * forward.words, j);
      set_bit(backward.bits, j * backward.words, i);
    }
  }
  if (all) return;
  everything_fits_ = false;
  forward.find_kinds();
  backward.find_kinds();
  pairs(a, b) = std::move(forward);
  pairs(b, a) = std::move(backward);
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
    const std::uint64_t* bits = partners.bits.data() + row * partners.words;
    for (std::size_t w = 0; w < partners.words; ++w) reached[w] |= bits[w];
  }
  const auto has_partner = [&](Row row) { return ((reached[row / word_bits] >> (row % word_bits)) & 1U) != 0; };
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
