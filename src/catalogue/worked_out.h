// SPDX-License-Identifier: Apache-2.0
// What is worked out of an object when it is first asked for, since many are never asked, and then kept.
#pragma once

#include <memory>
#include <mutex>

namespace millwright::catalogue {

/// A copy of the object has the same value, but shares no lock. Several threads may ask at a time.
template <class Value>
class WorkedOut {
 public:
  WorkedOut() = default;
  WorkedOut(const WorkedOut& other) : value_(other.known()) {}
  WorkedOut& operator=(const WorkedOut& other) {
    if (this != &other) value_ = other.known();
    return *this;
  }
  ~WorkedOut() = default;

  /// The object changed.
  void forget() { value_ = nullptr; }

  /// The value; `make()` makes it if it is not known.
  template <class Make>
  std::shared_ptr<const Value> get(Make&& make) const {
    const std::lock_guard lock(mutex_);
    if (!value_) value_ = std::make_shared<const Value>(make());
    return value_;
  }

 private:
  [[nodiscard]] std::shared_ptr<const Value> known() const {
    const std::lock_guard lock(mutex_);
    return value_;
  }

  mutable std::mutex mutex_;
  mutable std::shared_ptr<const Value> value_;
};

}  // namespace millwright::catalogue
