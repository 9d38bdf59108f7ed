// SPDX-License-Identifier: Apache-2.0
//
// Thrown where input is right but asks for what is not offered: what and why, and what to do instead.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace millwright::evaluation {

class Refusal : public std::runtime_error {
 public:
  Refusal(const std::string& what, std::string hint) : std::runtime_error(what), hint_(std::move(hint)) {}
  [[nodiscard]] const std::string& hint() const { return hint_; }

 private:
  std::string hint_;
};

}  // namespace millwright::evaluation
