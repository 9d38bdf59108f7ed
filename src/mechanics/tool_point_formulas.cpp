// SPDX-License-Identifier: Apache-2.0
#include "mechanics/formula_definition.h"
#include "mechanics/tool_point.h"

namespace millwright::mechanics {

void define_tool_point(FormulaList& list) {
  define(
      list,
      {.name = "tool_point.chain_compliance",
       .handbook_id = "TOOL-COMPLIANCE-CHAIN",
       .symbol = "c",
       .unit = "m/N",
       .title = "Compliance at the tool of elements in the chain between tool and workpiece",
       .source = "slocum1992, chapter 2; roark, chapter 8",
       .validity = "linear elastic"},
      [](const auto&... x) { return tool_point::chain_compliance(x...); },
      list_of("stiffnesses", "k", "N/m", "element stiffnesses"),
      list_of("force_ratios", "g", "1", "transmission ratios (element force or moment per unit tool force)")
          .any_sign()
          .typical(-2, 2)
          .as_long_as(0));

  define(
      list,
      {.name = "tool_point.rotary_compliance",
       .handbook_id = "TOOL-ROTARY-COMPLIANCE",
       .symbol = "c",
       .unit = "m/N",
       .title = "Compliance at the tool of a rotary spring under a lever arm",
       .source = "slocum1992, chapter 2; roark, chapter 8",
       .validity = "linear elastic"},
      [](const auto&... x) { return tool_point::rotary_compliance(x...); },
      quantity("lever_arm", "h", "m", "lever arm of the tool force about the rotary spring").rising(),
      quantity("rotary_stiffness", "k_th", "N.m/rad", "rotary stiffness").falling());

  define(
      list,
      {.name = "tool_point.deflection",
       .handbook_id = "TOOL-DEFLECTION",
       .symbol = "δ",
       .unit = "m",
       .title = "Deflection at the tool",
       .source = "slocum1992, chapter 2; roark, chapter 8",
       .validity = "linear elastic"},
      [](const auto&... x) { return tool_point::deflection(x...); },
      quantity("force", "F", "N", "cutting force").rising(),
      quantity("compliance", "c", "m/N", "tool-point compliance in that direction").rising());

  define(
      list,
      {.name = "tool_point.end_mill_stiffness",
       .handbook_id = "TOOL-ENDMILL-STIFFNESS",
       .symbol = "k",
       .unit = "N/m",
       .title = "Stiffness of an end mill as a cantilever of reduced diameter",
       .source = "slocum1992, chapter 2; roark, chapter 8",
       .validity = "linear elastic"},
      [](const auto&... x) { return tool_point::end_mill_stiffness(x...); },
      quantity("elastic_modulus", "E", "Pa", "modulus of the tool (carbide 600 GPa, HSS 210 GPa)")
          .typical(5e9, 6e11)
          .rising(),
      quantity("diameter", "D", "m", "cutter diameter").rising(),
      quantity("diameter_ratio", "q", "1", "effective diameter ratio (0.8)").between(0, 1).typical(0.6, 1).rising(),
      quantity("overhang", "L", "m", "overhang").falling());
}

}  // namespace millwright::mechanics
