// SPDX-License-Identifier: Apache-2.0
#include "catalogue/siblings.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace millwright::catalogue {
namespace {

/// Numbers in order of which one is passed over.
struct Others {
  std::span<const float> all;
  std::size_t passed;  ///< = all.size(): none

  std::size_t size() const { return all.size() - (passed < all.size() ? 1 : 0); }
  double at(std::size_t i) const { return static_cast<double>(all[i < passed ? i : i + 1]); }
  /// Where a share of them lies below, between two neighbours if need be.
  double quantile(double share) const {
    const double position = share * static_cast<double>(size() - 1);
    const auto below = static_cast<std::size_t>(position);
    const double rest = position - static_cast<double>(below);
    return rest == 0.0 ? at(below) : at(below) * (1.0 - rest) + at(below + 1) * rest;
  }
};

/// Nothing if they are too few.
std::optional<Siblings::View> view_of(const Others& others) {
  const std::size_t count = others.size();
  if (count < Siblings::needed) return std::nullopt;
  // The middle half, or 85 % where most agree to the digit; of a normal scatter both give the same.
  const double middle = (others.quantile(0.75) - others.quantile(0.25)) / 1.349;
  const double wide = (others.quantile(0.925) - others.quantile(0.075)) / 2.88;
  const double few = 1.0 + 2.0 / static_cast<double>(count);
  return Siblings::View{others.quantile(0.5), few * std::max(middle, wide), count};
}

constexpr std::uint32_t none = 0xffffffff;

}  // namespace

void Siblings::add_group(std::vector<std::vector<float>>& seen, bool sampled) {
  view_of_.push_back(sampled ? static_cast<std::uint32_t>(views_.size()) : none);
  for (std::vector<float>& each : seen) {
    std::sort(each.begin(), each.end());
    if (sampled)
      views_.push_back(view_of({each, each.size()}));
    else if (each.size() > needed)
      values_.insert(values_.end(), each.begin(), each.end());
    ends_.push_back(static_cast<std::uint32_t>(values_.size()));
    each.clear();
  }
}

std::optional<Siblings::View> Siblings::without(std::uint32_t group, std::size_t relation, double own) const {
  if (std::isnan(own)) return std::nullopt;
  if (view_of_[group] != none) return views_[view_of_[group] + relation];
  const std::size_t at = group * relations_ + relation;
  const std::size_t begin = at == 0 ? 0 : ends_[at - 1];
  const std::span<const float> all(values_.data() + begin, ends_[at] - begin);
  if (all.empty()) return std::nullopt;
  const auto mine = std::lower_bound(all.begin(), all.end(), static_cast<float>(own));
  const bool among = mine != all.end() && *mine == static_cast<float>(own);
  return view_of({all, among ? static_cast<std::size_t>(mine - all.begin()) : all.size()});
}

}  // namespace millwright::catalogue
