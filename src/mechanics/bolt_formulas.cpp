// SPDX-License-Identifier: Apache-2.0
#include "mechanics/bolt.h"
#include "mechanics/formula_definition.h"

namespace millwright::mechanics {

void define_bolt(FormulaList& list) {
  define(
      list,
      {.name = "bolt.stress_area",
       .handbook_id = "BOLT-STRESS-AREA",
       .symbol = "A_t",
       .unit = "m^2",
       .title = "Tensile stress area of a metric thread",
       .source = "iso898_1",
       .validity = "ISO metric thread"},
      [](const auto&... x) { return bolt::stress_area(x...); },
      quantity("diameter", "d", "m", "nominal diameter").typical(3e-3, 0.03).rising(),
      quantity("pitch", "p", "m", "pitch (ISO metric)").typical(5e-4, 3e-3).falling());

  define(
      list,
      {.name = "bolt.preload",
       .handbook_id = "BOLT-PRELOAD",
       .symbol = "F_i",
       .unit = "N",
       .title = "Preload as a share of the proof load",
       .source = "shigley, 8-9",
       .validity = "ISO metric thread, elastic joint, equal bolts"},
      [](const auto&... x) { return bolt::preload(x...); },
      quantity("stress_area", "A_t", "m^2", "stress area").rising(),
      quantity("proof_strength", "S_p", "Pa", "proof strength").rising(),
      quantity("proof_fraction", "f_p", "1", "fraction of proof load (0.75 reusable, 0.90 permanent)")
          .between(0, 1)
          .typical(0.5, 0.9)
          .rising());

  define(
      list,
      {.name = "bolt.tightening_torque",
       .handbook_id = "BOLT-TORQUE",
       .symbol = "T",
       .unit = "N.m",
       .title = "Tightening torque",
       .source = "shigley, chapter 8",
       .validity = "ISO metric thread, elastic joint, equal bolts"},
      [](const auto&... x) { return bolt::tightening_torque(x...); },
      quantity("nut_factor", "K", "1", "nut factor (0.20 dry, 0.15 lubricated)").typical(0.1, 0.3).rising(),
      quantity("preload", "F_i", "N", "preload").rising(),
      quantity("diameter", "d", "m", "nominal diameter").rising());

  define(
      list,
      {.name = "bolt.preload_of_torque",
       .symbol = "F_i",
       .unit = "N",
       .title = "Preload that a tightening torque gives",
       .source = "shigley, chapter 8",
       .validity = "ISO metric thread, elastic joint, equal bolts"},
      [](const auto&... x) { return bolt::preload_of_torque(x...); },
      quantity("tightening_torque", "T", "N.m", "tightening torque").rising(),
      quantity("nut_factor", "K", "1", "nut factor (0.20 dry, 0.15 lubricated)").typical(0.1, 0.3).falling(),
      quantity("diameter", "d", "m", "nominal diameter").falling());

  define(
      list,
      {.name = "bolt.joint_constant",
       .handbook_id = "BOLT-JOINT-CONSTANT",
       .symbol = "C",
       .unit = "1",
       .title = "Share of an external tension that the bolt feels",
       .source = "shigley, chapter 8",
       .validity = "ISO metric thread, elastic joint, equal bolts"},
      [](const auto&... x) { return bolt::joint_constant(x...); },
      quantity("bolt_stiffness", "k_b", "N/m", "bolt stiffness").rising(),
      quantity("member_stiffness", "k_m", "N/m", "stiffness of the clamped members").falling());

  define(
      list,
      {.name = "bolt.largest_tension",
       .handbook_id = "BOLT-MAX-TENSION",
       .symbol = "F_b",
       .unit = "N",
       .title = "Tension in a preloaded bolt under an external force",
       .source = "shigley, chapter 8",
       .validity = "ISO metric thread, elastic joint, equal bolts"},
      [](const auto&... x) { return bolt::largest_tension(x...); },
      quantity("preload", "F_i", "N", "preload").rising(),
      quantity("joint_constant", "C_j", "1", "joint constant").between(0, 0.99).typical(0.1, 0.4).rising(),
      quantity("external_tension", "P", "N", "external tension per bolt").rising());

  define(
      list,
      {.name = "bolt.separation_safety",
       .handbook_id = "BOLT-SEPARATION-SAFETY",
       .symbol = "n_0",
       .unit = "1",
       .title = "Margin of the preload against opening of the joint",
       .source = "shigley, chapter 8",
       .validity = "ISO metric thread, elastic joint, equal bolts"},
      [](const auto&... x) { return bolt::separation_safety(x...); },
      quantity("preload", "F_i", "N", "preload").rising(),
      quantity("joint_constant", "C_j", "1", "joint constant").between(0, 0.99).typical(0.1, 0.4).rising(),
      quantity("external_tension", "P", "N", "external tension per bolt").falling());

  define(
      list,
      {.name = "bolt.proof_safety",
       .handbook_id = "BOLT-PROOF-SAFETY",
       .symbol = "n_p",
       .unit = "1",
       .title = "Proof load over the tension in the bolt",
       .source = "shigley, chapter 8",
       .validity = "ISO metric thread, elastic joint, equal bolts"},
      [](const auto&... x) { return bolt::proof_safety(x...); },
      quantity("stress_area", "A_t", "m^2", "stress area").rising(),
      quantity("proof_strength", "S_p", "Pa", "proof strength").rising(),
      quantity("preload", "F_i", "N", "preload").falling(),
      quantity("joint_constant", "C_j", "1", "joint constant").between(0, 0.99).typical(0.1, 0.4).falling(),
      quantity("external_tension", "P", "N", "external tension per bolt").falling());

  define(
      list,
      {.name = "bolt.slip_safety",
       .handbook_id = "BOLT-SLIP-SAFETY",
       .symbol = "n_s",
       .unit = "1",
       .title = "Margin against sliding of a joint that carries shear by friction",
       .source = "shigley, chapter 8",
       .validity = "ISO metric thread, elastic joint, equal bolts; joint not open"},
      [](const auto&... x) { return bolt::slip_safety(x...); },
      count("bolt_count", "n", "number of bolts").typical(1, 12).rising(),
      quantity("friction", "μ", "1", "joint friction").between(0, 1).typical(0.002, 0.4).rising(),
      quantity("preload", "F_i", "N", "preload per bolt").rising(),
      quantity("external_tension", "P", "N", "external tension per bolt").falling(),
      quantity("joint_constant", "C_j", "1", "joint constant").between(0, 0.99).typical(0.1, 0.4).rising(),
      quantity("shear_force", "F_s", "N", "total shear force").falling())
      .valid_when("(1 - joint_constant)·external_tension <= preload",
                  [](double, double, double preload, double external_tension, double joint_constant, double) {
                    return (1.0 - joint_constant) * external_tension <= preload;
                  });

  define(
      list,
      {.name = "bolt.shear_stress",
       .handbook_id = "BOLT-SHEAR-STRESS",
       .symbol = "τ",
       .unit = "Pa",
       .title = "Shear stress in a fitted bolt",
       .source = "shigley, chapter 8",
       .validity = "fitted bolts"},
      [](const auto&... x) { return bolt::shear_stress(x...); },
      quantity("shear_force", "F_s", "N", "shear force per bolt").rising(),
      quantity("shear_area", "A_s", "m^2", "sheared area").falling(),
      count("shear_planes", "n_p", "number of shear planes").typical(1, 4).falling());

  define(
      list,
      {.name = "bolt.group_tension",
       .handbook_id = "BOLT-GROUP-TENSION",
       .symbol = "F_max",
       .unit = "N",
       .title = "Tension in the bolt farthest from the edge about which a bracket tilts",
       .source = "khurmi_gupta2005, 11.18",
       .validity = "ISO metric thread, elastic joint, equal bolts; rigid bracket"},
      [](const auto&... x) { return bolt::group_tension(x...); },
      quantity("moment", "M", "N.m", "tilting moment").rising(),
      list_of("edge_distances", "y", "m", "distances of the bolts from the tilting edge"));

  define(
      list,
      {.name = "bolt.group_shear",
       .handbook_id = "BOLT-GROUP-SHEAR",
       .symbol = "F_k",
       .unit = "N",
       .title = "Force on the worst bolt of a group under an in-plane force along +y off the centroid",
       .source = "shigley, chapter 8",
       .validity = "ISO metric thread, elastic joint, equal bolts; rigid plates"},
      [](const auto&... x) { return bolt::group_shear(x...); },
      quantity("force", "F", "N", "in-plane force").rising(),
      quantity("eccentricity", "e", "m", "its distance from the bolt-group centroid (perpendicular to the force)"),
      list_of("bolt_x", "x", "m", "bolt x (force along +y)").any_sign().typical(-0.1, 0.1),
      list_of("bolt_y", "y", "m", "bolt y").any_sign().typical(-0.1, 0.1).as_long_as(2));
}

}  // namespace millwright::mechanics
