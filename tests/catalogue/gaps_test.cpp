// SPDX-License-Identifier: Apache-2.0
// Gaps of a catalogue of a few rows, found by hand; and that filling one closes it.
#include "catalogue/gaps.h"

#include <algorithm>

#include "catch.h"
#include "temporary_folder.h"

namespace gaps_test {

using namespace millwright;
using namespace millwright::catalogue;

namespace {

const std::string motors =
    "manufacturer,part_number,frame,frame_size [mm],shaft_diameter [mm],step_angle [deg],holding_torque "
    "[N.m],rated_current [A],price,currency,source,confidence\n";

std::vector<Gap> gaps_of(const TemporaryFolder& folder) {
  text::Diagnostics diagnostics;
  const Catalogue catalogue = Catalogue::load({folder.path()}, diagnostics);
  INFO(text::format(diagnostics));
  REQUIRE(diagnostics.error_count() == 0);
  return find_gaps(catalogue);
}

/// The sizes that are missing under that beginning of the words.
std::vector<std::string> missing(const std::vector<Gap>& gaps, Family family, const std::string& words) {
  for (const Gap& gap : gaps) {
    if (gap.family == family && gap.missing.starts_with(words)) return gap.sizes;
  }
  return {};
}

using Sizes = std::vector<std::string>;

}  // namespace

TEST_CASE("frames, currents and shafts that nothing serves are named") {
  const TemporaryFolder folder;
  folder.write("steppers/a.csv",
               motors + "A,M17,NEMA17,42.3,5,1.8,0.5,2,10,USD,s,high\nA,M34,NEMA34,86,14,1.8,9,6,90,USD,s,high\n");
  folder.write("drivers/a.csv",
               "manufacturer,part_number,minimum_voltage [V],maximum_voltage [V],peak_current "
               "[A],price,currency,source,confidence\nA,D4,18,50,4.2,20,USD,s,high\n");
  folder.write("pulleys/a.csv",
               "manufacturer,part_number,type,profile,pitch [mm],teeth [1],belt_width [mm],bore "
               "[mm],price,currency,source,confidence\nA,P5,pulley,GT2,2,20,6,5,3,USD,s,high\n");
  const auto gaps = gaps_of(folder);
  CHECK(missing(gaps, Family::steppers, "motors of frame") ==
        Sizes{"20.3 mm", "28.2 mm", "35.4 mm", "57 mm", "60 mm", "110 mm"});
  CHECK(missing(gaps, Family::drivers, "drivers of") == Sizes{"6 A"});
  CHECK(missing(gaps, Family::drivers, "drivers at") == Sizes{"12 V", "60 V", "72 V"});
  CHECK(missing(gaps, Family::pulleys, "pulleys of bore") == Sizes{"14 mm"});
  CHECK(missing(gaps, Family::stepper_curves, "torque curves of") == Sizes{"NEMA17", "NEMA34"});
}

TEST_CASE("screws without nut, support or coupling are named, and a part closes the gap") {
  const TemporaryFolder folder;
  const std::string screws =
      "manufacturer,part_number,designation,thread_form,major_diameter [mm],pitch [mm],starts [1],lead "
      "[mm],pitch_diameter [mm],minor_diameter [mm],flank_half_angle [deg],price_per_length "
      "[1/m],currency,source,confidence\n";
  folder.write("lead_screws/a.csv",
               screws +
                   "A,S16,Tr16x4,trapezoidal 30deg,16,4,1,4,14,11.5,15,9,USD,s,high\n"
                   "A,S32,Tr32x6,trapezoidal 30deg,32,6,1,6,29,25,15,30,USD,s,high\n");
  folder.write("lead_nuts/a.csv",
               "manufacturer,part_number,for_screw,nominal_diameter [mm],lead [mm],length "
               "[mm],price,currency,source,confidence\nA,N16,Tr16x4,16,4,32,5,USD,s,high\n");
  const std::string supports = "manufacturer,part_number,role,bore [mm],price,currency,source,confidence\n";
  folder.write("support_bearings/a.csv", supports + "A,F10,fixed,10,9,USD,s,high\nA,B20,supported,20,9,USD,s,high\n");
  folder.write("steppers/a.csv", motors + "A,M23,NEMA23,57,8,1.8,2,3,10,USD,s,high\n");
  folder.write("couplings/a.csv",
               "manufacturer,part_number,minimum_bore [mm],maximum_bore [mm],rated_torque "
               "[N.m],price,currency,source,confidence\nA,K,5,8,5,4,USD,s,high\n");
  auto gaps = gaps_of(folder);
  CHECK(missing(gaps, Family::lead_nuts, "nuts for") == Sizes{"S32"});
  // Core 11.5 mm takes journals of 6.3 to 11.5 mm, core 25 mm of 13.75 to 25 mm.
  CHECK(missing(gaps, Family::support_bearings, "fixed units") == Sizes{"32 mm (core 25 mm)"});
  CHECK(missing(gaps, Family::support_bearings, "supported units") == Sizes{"16 mm (core 11.5 mm)"});
  CHECK(missing(gaps, Family::couplings, "couplings of bores") == Sizes{"8 on 10 mm"});
  folder.write("couplings/b.csv",
               "manufacturer,part_number,minimum_bore [mm],maximum_bore [mm],rated_torque "
               "[N.m],price,currency,source,confidence\nA,L,6,12,1.5,4,USD,s,high\n");
  gaps = gaps_of(folder);
  CHECK(missing(gaps, Family::couplings, "couplings of bores").empty());
  CHECK(missing(gaps, Family::couplings, "strong enough couplings") == Sizes{"8 on 10 mm (2 N.m)"});
}

TEST_CASE("a coupling must bear what a motor holds with both phases on") {
  const TemporaryFolder folder;
  folder.write("steppers/a.csv",
               "manufacturer,part_number,frame,frame_size [mm],shaft_diameter [mm],step_angle [deg],holding_torque "
               "[N.m],phases_on [1],rated_current [A],price,currency,source,confidence\n"
               "A,M23,NEMA23,57,8,1.8,2,1,3,10,USD,s,high\n");
  folder.write(
      "support_bearings/a.csv",
      "manufacturer,part_number,role,bore [mm],price,currency,source,confidence\nA,F10,fixed,10,9,USD,s,high\n");
  folder.write("couplings/a.csv",
               "manufacturer,part_number,minimum_bore [mm],maximum_bore [mm],rated_torque "
               "[N.m],price,currency,source,confidence\nA,K,5,12,2.5,4,USD,s,high\n");
  CHECK(missing(gaps_of(folder), Family::couplings, "strong enough couplings") == Sizes{"8 on 10 mm (2.828 N.m)"});
}

TEST_CASE("gaps of the shipped catalogues stand in the order of the families, each with sizes and a reason") {
  text::Diagnostics diagnostics;
  const Catalogue catalogue =
      Catalogue::load({std::filesystem::path(MILLWRIGHT_SOURCE_DIR) / "catalogues"}, diagnostics);
  const auto gaps = find_gaps(catalogue);
  CHECK(gaps.size() >= 5);
  CHECK(std::is_sorted(gaps.begin(), gaps.end(), [](const Gap& a, const Gap& b) { return a.family < b.family; }));
  for (const Gap& gap : gaps) {
    CHECK_FALSE(gap.sizes.empty());
    CHECK_FALSE(gap.reason.empty());
    for (const std::string& size : gap.sizes) CHECK(gap.missing.find(size) != std::string::npos);
  }
}

}  // namespace gaps_test
