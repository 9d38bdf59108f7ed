// SPDX-License-Identifier: Apache-2.0
#include "evaluation/cuts.h"

namespace millwright::evaluation {

namespace {

const machine::Axis* axis_named(const machine::Problem& problem, const std::string& name) {
  for (const machine::Axis& axis : problem.axes)
    if (axis.name == name) return &axis;
  return nullptr;
}

const machine::Member* member_named(const machine::Axis& axis, std::string_view name) {
  for (const machine::Member& member : axis.members)
    if (member.name == name) return &member;
  return nullptr;
}

}  // namespace

std::vector<Cut> cuts_of(const machine::Problem& problem, const PartUse& use, const std::string& axis_name) {
  if (use.length <= 0.0 || use.family == catalogue::Family::racks) return {};  // racks are joined of whole pieces
  const machine::Axis* axis = axis_named(problem, axis_name);
  if (axis == nullptr) return {{use.pieces(), use.length}};
  if (use.family == catalogue::Family::linear_guides) return {{axis->guide ? axis->guide->rails : 1.0, use.length}};
  const machine::Member* member = member_named(*axis, use.slot);
  if (member == nullptr) return {{use.pieces(), use.length}};
  if (member->kind == machine::MemberKind::portal_frame)
    return {{use.pieces(), member->length}, {2.0 * use.pieces(), member->column_height}};
  return {{use.pieces(), use.length, member->plate_width}};
}

double machined_ends(const machine::Axis& axis) { return axis.mechanism.ends == machine::Ends::fixed_free ? 1.0 : 2.0; }

}  // namespace millwright::evaluation
