// SPDX-License-Identifier: Apache-2.0
// The fewest bars that pieces can be cut from, by trying every way of putting them together. For a few pieces.
#pragma once

#include <algorithm>
#include <functional>
#include <vector>

namespace millwright {

inline std::size_t fewest_bars(const std::vector<double>& lengths, double stock, double loss) {
  std::size_t best = lengths.size();
  std::vector<double> used;  // of each bar, the saw's cut behind every piece
  const std::function<void(std::size_t)> put = [&](std::size_t piece) {
    if (piece == lengths.size()) {
      best = std::min(best, used.size());
      return;
    }
    for (std::size_t bar = 0; bar < used.size(); ++bar) {
      const double before = used[bar];
      used[bar] += lengths[piece] + loss;
      if (used[bar] - loss <= stock + 1e-9) put(piece + 1);
      used[bar] = before;
    }
    used.push_back(lengths[piece] + loss);
    put(piece + 1);
    used.pop_back();
  };
  put(0);
  return best;
}

/// By the usual rule: the longest piece next, from the first bar that has room.
inline std::size_t longest_first(std::vector<double> lengths, double stock, double loss) {
  std::sort(lengths.rbegin(), lengths.rend());
  std::vector<double> room;
  for (const double length : lengths) {
    const auto bar = std::find_if(room.begin(), room.end(), [&](double left) { return length <= left + 1e-9; });
    if (bar == room.end())
      room.push_back(stock - length - loss);
    else
      *bar -= length + loss;
  }
  return room.size();
}

}  // namespace millwright
