// SPDX-License-Identifier: Apache-2.0
#include "solver/front_corners.h"

#include <algorithm>

namespace millwright::solver {

FrontCorners::FrontCorners() : corners_(3) { keep({endless, endless, endless}); }

void FrontCorners::keep(const Point& corner) {
  Archive::Name name = static_cast<Archive::Name>(by_name_.size());
  if (gone_.empty()) {
    by_name_.push_back(corner);
  } else {
    name = gone_.back();
    gone_.pop_back();
    by_name_[name] = corner;
  }
  corners_.add(turned(corner), name);
}

void FrontCorners::add(const Point& point) {
  if (!std::ranges::all_of(point, [](double x) { return x < 0.5 * endless; })) return;
  std::vector<Point> cut;
  std::vector<Archive::Name> names;
  corners_.remove_at_most(turned(next(point)), [&](Archive::Name name) {
    cut.push_back(by_name_[name]);
    names.push_back(name);
    return true;
  });
  gone_.insert(gone_.end(), names.begin(), names.end());
  // What is left of a corner is below the point in one of the objectives.
  std::vector<Point> left;
  for (std::size_t k = 0; k < point.size(); ++k)
    for (Point corner : cut) {
      corner[k] = point[k];
      left.push_back(corner);
    }
  const auto within = [](const Point& a, const Point& b) { return a[0] <= b[0] && a[1] <= b[1] && a[2] <= b[2]; };
  for (std::size_t i = 0; i < left.size(); ++i) {
    bool needless = corners_.dominates(turned(left[i]));
    for (std::size_t j = 0; j < left.size() && !needless; ++j)
      needless = i != j && within(left[i], left[j]) && (j < i || !within(left[j], left[i]));
    if (!needless) keep(left[i]);
  }
}

}  // namespace millwright::solver
