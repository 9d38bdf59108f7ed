// SPDX-License-Identifier: Apache-2.0
#include "solver/fits.h"

namespace millwright::solver {
namespace {

constexpr std::size_t word_bits = 64;

void set_bit(std::vector<std::uint64_t>& bits, std::size_t offset, std::size_t index) {
  bits[offset + index / word_bits] |= std::uint64_t{1} << (index % word_bits);
}

}  // namespace

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
  Pairs forward{(rows_b + word_bits - 1) / word_bits, {}};
  Pairs backward{(rows_a + word_bits - 1) / word_bits, {}};
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
  pairs(a, b) = std::move(forward);
  pairs(b, a) = std::move(backward);
}

bool Fits::keep_partners(Region& region, std::size_t changed, std::size_t other, bool& smaller) const {
  const Pairs& partners = pairs(other, changed);
  if (partners.bits.empty()) return true;
  thread_local std::vector<std::uint64_t> alive;
  alive.assign(partners.words, 0);
  for (const Row row : *region.rows[changed]) set_bit(alive, 0, row);
  const auto has_partner = [&](Row row) {
    const std::uint64_t* bits = partners.bits.data() + row * partners.words;
    for (std::size_t w = 0; w < partners.words; ++w) {
      if ((bits[w] & alive[w]) != 0) return true;
    }
    return false;
  };
  const std::vector<Row>& rows = region.rows[other]->all();
  std::size_t kept = 0;
  for (const Row row : rows) kept += has_partner(row) ? 1 : 0;
  if (kept == rows.size()) return true;
  if (kept == 0) return false;
  std::vector<Row> rest;
  rest.reserve(kept);
  for (const Row row : rows) {
    if (has_partner(row)) rest.push_back(row);
  }
  region.rows[other] = make_rows(*stage_, shared_, other, std::move(rest));
  smaller = true;
  return true;
}

bool Fits::filter(Region& region, std::size_t changed) const {
  if (everything_fits_) return true;
  std::vector<bool> pending(slots_, changed >= slots_);
  if (changed < slots_) pending[changed] = true;
  for (bool any = true; any;) {
    any = false;
    for (std::size_t slot = 0; slot < slots_; ++slot) {
      if (!pending[slot]) continue;
      pending[slot] = false;
      for (std::size_t other = 0; other < slots_; ++other) {
        bool smaller = false;
        if (other != slot && !keep_partners(region, slot, other, smaller)) return false;
        if (smaller) pending[other] = any = true;
      }
    }
  }
  return true;
}

}  // namespace millwright::solver
