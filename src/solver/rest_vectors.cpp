// SPDX-License-Identifier: Apache-2.0
#include "solver/rest_vectors.h"

#include <algorithm>
#include <numeric>
#include <queue>

#include "solver/archive.h"
#include "solver/stage.h"

namespace millwright::solver {
namespace {

/// Of the vectors in some order, a part of it.
struct Cell {
  std::size_t from = 0, to = 0;
  std::size_t coordinate = 0;  ///< in which they are farthest apart
  double extent = 0.0;         ///< there, by the extent of all
  double middle = 0.0;         ///< there

  bool operator<(const Cell& other) const { return extent < other.extent; }
};

/// Vectors cut into ever smaller cells, always the one that is farthest apart.
class Cells {
 public:
  explicit Cells(const VectorSet& all) : all_(all), order_(all.size()), unit_(all.dimensions(), 1.0) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    for (std::size_t d = 0; d < unit_.size(); ++d) {
      const auto [low, high] = range(0, order_.size(), d);
      if (high > low) unit_[d] = high - low;
    }
    cells_.push(measured(0, order_.size()));
  }

  /// Into `most` cells, if there is so much to tell apart; the common lower bound of each.
  VectorSet lower_bounds(std::size_t most) {
    while (cells_.size() < most && cells_.top().extent > 0.0) {
      const Cell cell = cells_.top();
      const auto middle = std::partition(
          place(cell.from), place(cell.to), [&](std::size_t i) { return all_[i][cell.coordinate] <= cell.middle; });
      const auto cut = static_cast<std::size_t>(middle - order_.begin());
      if (cut == cell.to) break;  // neighbouring numbers
      cells_.pop();
      cells_.push(measured(cell.from, cut));
      cells_.push(measured(cut, cell.to));
    }
    VectorSet bounds(all_.dimensions());
    std::vector<double> least(all_.dimensions());
    for (; !cells_.empty(); cells_.pop()) {
      for (std::size_t d = 0; d < least.size(); ++d) least[d] = range(cells_.top().from, cells_.top().to, d).first;
      bounds.add(least);
    }
    return bounds;
  }

 private:
  [[nodiscard]] std::vector<std::size_t>::iterator place(std::size_t at) {
    return order_.begin() + static_cast<std::ptrdiff_t>(at);
  }
  [[nodiscard]] std::pair<double, double> range(std::size_t from, std::size_t to, std::size_t coordinate) const {
    std::pair<double, double> range{infinity, -infinity};
    for (std::size_t i = from; i < to; ++i) {
      range.first = std::min(range.first, all_[order_[i]][coordinate]);
      range.second = std::max(range.second, all_[order_[i]][coordinate]);
    }
    return range;
  }
  [[nodiscard]] Cell measured(std::size_t from, std::size_t to) const {
    Cell cell{from, to};
    for (std::size_t d = 0; d < unit_.size(); ++d) {
      const auto [low, high] = range(from, to, d);
      if (!((high - low) / unit_[d] > cell.extent)) continue;
      cell.extent = (high - low) / unit_[d];
      cell.coordinate = d;
      cell.middle = low + 0.5 * (high - low);
    }
    return cell;
  }

  const VectorSet& all_;
  std::vector<std::size_t> order_;
  std::vector<double> unit_;
  std::priority_queue<Cell> cells_;
};

VectorSet undominated(const VectorSet& all) {
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::lexicographical_compare(all[a].begin(), all[a].end(), all[b].begin(), all[b].end());
  });
  Archive known(all.dimensions());
  VectorSet kept(all.dimensions());
  for (const std::size_t i : order) {
    if (known.dominates(all[i])) continue;
    known.add(all[i]);
    kept.add(all[i]);
  }
  return kept;
}

}  // namespace

std::vector<double> VectorSet::least() const {
  std::vector<double> least(dimensions_, infinity);
  for (std::size_t i = 0; i < values_.size(); ++i) {
    double& coordinate = least[i % dimensions_];
    coordinate = std::min(coordinate, values_[i]);
  }
  return least;
}

VectorSet lower_vectors(const VectorSet& all, std::size_t most) {
  const std::size_t many = 4 * most;  // more are not compared with each other
  VectorSet kept = undominated(all.size() > many ? Cells(all).lower_bounds(many) : all);
  return kept.size() > most ? undominated(Cells(kept).lower_bounds(most)) : kept;
}

VectorSet sum_of_vectors(const VectorSet& a, const VectorSet& b, std::size_t most, const KeepsVector& keep) {
  VectorSet sums(a.dimensions());
  std::vector<double> sum(a.dimensions());
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      for (std::size_t d = 0; d < sum.size(); ++d) sum[d] = a[i][d] + b[j][d];
      if (keep(sum)) sums.add(sum);
    }
  }
  return lower_vectors(sums, most);
}

}  // namespace millwright::solver
