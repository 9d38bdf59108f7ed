// SPDX-License-Identifier: Apache-2.0
#include "evaluation/whole_stage.h"

#include <algorithm>

namespace millwright::evaluation {

ToolStates tool_states(const machine::Problem& problem) {
  ToolStates states;
  if (!problem.tool) return states;
  const std::size_t first = first_load_state + problem.axes.size();
  for (std::size_t i = 0; i < states.compliance.size(); ++i)
    if (problem.tool->deflection && problem.tool->force[i] > 0.0) states.compliance[i] = first + states.count++;
  for (std::size_t i = 0; i < states.error.size(); ++i) {
    const bool travels = std::any_of(problem.axes.begin(), problem.axes.end(), [&](const machine::Axis& axis) {
      return axis.along == i && !machine::is_rotary(axis);
    });
    if (problem.tool->position_error && travels) states.error[i] = first + states.count++;
  }
  return states;
}

WholeStage::WholeStage(const machine::Problem& problem, std::optional<std::size_t> error_resource)
    : data_{.require = problem.require, .tool = problem.tool, .limits = problem.limits},
      states_(tool_states(problem)),
      error_resource_(error_resource) {
  name_ = "machine.whole";
  for (std::size_t i = 0; i < states_.error.size(); ++i) data_.error_counts[i] = states_.error[i].has_value();
  whole_constraints([&](const machine::Declaration& d, auto&&, auto&&, auto&&) {
    constraint_count_ += machine::is_searched(d, data_.require);
  });
}

template <class T>
WholeMachine<T> WholeStage::design(const Selection<T>& s) const {
  WholeMachine<T> d;
  d.data = &data_;
  for (std::size_t i = 0; i < states_.compliance.size(); ++i) {
    if (states_.compliance[i]) d.compliance[i] = s.inherited[*states_.compliance[i]];
    if (states_.error[i]) d.error[i] = s.inherited[*states_.error[i]];
  }
  return d;
}

void WholeStage::set_suppliers(std::vector<Shop> shops) {
  suppliers_ = std::move(shops);
  declared_constraints_ = constraint_count_;
  for (const Shop& shop : suppliers_) constraint_count_ += shop.used_state ? 1 : 0;
}

void WholeStage::set_owned_first(std::vector<OwnedFirst> rules) {
  owned_first_ = std::move(rules);
  constraint_count_ += owned_first_.size();
}

/// What is charged counts among the cost, and where preferred parts are compared otherwise that share of it there.
template <class T>
void WholeStage::pay(const T& charged, double preference, solver::Answer<T>& out) const {
  out.resources[cost_resource] = out.resources[cost_resource] + charged;
  if (compared_resource_ == cost_resource) return;
  out.resources[compared_resource_] = out.resources[compared_resource_] + T(preference) * charged;
}

/// What a shop is paid beside its minimum counts in the floors without that; what is paid to nobody of these in all.
template <class T>
void WholeStage::pay_floors(const T& charged, std::optional<std::size_t> shop, solver::Answer<T>& out) const {
  for (const CostFloor& floor : floors_)
    if (!floor.has(shop)) out.resources[floor.resource] = out.resources[floor.resource] + charged;
}

/// Of the set of suppliers that is chosen.
template <class T>
void WholeStage::charge_orders(const Selection<T>& s, solver::Answer<T>& out) const {
  using scalar::larger;
  std::size_t constraint = declared_constraints_;
  for (std::size_t i = 0; i < suppliers_.size(); ++i) {
    const Shop& shop = suppliers_[i];
    const bool open = ((s.shared[shop_choice] >> i) & 1U) != 0;
    if (shop.used_state)
      out.utilisation[constraint++] = open ? utilisation(T(1.0), s.inherited[*shop.used_state]) : T(0.0);
    if (!open) continue;
    pay(T(shop.shipping_fee), 1.0, out);
    pay_floors(T(shop.shipping_fee), {}, out);
    if (!shop.spent_state) continue;
    for (const CostFloor& floor : floors_)
      if (floor.has(i)) out.resources[floor.resource] = out.resources[floor.resource] + T(shop.minimum_order);
    T spent = s.inherited[*shop.spent_state];
    for (const LateCharge& late : charges_)
      if (late.shop == i) spent = spent + charge(late, s.inherited[late.state]);
    pay(larger(T(0.0), T(shop.minimum_order) - spent), 1.0, out);
  }
}

template <class T>
void WholeStage::check_owned(const Selection<T>& s, solver::Answer<T>& out) const {
  using scalar::larger, scalar::smaller;
  std::size_t constraint = out.utilisation.size() - owned_first_.size();
  for (const OwnedFirst& rule : owned_first_) {
    // In whole pieces: what lies about although it would do for a line.
    const T idle = larger(T(0.0), T(rule.owned - rule.line + 1.0) - s.inherited[rule.taken_state]);
    out.utilisation[constraint++] = T(2.0) * smaller(idle, s.inherited[rule.elsewhere_state]);
  }
}

template <class T>
void WholeStage::answer(const Selection<T>& s, solver::Answer<T>& out) const {
  const WholeMachine<T> d = design(s);
  whole_constraints(UtilisationVisitor<T, WholeMachine<T>>(d, s.kept, out.utilisation));
  for (const LateCharge& late : charges_) {
    const T charged = charge(late, s.inherited[late.state]);
    pay(charged, late.preference, out);
    pay_floors(charged, late.shop, out);
  }
  charge_orders(s, out);
  check_owned(s, out);
  if (!error_resource_) return;
  for (std::size_t i = 0; i < states_.error.size(); ++i)
    if (states_.error[i]) out.resources[*error_resource_] = out.resources[*error_resource_] + tool_error(d, i);
}

template WholeMachine<double> WholeStage::design(const Selection<double>&) const;
// Small enough to be inlined here, and asked for by whoever sees the virtual functions.
template void WholeStage::answer(const Selection<double>&, solver::Answer<double>&) const;
template void WholeStage::answer(const Selection<scalar::Interval>&, solver::Answer<scalar::Interval>&) const;
template void WholeStage::answer(const Selection<scalar::Dual<double, 1>>&,
                                 solver::Answer<scalar::Dual<double, 1>>&) const;
template void WholeStage::answer(const Selection<scalar::Dual<scalar::Interval, 1>>&,
                                 solver::Answer<scalar::Dual<scalar::Interval, 1>>&) const;

template class ElementStage<WholeStage>;

}  // namespace millwright::evaluation
