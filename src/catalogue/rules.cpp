// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rules.h"

#include <algorithm>

#include "catalogue/relation.h"

namespace millwright::catalogue {

const std::vector<std::string_view>& rule_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> all = {
        "magnitude",      "rising-torque",    "frame-size",     "step-angle",       "detent-torque",
        "shaft-diameter", "root-diameter",    "ball-diameter",  "nut-diameter",     "lead-starts",
        "nut-thread",     "lead-angle",       "flank-angle",    "friction",         "bore",
        "maximum-torque", "breaking-tension", "pitch-diameter", "outside-diameter", "flange-diameter",
        "teeth",          "tooth-pitch",      "pitch-line",     "root-geometry",    "rack-mass",
        "piece-length",   "voltage-range",    "rms-current",    "supply-power",     "adjustment",
        "peak-current",   "iso-724",          "stress-area",    "clearance-hole",   "tap-drill",
        "strength-order", "proof-load",       "ultimate-load",  "preload",          "rating-distance",
        "block-width",    "rail-height",      "section-mass",   "strong-axis",      "section-modulus",
        "shear-modulus",  "shear-yield",      "yield-strain",   "phases-on",        "designation"};
    for (const FamilyDeclaration& family : families) {
      for (const Relation& each : relations(family.family)) all.push_back(each.id);
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }();
  return names;
}

}  // namespace millwright::catalogue
