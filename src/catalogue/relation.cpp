// SPDX-License-Identifier: Apache-2.0
#include "catalogue/relation.h"

#include "catalogue/relations_drive.h"
#include "catalogue/relations_electric.h"
#include "catalogue/relations_material.h"
#include "catalogue/relations_structure.h"

namespace millwright::catalogue {

std::span<const Relation> relations(Family family) {
  switch (family) {
    case Family::steppers:
      return detail::stepper_relations;
    case Family::stepper_curves:
      return detail::curve_relations;
    case Family::ball_screws:
      return detail::ball_screw_relations;
    case Family::lead_screws:
      return detail::lead_screw_relations;
    case Family::lead_nuts:
      return detail::lead_nut_relations;
    case Family::threads:
      return detail::thread_relations;
    case Family::screws:
      return detail::fastener_relations;
    case Family::support_bearings:
      return detail::bearing_relations;
    case Family::couplings:
      return detail::coupling_relations;
    case Family::linear_guides:
      return detail::guide_relations;
    case Family::belts:
      return detail::belt_relations;
    case Family::pulleys:
      return detail::pulley_relations;
    case Family::racks:
      return detail::rack_relations;
    case Family::pinions:
      return detail::pinion_relations;
    case Family::drivers:
      return detail::driver_relations;
    case Family::power_supplies:
      return detail::supply_relations;
    case Family::extrusions:
      return detail::extrusion_relations;
    case Family::steel_sections:
      return detail::section_relations;
    case Family::materials:
      return detail::material_relations;
  }
  return {};
}

}  // namespace millwright::catalogue
