// SPDX-License-Identifier: Apache-2.0
//
// Where what a problem asks stands in its file.
#pragma once

#include <initializer_list>
#include <string_view>

#include "text/document.h"

namespace millwright::machine {

/// Where things stand in the problem file; the whole file for what is not found.
class Places {
 public:
  explicit Places(const text::Document& document) : document_(document) {}

  [[nodiscard]] const text::Node* root() const { return &document_.root(); }
  [[nodiscard]] const text::Node* axis(std::size_t index) const {
    const text::Node* axes = root()->find("axis");
    return axes != nullptr && index < axes->items().size() ? &axes->items()[index] : nullptr;
  }
  /// Of the value at the end of a chain of keys, if all of it is there.
  [[nodiscard]] static const text::Node* find(const text::Node* node, std::initializer_list<std::string_view> keys) {
    for (const std::string_view key : keys) {
      if (node == nullptr || !node->is_table()) return nullptr;
      node = node->find(key);
    }
    return node;
  }
  [[nodiscard]] text::SourceSpan of(const text::Node* node) const {
    return node != nullptr ? node->span() : document_.root().span();
  }

 private:
  const text::Document& document_;
};

}  // namespace millwright::machine
