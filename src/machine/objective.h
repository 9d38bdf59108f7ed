// SPDX-License-Identifier: Apache-2.0
//
// What a design is judged by: quantities that add up over the parts of a machine, or a weighted sum of them such as
// "cost + 25*mass". A weight is a plain number per unit of its quantity: currency unit, kg, s, J, m.
//
// cycle_time: the machine's cycle is every move of every axis once, with its dwell, one after the other; where gravity
// acts on an axis, its moves are done up and down, and the other axes of its coordinated moves go there and back. A
// coordinated move counts on one of its axes. So it is the sum over the axes of the time of their own moves.
//
// energy: what the drives take from the supply while their own axis goes through its cycle, an estimate by the motor's
// loss model (drive_energy.h). What motors take to stand still while other axes move is not in it.
//
// position_error: the sum of the error budgets (C-ACC-TOTAL) of all axes that travel along a length; where [tool]
// states a position error, that of the tool (C-TOOL-ERROR) along x, y and z together.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace millwright::machine {

enum class Quantity { cost, mass, cycle_time, energy, position_error };
inline constexpr std::size_t quantity_count = 5;

struct QuantityDeclaration {
  Quantity quantity;
  std::string_view name;
  std::string_view unit;           ///< SI; empty for the currency of the problem
  std::string_view best;           ///< "Cheapest"
  std::string_view better;         ///< "is cheaper"
  std::string_view meaning;        ///< of a limit
  std::string_view limit_id;       ///< of the check of a limit
  std::string_view limit_example;  ///< with its unit; without the currency of the problem
};

/// All of them, in the order of the enumeration.
std::span<const QuantityDeclaration> quantities();
const QuantityDeclaration& declaration(Quantity quantity);

/// The quantity of this name, if there is one.
std::optional<Quantity> quantity_named(std::string_view name);

/// Whether a check of this id is that of a limit of the whole machine.
bool is_limit_of_machine(std::string_view check_id);

/// What the whole machine may take at most of each quantity: SI, of the cost in the currency of the problem; nothing
/// where there is no limit.
class QuantityLimits {
 public:
  std::optional<double>& operator[](Quantity quantity) { return values_[static_cast<std::size_t>(quantity)]; }
  const std::optional<double>& operator[](Quantity quantity) const {
    return values_[static_cast<std::size_t>(quantity)];
  }
  /// Whether any is there.
  [[nodiscard]] bool any() const;

 private:
  std::array<std::optional<double>, quantity_count> values_;
};

struct ObjectiveTerm {
  double weight = 1.0;  ///< per unit of the quantity, above 0
  Quantity quantity = Quantity::cost;
};

struct Objective {
  std::vector<ObjectiveTerm> terms;
  /// "mass", "cost + 25*mass"
  [[nodiscard]] std::string name() const;
  /// The quantity, where there is only one and it has no weight.
  [[nodiscard]] std::optional<Quantity> single() const;
  /// Whether the quantity is among the terms.
  [[nodiscard]] bool counts(Quantity quantity) const;
};

/// What is wrong with a text that should be an objective, and where: `length` bytes from byte `offset`.
struct ObjectiveFault {
  std::size_t offset = 0;
  std::size_t length = 0;
  std::string message, hint;
};

/// "cost", "cost + 25*mass": quantities, each at most once, with weights above 0. Blanks are free.
std::optional<Objective> parse_objective(std::string_view text, ObjectiveFault& fault);

/// The objective of a name that `parse_objective` understands; throws std::invalid_argument if it does not.
Objective objective_named(const std::string& name);

/// What objectives of these names ask for beside cost and mass.
std::vector<Quantity> counted_quantities(const std::vector<std::string>& names);

}  // namespace millwright::machine
