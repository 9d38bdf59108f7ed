// SPDX-License-Identifier: Apache-2.0
#include "solver/undecided_designs.h"

#include <algorithm>

namespace millwright::solver {

std::vector<OpenBox> UndecidedDesigns::boxes(const std::vector<Origin>& origins, const std::vector<Row>& rows) const {
  if (origins.empty() || std::find(origins.begin(), origins.end(), everything) != origins.end()) return {OpenBox{}};
  std::vector<OpenBox> found;
  for (const Origin origin : origins) {
    const auto place = followers_[origin].find(rows);
    if (place != followers_[origin].end()) found.insert(found.end(), place->second.begin(), place->second.end());
  }
  return found;
}

UndecidedDesigns::Origin UndecidedDesigns::add_origin() {
  followers_.emplace_back();
  return static_cast<Origin>(followers_.size() - 1);
}

void UndecidedDesigns::add(Origin origin, const std::vector<Row>& rows, OpenBox box) {
  followers_[origin][rows].push_back(std::move(box));
}

}  // namespace millwright::solver
