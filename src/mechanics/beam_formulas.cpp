// SPDX-License-Identifier: Apache-2.0
#include "mechanics/beam.h"
#include "mechanics/formula_definition.h"

namespace millwright::mechanics {

void define_beam(FormulaList& list) {
  define(
      list,
      {.name = "beam.cantilever_tip_deflection",
       .handbook_id = "BEAM-CANT-POINT",
       .symbol = "δ",
       .unit = "m",
       .title = "Deflection of a cantilever at its tip under a force there",
       .source = "shigley, Table A-9",
       .validity = "linear elastic, small deflection, span over height above 8, constant section"},
      [](const auto&... x) { return beam::cantilever_tip_deflection(x...); },
      quantity("force", "F", "N", "force at the tip").rising(),
      quantity("length", "L", "m", "length").rising(),
      quantity("elastic_modulus", "E", "Pa", "modulus").typical(5e9, 6e11).falling(),
      quantity("second_moment_of_area", "I", "m^4", "second moment of area").typical(1e-10, 1e-6).falling());

  define(
      list,
      {.name = "beam.cantilever_tip_slope",
       .handbook_id = "BEAM-CANT-POINT-SLOPE",
       .symbol = "φ",
       .unit = "rad",
       .title = "Slope of a cantilever at its tip under a force there",
       .source = "shigley, Table A-9",
       .validity = "linear elastic, small deflection, span over height above 8, constant section"},
      [](const auto&... x) { return beam::cantilever_tip_slope(x...); },
      quantity("force", "F", "N", "force at the tip").rising(),
      quantity("length", "L", "m", "length").rising(),
      quantity("elastic_modulus", "E", "Pa", "modulus").typical(5e9, 6e11).falling(),
      quantity("second_moment_of_area", "I", "m^4", "second moment of area").typical(1e-10, 1e-6).falling());

  define(
      list,
      {.name = "beam.cantilever_tip_deflection_load_at",
       .handbook_id = "BEAM-CANT-POINT-AT",
       .symbol = "δ",
       .unit = "m",
       .title = "Deflection of a cantilever at its tip under a force between clamp and tip",
       .source = "shigley, Table A-9",
       .validity =
           "linear elastic, small deflection, span over height above 8, constant section; force between clamp and tip"},
      [](const auto&... x) { return beam::cantilever_tip_deflection_load_at(x...); },
      quantity("force", "F", "N", "force").rising(),
      quantity("load_distance", "a", "m", "distance of the force from the clamp").rising(),
      quantity("length", "L", "m", "length").rising(),
      quantity("elastic_modulus", "E", "Pa", "modulus").typical(5e9, 6e11).falling(),
      quantity("second_moment_of_area", "I", "m^4", "second moment of area").typical(1e-10, 1e-6).falling())
      .valid_when("load_distance <= length",
                  [](double, double load_distance, double length, double, double) { return load_distance <= length; });

  define(
      list,
      {.name = "beam.cantilever_tip_deflection_distributed",
       .handbook_id = "BEAM-CANT-UDL",
       .symbol = "δ",
       .unit = "m",
       .title = "Deflection of a cantilever at its tip under an evenly distributed load",
       .source = "shigley, Table A-9",
       .validity = "linear elastic, small deflection, span over height above 8, constant section"},
      [](const auto&... x) { return beam::cantilever_tip_deflection_distributed(x...); },
      quantity("distributed_load", "w", "N/m", "distributed load").rising(),
      quantity("length", "L", "m", "length").rising(),
      quantity("elastic_modulus", "E", "Pa", "modulus").typical(5e9, 6e11).falling(),
      quantity("second_moment_of_area", "I", "m^4", "second moment of area").typical(1e-10, 1e-6).falling());

  define(
      list,
      {.name = "beam.cantilever_tip_deflection_moment",
       .handbook_id = "BEAM-CANT-MOMENT",
       .symbol = "δ",
       .unit = "m",
       .title = "Deflection of a cantilever at its tip under a moment there",
       .source = "shigley, Table A-9",
       .validity = "linear elastic, small deflection, span over height above 8, constant section"},
      [](const auto&... x) { return beam::cantilever_tip_deflection_moment(x...); },
      quantity("moment", "M", "N.m", "moment at the tip").rising(),
      quantity("length", "L", "m", "length").rising(),
      quantity("elastic_modulus", "E", "Pa", "modulus").typical(5e9, 6e11).falling(),
      quantity("second_moment_of_area", "I", "m^4", "second moment of area").typical(1e-10, 1e-6).falling());

  define(
      list,
      {.name = "beam.cantilever_shear_deflection",
       .handbook_id = "BEAM-CANT-SHEAR",
       .symbol = "δ_s",
       .unit = "m",
       .title = "Shear part of the tip deflection, to be added to the bending part in short beams",
       .source = "roark, chapter 8",
       .validity = "linear elastic"},
      [](const auto&... x) { return beam::cantilever_shear_deflection(x...); },
      quantity("force", "F", "N", "force at the tip").rising(),
      quantity("length", "L", "m", "length").rising(),
      quantity("shear_coefficient", "κ", "1", "shear coefficient").between(0, 1).typical(0.4, 0.95).falling(),
      quantity("shear_modulus", "G", "Pa", "shear modulus").typical(2e9, 9e10).falling(),
      quantity("area", "A", "m^2", "area").falling());

  define(
      list,
      {.name = "beam.supported_deflection",
       .handbook_id = "BEAM-SS-POINT-MID",
       .symbol = "δ",
       .unit = "m",
       .title = "Midspan deflection of a simply supported beam under a force there",
       .source = "shigley, Table A-9",
       .validity = "linear elastic, small deflection, span over height above 8, constant section"},
      [](const auto&... x) { return beam::supported_deflection(x...); },
      quantity("force", "F", "N", "force at midspan").rising(),
      quantity("length", "L", "m", "span").rising(),
      quantity("elastic_modulus", "E", "Pa", "modulus").typical(5e9, 6e11).falling(),
      quantity("second_moment_of_area", "I", "m^4", "second moment of area").typical(1e-10, 1e-6).falling());

  define(
      list,
      {.name = "beam.supported_deflection_at",
       .handbook_id = "BEAM-SS-POINT-AT",
       .symbol = "δ",
       .unit = "m",
       .title = "Deflection of a simply supported beam at any place under a force at any place",
       .source = "shigley, Table A-9",
       .validity =
           "linear elastic, small deflection, span over height above 8, constant section; both places on the span"},
      [](const auto&... x) { return beam::supported_deflection_at(x...); },
      quantity("force", "F", "N", "force").rising(),
      quantity("load_distance", "a", "m", "distance of the force from the left support"),
      quantity("position", "x", "m", "where the deflection is wanted"),
      quantity("length", "L", "m", "span"),
      quantity("elastic_modulus", "E", "Pa", "modulus").typical(5e9, 6e11).falling(),
      quantity("second_moment_of_area", "I", "m^4", "second moment of area").typical(1e-10, 1e-6).falling())
      .valid_when("load_distance <= length and position <= length",
                  [](double, double load_distance, double position, double length, double, double) {
                    return load_distance <= length && position <= length;
                  });

  define(
      list,
      {.name = "beam.supported_largest_deflection",
       .handbook_id = "BEAM-SS-POINT-AT-MAX",
       .symbol = "δ_max",
       .unit = "m",
       .title = "Largest deflection of a simply supported beam under a force at any place",
       .source = "shigley, Table A-9",
       .validity = "linear elastic, small deflection, span over height above 8, constant section; force on the span"},
      [](const auto&... x) { return beam::supported_largest_deflection(x...); },
      quantity("force", "F", "N", "force").rising(),
      quantity("load_distance", "a", "m", "distance of the force from one support"),
      quantity("length", "L", "m", "span"),
      quantity("elastic_modulus", "E", "Pa", "modulus").typical(5e9, 6e11).falling(),
      quantity("second_moment_of_area", "I", "m^4", "second moment of area").typical(1e-10, 1e-6).falling())
      .valid_when("load_distance <= length",
                  [](double, double load_distance, double length, double, double) { return load_distance <= length; });

  define(
      list,
      {.name = "beam.supported_deflection_distributed",
       .handbook_id = "BEAM-SS-UDL",
       .symbol = "δ",
       .unit = "m",
       .title = "Midspan deflection of a simply supported beam under an evenly distributed load",
       .source = "shigley, Table A-9",
       .validity = "linear elastic, small deflection, span over height above 8, constant section"},
      [](const auto&... x) { return beam::supported_deflection_distributed(x...); },
      quantity("distributed_load", "w", "N/m", "distributed load").rising(),
      quantity("length", "L", "m", "span").rising(),
      quantity("elastic_modulus", "E", "Pa", "modulus").typical(5e9, 6e11).falling(),
      quantity("second_moment_of_area", "I", "m^4", "second moment of area").typical(1e-10, 1e-6).falling());

  define(
      list,
      {.name = "beam.supported_deflection_two_loads",
       .handbook_id = "BEAM-SS-TWO-POINT",
       .symbol = "δ_mid",
       .unit = "m",
       .title = "Midspan deflection of a simply supported beam under two equal forces, each the same distance from its "
                "support",
       .source = "shigley, Table A-9",
       .validity = "linear elastic, small deflection, span over height above 8, constant section; distance at most "
                   "half the span"},
      [](const auto&... x) { return beam::supported_deflection_two_loads(x...); },
      quantity("force", "P", "N", "each of two equal forces").rising(),
      quantity("load_distance", "a", "m", "distance of each from its support").rising(),
      quantity("length", "L", "m", "span").rising(),
      quantity("elastic_modulus", "E", "Pa", "modulus").typical(5e9, 6e11).falling(),
      quantity("second_moment_of_area", "I", "m^4", "second moment of area").typical(1e-10, 1e-6).falling())
      .valid_when("2·load_distance <= length", [](double, double load_distance, double length, double, double) {
        return 2.0 * load_distance <= length;
      });

  define(
      list,
      {.name = "beam.overhang_tip_deflection",
       .handbook_id = "BEAM-SS-OVERHANG",
       .symbol = "δ",
       .unit = "m",
       .title = "Deflection at the tip of an overhang beyond a simply supported span under a force there",
       .source = "shigley, Table A-9",
       .validity = "linear elastic, small deflection, span over height above 8, constant section"},
      [](const auto&... x) { return beam::overhang_tip_deflection(x...); },
      quantity("force", "F", "N", "force at the tip of the overhang").rising(),
      quantity("length", "L", "m", "span between supports").rising(),
      quantity("overhang", "c", "m", "overhang").rising(),
      quantity("elastic_modulus", "E", "Pa", "modulus").typical(5e9, 6e11).falling(),
      quantity("second_moment_of_area", "I", "m^4", "second moment of area").typical(1e-10, 1e-6).falling());

  define(
      list,
      {.name = "beam.fixed_deflection",
       .handbook_id = "BEAM-FF-POINT-MID",
       .symbol = "δ",
       .unit = "m",
       .title = "Midspan deflection of a beam clamped at both ends under a force there",
       .source = "shigley, Table A-9",
       .validity = "linear elastic, small deflection, span over height above 8, constant section"},
      [](const auto&... x) { return beam::fixed_deflection(x...); },
      quantity("force", "F", "N", "force at midspan").rising(),
      quantity("length", "L", "m", "span").rising(),
      quantity("elastic_modulus", "E", "Pa", "modulus").typical(5e9, 6e11).falling(),
      quantity("second_moment_of_area", "I", "m^4", "second moment of area").typical(1e-10, 1e-6).falling());

  define(
      list,
      {.name = "beam.fixed_deflection_load_at",
       .handbook_id = "BEAM-FF-POINT-AT",
       .symbol = "δ",
       .unit = "m",
       .title = "Deflection under a force at any place of a beam clamped at both ends",
       .source = "shigley, Table A-9",
       .validity = "linear elastic, small deflection, span over height above 8, constant section; force on the span"},
      [](const auto&... x) { return beam::fixed_deflection_load_at(x...); },
      quantity("force", "F", "N", "force").rising(),
      quantity("load_distance", "a", "m", "distance of the force from one clamp"),
      quantity("length", "L", "m", "span"),
      quantity("elastic_modulus", "E", "Pa", "modulus").typical(5e9, 6e11).falling(),
      quantity("second_moment_of_area", "I", "m^4", "second moment of area").typical(1e-10, 1e-6).falling())
      .valid_when("load_distance <= length",
                  [](double, double load_distance, double length, double, double) { return load_distance <= length; });

  define(
      list,
      {.name = "beam.fixed_deflection_distributed",
       .handbook_id = "BEAM-FF-UDL",
       .symbol = "δ",
       .unit = "m",
       .title = "Midspan deflection of a beam clamped at both ends under an evenly distributed load",
       .source = "shigley, Table A-9",
       .validity = "linear elastic, small deflection, span over height above 8, constant section"},
      [](const auto&... x) { return beam::fixed_deflection_distributed(x...); },
      quantity("distributed_load", "w", "N/m", "distributed load").rising(),
      quantity("length", "L", "m", "span").rising(),
      quantity("elastic_modulus", "E", "Pa", "modulus").typical(5e9, 6e11).falling(),
      quantity("second_moment_of_area", "I", "m^4", "second moment of area").typical(1e-10, 1e-6).falling());

  define(
      list,
      {.name = "beam.largest_moment",
       .handbook_id = "BEAM-MOMENT",
       .symbol = "M",
       .unit = "N.m",
       .title = "Largest bending moment of the six standard cases from the total load",
       .source = "shigley, Table A-9",
       .validity = "linear elastic, small deflection, span over height above 8, constant section"},
      [](const auto&... x) { return beam::largest_moment(x...); },
      choice<beam::LoadCase>("load_case",
                             "case",
                             "cant-point | cant-udl | ss-point-mid | ss-udl | ff-point-mid | ff-udl",
                             {"cantilever-point",
                              "cantilever-distributed",
                              "supported-point",
                              "supported-distributed",
                              "fixed-point",
                              "fixed-distributed"}),
      quantity("load", "F", "N", "total load (for distributed load w*L)").rising(),
      quantity("length", "L", "m", "length").rising());

  define(
      list,
      {.name = "beam.fixed_moment_of_travelling_load",
       .symbol = "M",
       .unit = "N.m",
       .title = "Largest moment at a clamp of a beam held at both ends, wherever the load is",
       .source = "shigley, Table A-9",
       .validity = "linear elastic, small deflection, span over height above 8, constant section"},
      [](const auto&... x) { return beam::fixed_moment_of_travelling_load(x...); },
      quantity("force", "F", "N", "force on the span").rising(),
      quantity("length", "L", "m", "span").rising());

  define(
      list,
      {.name = "beam.span_to_height",
       .symbol = "L/h",
       .unit = "1",
       .title = "Span over height of a beam",
       .source = "shigley, Table A-9",
       .validity = "at least 8: below it shear counts, which the deflections leave out"},
      [](const auto&... x) { return beam::span_to_height(x...); },
      quantity("length", "L", "m", "span, or length of a cantilever").typical(0.1, 2).rising(),
      quantity("height", "h", "m", "height in the plane of bending").typical(0.004, 0.1).falling())
      .valid_when("length >= 8·height", [](double length, double height) { return length >= 8.0 * height; });

  define(
      list,
      {.name = "beam.supported_moment_load_at",
       .handbook_id = "BEAM-MOMENT-SS-POINT-AT",
       .symbol = "M",
       .unit = "N.m",
       .title = "Bending moment under a force at any place of a simply supported beam",
       .source = "shigley, Table A-9",
       .validity = "linear elastic, small deflection, span over height above 8, constant section; force on the span"},
      [](const auto&... x) { return beam::supported_moment_load_at(x...); },
      quantity("force", "F", "N", "force").rising(),
      quantity("load_distance", "a", "m", "distance from one support"),
      quantity("length", "L", "m", "span"))
      .valid_when("load_distance <= length",
                  [](double, double load_distance, double length) { return load_distance <= length; });
}

}  // namespace millwright::mechanics
