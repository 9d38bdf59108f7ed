// SPDX-License-Identifier: Apache-2.0
//
// What is still to be looked at, the least first. Nodes of a search are large (a region, its bounds); they stay where
// they are while their keys move about in the heap.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace millwright::solver {

/// Least value first; among equals the younger, which is deeper.
struct DepthFirstKey {
  double value = 0.0;
  std::uint64_t order = 0;
  /// Whether a comes after b.
  static bool later(const DepthFirstKey& a, const DepthFirstKey& b) {
    return a.value != b.value ? a.value > b.value : a.order < b.order;
  }
};

/// `Key::later(a, b)`: whether a comes after b, a strict order.
template <class Node, class Key = DepthFirstKey>
class BestFirst {
 public:
  void push(const Key& key, Node node) {
    std::uint32_t place = 0;
    if (free_.empty()) {
      place = static_cast<std::uint32_t>(nodes_.size());
      nodes_.push_back(std::move(node));
    } else {
      place = free_.back();
      free_.pop_back();
      nodes_[place] = std::move(node);
    }
    heap_.push_back({key, place});
    std::push_heap(heap_.begin(), heap_.end(), Later{});
  }
  /// As the youngest of its value.
  void push(double value, Node node) { push(Key{value, ++order_}, std::move(node)); }

  Node pop() {
    std::pop_heap(heap_.begin(), heap_.end(), Later{});
    const std::uint32_t place = heap_.back().place;
    heap_.pop_back();
    free_.push_back(place);
    return std::move(nodes_[place]);
  }

  [[nodiscard]] bool empty() const { return heap_.empty(); }
  [[nodiscard]] std::size_t size() const { return heap_.size(); }
  /// Of what would be popped next.
  [[nodiscard]] const Key& first_key() const { return heap_.front().key; }
  [[nodiscard]] const Node& first() const { return nodes_[heap_.front().place]; }

  /// Calls `visit(node)` for all, in no order that means anything.
  template <class Visit>
  void for_each(Visit&& visit) {
    for (const Entry& entry : heap_) visit(nodes_[entry.place]);
  }
  template <class Visit>
  void for_each(Visit&& visit) const {
    for (const Entry& entry : heap_) visit(nodes_[entry.place]);
  }

 private:
  struct Entry {
    Key key;
    std::uint32_t place = 0;
  };
  struct Later {
    bool operator()(const Entry& a, const Entry& b) const { return Key::later(a.key, b.key); }
  };
  std::vector<Entry> heap_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> free_;
  std::uint64_t order_ = 0;
};

}  // namespace millwright::solver
