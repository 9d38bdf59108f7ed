// SPDX-License-Identifier: Apache-2.0
#include "app/idle_requirements.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "machine/condition_places.h"
#include "machine/requirement.h"

namespace millwright::app {

namespace {

using machine::Places;

/// Figures that checks reckon with; the others are limits, and have checks that name them.
bool is_figure(machine::Requirement requirement) {
  using enum machine::Requirement;
  constexpr std::array figures{position_error_over, mapped_lead_error, start_rate, nut_wear_rate};
  return std::find(figures.begin(), figures.end(), requirement) != figures.end();
}

/// The key that checks name. What a frame may leave of its ringing asks for a natural frequency.
std::string_view named_by_checks(const machine::RequirementDeclaration& declared) {
  return declared.requirement == machine::Requirement::ringing_amplitude ? "frame_natural_frequency" : declared.key;
}

/// Checks of some parts and not of others (sliding nuts, preloaded ball screws, bushings): one that the build lacks may
/// have decided that it has it not.
bool hangs_on_parts(std::string_view id) {
  constexpr std::array<std::string_view, 5> checks{
      "C-SCR-WEAR", "C-SCR-NTURNS", "C-BS-PREMIN", "C-GD-SLOPE", "C-GD-BIND"};
  return std::find(checks.begin(), checks.end(), id) != checks.end();
}

/// Whether a check of the axis is such; of any axis without one.
template <class IsSuch>
bool any_check(const evaluation::Design& design, const machine::Axis* axis, IsSuch&& is_such) {
  return std::any_of(design.checks.begin(), design.checks.end(), [&](const evaluation::Check& check) {
    return (axis == nullptr || check.axis == axis->name || check.axis == "machine") && is_such(check);
  });
}

/// `table`: of requirements, of one axis or of all.
void note_idle(const text::Node* table,
               const machine::Axis* axis,
               const evaluation::Design& design,
               text::Diagnostics& diagnostics) {
  if (table == nullptr || !table->is_table()) return;
  const std::string of = axis == nullptr ? std::string("of this machine") : fmt::format("of axis '{}'", axis->name);
  for (const machine::RequirementDeclaration& declared : machine::requirements()) {
    const text::Node* const value = table->find(declared.key);
    if (value == nullptr || !std::isnan(declared.default_value) || is_figure(declared.requirement)) continue;
    if (any_check(design, axis, [&](const auto& check) { return check.requirement == named_by_checks(declared); }))
      continue;
    diagnostics.warning(value->span(),
                        fmt::format("{}: no check {} reads it", declared.key, of),
                        "leave it out, or add what it limits: " + std::string(declared.meaning));
  }
  const text::Node* const enforced = table->find("enforce");
  if (enforced == nullptr) return;
  const auto note = [&](const text::Node& node) {
    const std::string id = node.as_string().value_or("");
    if (hangs_on_parts(id) || any_check(design, axis, [&](const auto& check) { return check.id == id; })) return;
    diagnostics.warning(
        node.span(), fmt::format("enforce: there is no check {} {}", id, of), "leave it out, or add what it is of");
  };
  if (!enforced->is_array()) return note(*enforced);
  for (const text::Node& node : enforced->items()) note(node);
}

}  // namespace

void note_idle_requirements(const machine::Problem& problem,
                            const text::Document& document,
                            const evaluation::Design& design,
                            text::Diagnostics& diagnostics) {
  const Places places(document);
  note_idle(Places::find(places.root(), {"require"}), nullptr, design, diagnostics);
  for (std::size_t i = 0; i < problem.axes.size(); ++i)
    note_idle(Places::find(places.axis(i), {"require"}), &problem.axes[i], design, diagnostics);
}

}  // namespace millwright::app
