// SPDX-License-Identifier: Apache-2.0
//
// A stage that says what another one does. Derived ones say something else, or count who asks.
#pragma once

#include <vector>

#include "solver/stage.h"

namespace zoo {

using namespace millwright::solver;

class ForwardingStage : public Stage {
 public:
  explicit ForwardingStage(const Stage& inner) : inner_(inner) {}

  [[nodiscard]] const std::string& name() const override { return inner_.name(); }
  [[nodiscard]] std::span<const Slot> slots() const override { return inner_.slots(); }
  [[nodiscard]] std::span<const Variable> variables() const override { return inner_.variables(); }
  [[nodiscard]] std::size_t constraints() const override { return inner_.constraints(); }
  void evaluate(const Point& point, Answer<double>& answer) const override { inner_.evaluate(point, answer); }
  void read(std::span<const Row> shared,
            std::size_t slot,
            std::span<const Row> rows,
            std::vector<Interval>& readings) const override {
    inner_.read(shared, slot, rows, readings);
  }
  void bound(const Box& box, Answer<Interval>& answer) const override { inner_.bound(box, answer); }
  void slopes(const Box& box, Input input, Answer<Interval>& answer) const override {
    inner_.slopes(box, input, answer);
  }
  void gradient(const Point& point, Input input, Answer<double>& answer) const override {
    inner_.gradient(point, input, answer);
  }
  [[nodiscard]] std::size_t graded_readings(std::size_t slot) const override { return inner_.graded_readings(slot); }
  [[nodiscard]] std::size_t row_kind(std::size_t slot, Row row) const override { return inner_.row_kind(slot, row); }
  [[nodiscard]] bool offered(std::span<const Row> shared, std::size_t slot, Row row) const override {
    return inner_.offered(shared, slot, row);
  }
  [[nodiscard]] bool fits(
      std::span<const Row> shared, std::size_t slot_a, Row row_a, std::size_t slot_b, Row row_b) const override {
    return inner_.fits(shared, slot_a, row_a, slot_b, row_b);
  }

 protected:
  const Stage& inner_;
};

}  // namespace zoo
