// SPDX-License-Identifier: Apache-2.0
//
// What is asked of the machine as a whole: how far the tool gives way, its limits, and what is to be paid for parts
// whose price depends on how many are taken, and for orders beside what is ordered. The last stage, without slots; the
// limits are the solver's own, here they are only reported.
#pragma once

#include <array>

#include "evaluation/axis_place.h"
#include "evaluation/element_stage.h"
#include "evaluation/owned_first.h"
#include "machine/problem.h"
#include "mechanics/tool_point.h"

namespace millwright::evaluation {

struct WholeData {
  machine::Requirements require;
  std::optional<machine::Tool> tool;
  machine::QuantityLimits limits;
  std::array<bool, 3> error_counts{};  ///< along x, y and z
};

template <class T>
struct WholeMachine {
  const WholeData* data = nullptr;
  std::array<T, 3> compliance{};  ///< m/N, of axes and structure along x, y and z
  std::array<T, 3> error{};       ///< m, of the axes along x, y and z
  /// By quantity, of a finished design; the search does not fill them in.
  std::array<T, machine::quantity_count> totals{};
};

ToolStates tool_states(const machine::Problem& problem);

/// Deflection of the tool in one direction [m]: of the machine, and of the tool itself in its holder.
template <class T>
T tool_deflection(const WholeMachine<T>& d, std::size_t direction) {
  using namespace scalar;
  const machine::Tool& tool = *d.data->tool;
  const T own = in_unit<T>(1.0 / tool.stiffness, dimension::none / dimension::stiffness);
  return mechanics::tool_point::deflection(in_unit<T>(tool.force[direction], dimension::force),
                                           T(d.compliance[direction] + own));
}

/// Position error at the tool in one direction [m]: of the axes along it, and what gives way.
template <class T>
T tool_error(const WholeMachine<T>& d, std::size_t direction) {
  return d.error[direction] + tool_deflection(d, direction);
}

/// Limits of the whole machine. The solver holds them itself.
template <class Visit>
void limits_of_machine(Visit& visit) {
  using machine::Applies;
  using machine::Declaration;
  using machine::Quantity;
  const auto limit = [&visit]<Quantity quantity>(
                         Declaration declaration, std::integral_constant<Quantity, quantity>, auto dimension) {
    declaration.id = machine::declaration(quantity).limit_id;
    declaration.held_by_limit = true;
    visit(
        declaration,
        [](const auto& d) { return d.data->limits[quantity] ? Applies::yes : Applies::no; },
        [](const auto& d) { return d.totals[static_cast<std::size_t>(quantity)]; },
        [dimension](const auto& d) {
          using T = std::remove_cvref_t<decltype(d.totals.front())>;
          return scalar::in_unit<T>(*d.data->limits[quantity], dimension);
        });
  };
  using std::integral_constant;
  limit(Declaration{.title = "Cost of everything chosen",
                    .symbol = "K",
                    .unit = "1",
                    .source = "millwright_derivations, sum of prices"},
        integral_constant<Quantity, Quantity::cost>{},
        scalar::dimension::none);
  limit(Declaration{.title = "Mass of everything chosen",
                    .symbol = "m",
                    .unit = "kg",
                    .source = "millwright_derivations, sum of masses"},
        integral_constant<Quantity, Quantity::mass>{},
        scalar::dimension::mass);
  limit(Declaration{.title = "Time of the machine's cycle",
                    .symbol = "t",
                    .unit = "s",
                    .source = "millwright_derivations, sum of the times of all moves"},
        integral_constant<Quantity, Quantity::cycle_time>{},
        scalar::dimension::time);
  limit(Declaration{.title = "Energy of the machine's cycle, estimated",
                    .symbol = "E",
                    .unit = "J",
                    .source = "millwright_derivations, losses and work of all drives"},
        integral_constant<Quantity, Quantity::energy>{},
        scalar::dimension::energy);
  limit(Declaration{.title = "Position errors of the machine together",
                    .symbol = "e",
                    .unit = "um",
                    .source = "millwright_derivations, sum of position errors"},
        integral_constant<Quantity, Quantity::position_error>{},
        scalar::dimension::length);
}

template <class Visit>
void whole_constraints(Visit&& visit) {
  using machine::Applies;
  using machine::Declaration;
  const auto at_tool =
      [&visit](Declaration declaration, auto applies, auto demand, std::optional<double> machine::Tool::*limit) {
        declaration.unit = "um";
        declaration.source = "slocum1992, chapter 2";
        declaration.place = machine::WorstPlace::travel_ends;
        visit(declaration, applies, demand, [limit](const auto& d) {
          using T = std::remove_cvref_t<decltype(d.totals.front())>;
          return scalar::in_unit<T>((*d.data->tool.*limit).value(), scalar::dimension::length);
        });
      };
  const auto deflection = [&]<std::size_t direction>(Declaration declaration,
                                                     std::integral_constant<std::size_t, direction>) {
    declaration.symbol = "\u03b4";
    at_tool(
        declaration,
        [](const auto& d) {
          const auto& tool = d.data->tool;
          return tool && tool->deflection && tool->force[direction] > 0.0 ? Applies::yes : Applies::no;
        },
        [](const auto& d) { return tool_deflection(d, direction); },
        &machine::Tool::deflection);
  };
  const auto error = [&]<std::size_t direction>(Declaration declaration,
                                                std::integral_constant<std::size_t, direction>) {
    declaration.symbol = "e";
    at_tool(
        declaration,
        [](const auto& d) { return d.data->error_counts[direction] ? Applies::yes : Applies::no; },
        [](const auto& d) { return tool_error(d, direction); },
        &machine::Tool::position_error);
  };
  using std::integral_constant;
  deflection(Declaration{.id = "C-TOOL-DEFL-X", .title = "Tool gives way along x"},
             integral_constant<std::size_t, 0>{});
  deflection(Declaration{.id = "C-TOOL-DEFL-Y", .title = "Tool gives way along y"},
             integral_constant<std::size_t, 1>{});
  deflection(Declaration{.id = "C-TOOL-DEFL-Z", .title = "Tool gives way along z"},
             integral_constant<std::size_t, 2>{});
  error(Declaration{.id = "C-TOOL-ERROR-X", .title = "Position error at the tool along x"},
        integral_constant<std::size_t, 0>{});
  error(Declaration{.id = "C-TOOL-ERROR-Y", .title = "Position error at the tool along y"},
        integral_constant<std::size_t, 1>{});
  error(Declaration{.id = "C-TOOL-ERROR-Z", .title = "Position error at the tool along z"},
        integral_constant<std::size_t, 2>{});
  limits_of_machine(visit);
}

class WholeStage final : public ElementStage<WholeStage> {
 public:
  static constexpr bool compares_itself = true;

  /// `error_resource`: where the tool's position error is counted, if an objective asks for it.
  explicit WholeStage(const machine::Problem& problem, std::optional<std::size_t> error_resource = {});

  /// What is charged here for what all stages have counted; before the stage is asked for the first time.
  void set_charges(std::vector<LateCharge> charges) { charges_ = std::move(charges); }

  /// Whose shipping and minimum is charged here; before the stage is asked for the first time.
  void set_suppliers(std::vector<Shop> shops);

  /// Floors of the cost, after set_suppliers().
  void set_floors(std::vector<CostFloor> floors) { floors_ = std::move(floors); }

  /// What must not be bought while it is owned; after set_suppliers().
  void set_owned_first(std::vector<OwnedFirst> rules);

  /// The constraints on the machine; behind them stand those on orders and on what is owned.
  [[nodiscard]] std::size_t declared_constraints() const { return declared_constraints_; }

  template <class T>
  [[nodiscard]] WholeMachine<T> design(const Selection<T>& selection) const;
  template <class T>
  void answer(const Selection<T>& selection, solver::Answer<T>& out) const;

 private:
  WholeData data_;
  ToolStates states_;
  std::optional<std::size_t> error_resource_;
  std::vector<LateCharge> charges_;
  std::vector<Shop> suppliers_;
  std::vector<CostFloor> floors_;
  std::vector<OwnedFirst> owned_first_;
  std::size_t declared_constraints_ = 0;  ///< those of suppliers and of what is owned stand behind them

  template <class T>
  void pay(const T& charged, double preference, solver::Answer<T>& out) const;
  template <class T>
  void pay_floors(const T& charged, std::optional<std::size_t> shop, solver::Answer<T>& out) const;
  template <class T>
  void charge_orders(const Selection<T>& selection, solver::Answer<T>& out) const;
  template <class T>
  void check_owned(const Selection<T>& selection, solver::Answer<T>& out) const;
};

extern template WholeMachine<double> WholeStage::design(const Selection<double>&) const;

extern template class ElementStage<WholeStage>;

}  // namespace millwright::evaluation
