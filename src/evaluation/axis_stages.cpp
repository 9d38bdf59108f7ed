// SPDX-License-Identifier: Apache-2.0
#include "evaluation/axis_stages.h"

#include <algorithm>
#include <limits>

#include "evaluation/machine_stages.h"

namespace millwright::evaluation {

using machine::Held;
using machine::Member;
using machine::MemberKind;

namespace {

std::size_t add_state(std::vector<double>& first_state) {
  first_state.push_back(0.0);
  return first_state.size() - 1;
}

class AxisStages {
 public:
  AxisStages(const machine::Axis& axis,
             AxisPlace place,
             const std::vector<double>& supply_voltages,
             const catalogue::Catalogue& catalogue,
             const PriceBook& prices)
      : axis_(axis), place_(place), supply_voltages_(supply_voltages), catalogue_(catalogue), prices_(prices) {}

  std::vector<StageEntry> run(std::vector<double>& first_state) {
    if (!joints_of(Held::carriage).empty()) place_.carriage_state = add_state(first_state);
    if (!joints_of(Held::motor).empty()) {
      place_.motor_force_state = add_state(first_state);
      place_.motor_torque_state = add_state(first_state);
    }
    // What rides burdens the guide; what stands carries the carriages too.
    add_members(true);
    if (axis_.guide) add(std::make_unique<GuideStage>(axis_, place_, catalogue_, prices_), "guide");
    add_joints_of(Held::carriage);
    add_members(false);
    switch (axis_.mechanism.kind) {
      case machine::MechanismKind::screw:
        add_drive<ScrewDriveStage>();
        break;
      case machine::MechanismKind::belt:
        add_drive<BeltDriveStage>();
        break;
      case machine::MechanismKind::rack:
        add_drive<RackDriveStage>();
        break;
      case machine::MechanismKind::rotary:
        add_drive<RotaryDriveStage>();
        break;
    }
    return std::move(entries_);
  }

 private:
  template <class Stage>
  Stage& add(std::unique_ptr<Stage> stage, const std::string& element) {
    Stage& added = *stage;
    entries_.push_back({axis_.name, element, std::move(stage)});
    return added;
  }

  [[nodiscard]] std::vector<const Member*> joints_of(Held held) const {
    std::vector<const Member*> result;
    for (const Member& member : axis_.members)
      if (member.kind == MemberKind::bolts && member.bolts.holds == held) result.push_back(&member);
    return result;
  }

  const BoltStage& add_joint(const Member& member, bool is_last) {
    return add(std::make_unique<BoltStage>(axis_, member, place_, is_last, catalogue_, prices_), member.name);
  }

  std::vector<const BoltStage*> add_joints_of(Held held) {
    const std::vector<const Member*> joints = joints_of(held);
    std::vector<const BoltStage*> result;
    for (const Member* joint : joints) result.push_back(&add_joint(*joint, joint == joints.back()));
    return result;
  }

  void add_members(bool riding) {
    for (const Member& member : axis_.members) {
      if (member.rides != riding) continue;
      if (member.kind != MemberKind::bolts)
        add(std::make_unique<MemberStage>(axis_, member, place_, catalogue_, prices_), member.name);
      else if (member.bolts.holds == Held::burden)
        add_joint(member, true);
    }
  }

  template <class Stage>
  void add_drive() {
    Stage& drive = add(std::make_unique<Stage>(axis_, place_, supply_voltages_, catalogue_, prices_), "drive");
    const std::vector<const BoltStage*> joints = add_joints_of(Held::motor);
    if (joints.empty()) return;
    double harmless = std::numeric_limits<double>::infinity();
    for (const BoltStage* joint : joints)
      harmless = std::min(harmless, joint->harmless_force(drive.largest_flange_torque()));
    drive.set_harmless_motor_force(harmless);
  }

  const machine::Axis& axis_;
  AxisPlace place_;
  const std::vector<double>& supply_voltages_;
  const catalogue::Catalogue& catalogue_;
  const PriceBook& prices_;
  std::vector<StageEntry> entries_;
};

}  // namespace

std::vector<StageEntry> axis_stages(const machine::Axis& axis,
                                    AxisPlace place,
                                    const std::vector<double>& supply_voltages,
                                    const catalogue::Catalogue& catalogue,
                                    const PriceBook& prices,
                                    std::vector<double>& first_state) {
  return AxisStages(axis, place, supply_voltages, catalogue, prices).run(first_state);
}

}  // namespace millwright::evaluation
