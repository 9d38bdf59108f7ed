// SPDX-License-Identifier: Apache-2.0
//
// A catalogue of a few parts with round figures, written to a temporary folder. `vary` changes price and mass of a
// part.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <map>

#include "catalogue/temporary_folder.h"
#include "evaluation/machines.h"

namespace millwright {

struct PriceAndMass {
  double price = 0.0, mass = 0.0;
};
using Vary = std::function<PriceAndMass(const std::string& part, PriceAndMass usual)>;

class TinyCatalogue {
 public:
  /// `without`: families left out.
  explicit TinyCatalogue(Vary vary = {}, const std::vector<std::string>& without = {})
      : vary_(std::move(vary)), without_(without) {
    screws();
    motors();
    joints();
    guides_and_belts();
    racks();
    structure();
    for (const auto& [family, text] : files_) folder_.write(family + "/tiny.csv", text);
    parts_ = catalogue_of({folder_.path()});
  }
  [[nodiscard]] const catalogue::Catalogue& parts() const { return parts_; }
  [[nodiscard]] const std::filesystem::path& path() const { return folder_.path(); }

 private:
  static constexpr const char* tail = ",currency,price_basis,evidence,source,confidence\n";
  static constexpr const char* said = ",USD,test,computed,test,high\n";

  void header(const std::string& family, const std::string& columns) {
    family_ = family;
    add("manufacturer,part_number," + columns + tail);
  }
  void add(const std::string& text) {
    if (std::find(without_.begin(), without_.end(), family_) == without_.end()) files_[family_] += text;
  }
  PriceAndMass of(const std::string& part, double price, double mass) const {
    return vary_ ? vary_(part, {price, mass}) : PriceAndMass{price, mass};
  }

  void screws() {
    header("lead_screws",
           "designation,thread_form,major_diameter [mm],pitch [mm],starts [1],lead [mm],pitch_diameter "
           "[mm],minor_diameter "
           "[mm],flank_half_angle [deg],yield_strength [MPa],lead_error_per_300mm [um],maximum_length "
           "[mm],screw_mass_per_length [kg/m],price_per_length [1/m]");
    const auto screw = [&](const char* name, const char* sizes, double price, double mass) {
      const auto [p, m] = of(name, price, mass);
      add(fmt::format("tiny,{},{},trapezoidal 30deg,{},400,50,2000,{},{}{}", name, name, sizes, m, p, said));
    };
    screw("Tr10x2", "10,2,1,2,9,7.5,15", 10.0, 0.5);
    screw("Tr16x4", "16,4,1,4,14,11.5,15", 20.0, 1.2);
    header(
        "lead_nuts",
        "for_screw,nominal_diameter [mm],lead [mm],material,length [mm],allowable_pressure [MPa],maximum_pv "
        "[MPa.m/s],maximum_sliding_speed [m/s],friction_dry [1],friction_greased [1],backlash [mm],preload_drag_torque "
        "[N.m],mass [kg],price");
    const auto nut = [&](const char* name, const char* sizes, double price, double mass) {
      const auto [p, m] = of(name, price, mass);
      add(fmt::format("tiny,{},{},10,2,0.5,0.2,0.1,0.05,0,{},{}{}", name, sizes, m, p, said));
    };
    nut("Tr10x2 nut", "Tr10x2,10,2,bronze CuSn8,20", 4.0, 0.1);
    nut("Tr16x4 nut", "Tr16x4,16,4,bronze CuSn8,32", 8.0, 0.25);
    header("ball_screws",
           "nominal_diameter [mm],outside_diameter [mm],pitch_circle_diameter [mm],lead [mm],root_diameter "
           "[mm],dynamic_load_rating "
           "[N],static_load_rating [N],nut_stiffness [N/um],nut_length [mm],nut_mass [kg],lead_error_per_300mm "
           "[um],maximum_length [mm],dn_limit [mm.rpm],preloaded,screw_mass_per_length [kg/m],price,price_per_length "
           "[1/m]");
    const auto [p, m] = of("B16x5", 40.0, 1.3);
    add(fmt::format(
        "tiny,B16x5,16,16,16.5,5,13,8000,12000,200,40,0.25,50,2000,70000,no,{},{},{}{}", m, 0.5 * p, p, said));
  }

  void motors() {
    header(
        "steppers",
        "frame,frame_size [mm],shaft_diameter [mm],step_angle [deg],holding_torque [N.m],detent_torque "
        "[N.m],rated_current [A],phase_resistance [ohm],phase_inductance [mH],rotor_inertia [g.cm2],mass [kg],price");
    const auto motor = [&](const char* name, const char* figures, double price, double mass) {
      const auto [p, m] = of(name, price, mass);
      add(fmt::format("tiny,{},{},{},{}{}", name, figures, m, p, said));
    };
    motor("M17", "NEMA17,42,5,1.8,0.5,0.02,2,1.5,2.8,60", 9.0, 0.3);
    motor("M23", "NEMA23,57,6.35,1.8,1.2,0.04,2.8,0.9,2.5,280", 16.0, 0.7);
    motor("M23L", "NEMA23,57,8,1.8,2.2,0.08,4,0.6,2.2,500", 30.0, 1.2);
    motor("M34", "NEMA34,86,8,1.8,4.5,0.12,4,0.7,3.5,1900", 70.0, 2.6);
    header("stepper_curves", "drive_voltage [V],phase_current [A],current_kind,speed [rpm],torque [N.m]");
    for (const char* point : {"60,1", "300,0.9", "600,0.6", "1200,0.3"})
      add(fmt::format("tiny,M23,24,2.8,peak,{}{}", point, said));
    header(
        "drivers",
        "minimum_voltage [V],maximum_voltage [V],peak_current [A],maximum_microsteps [1],closed_loop,mass [kg],price");
    const auto driver = [&](const char* name, const char* figures, double price, double mass) {
      const auto [p, m] = of(name, price, mass);
      add(fmt::format("tiny,{},{},no,{},{}{}", name, figures, m, p, said));
    };
    driver("D2", "9,30,2,32", 6.0, 0.1);
    driver("D4", "18,50,4.2,128", 20.0, 0.3);
    header("power_supplies", "output_voltage [V],output_current [A],power [W],mass [kg],price");
    const auto supply = [&](const char* name, const char* figures, double price, double mass) {
      const auto [p, m] = of(name, price, mass);
      add(fmt::format("tiny,{},{},{},{}{}", name, figures, m, p, said));
    };
    supply("P24-100", "24,4.2,100", 15.0, 0.4);
    supply("P24-350", "24,14.6,350", 30.0, 0.9);
    supply("P36-350", "36,9.7,350", 34.0, 0.9);
  }

  void joints() {
    header("couplings",
           "minimum_bore [mm],maximum_bore [mm],rated_torque [N.m],torsional_stiffness [N.m/rad],inertia "
           "[g.cm2],maximum_speed [rpm],parallel_misalignment [mm],angular_misalignment [deg],axial_misalignment "
           "[mm],mass [kg],price");
    const auto part = [&](const char* name, const char* figures, double price, double mass) {
      const auto [p, m] = of(name, price, mass);
      add(fmt::format("tiny,{},{},{},{}{}", name, figures, m, p, said));
    };
    part("K8", "3,8,2,60,10,6000,0.2,1,0.3", 2.0, 0.02);
    part("K12", "5,12,10,400,40,9000,,,", 7.0, 0.08);
    header(
        "support_bearings",
        "series,role,bore [mm],permissible_axial_load [N],axial_stiffness [N/um],maximum_speed [rpm],mass [kg],price");
    part("F6", "F,fixed,6,1200,40,4000", 10.0, 0.2);
    part("F10", "F,fixed,10,2600,90,4000", 20.0, 0.4);
    part("S6", "S,supported,6,,,4000", 4.0, 0.1);
  }

  void guides_and_belts() {
    const auto part = [&](const char* name, const std::string& figures, double price, double mass) {
      const auto [p, m] = of(name, price, mass);
      add(fmt::format("tiny,{},{},{},{}{}", name, fmt::format(fmt::runtime(figures), fmt::arg("mass", m)), p, p, said));
    };
    header("linear_guides",
           "kind,size [mm],block_length [mm],dynamic_load_rating [N],static_load_rating [N],rating_distance "
           "[km],roll_moment_rating [N.m],pitch_moment_rating [N.m],yaw_moment_rating [N.m],carriage_mass "
           "[kg],rail_mass_per_length [kg/m],maximum_rail_length [mm],radial_stiffness [N/um],price,price_per_length "
           "[1/m]");
    part("R12", "profile rail,12,45,3000,5000,50,30,20,20,{mass},0.6,2000,40", 8.0, 0.05);
    part("R20", "profile rail,20,75,15000,25000,50,250,200,200,{mass},2.2,4000,150", 20.0, 0.4);
    part("LB16", "linear ball bush,16,40,800,1200,50,,,,{mass},1.6,2000,", 5.0, 0.1);
    header("belts",
           "profile,pitch [mm],width [mm],allowable_tension [N],mass_per_length [kg/m],tensile_stiffness "
           "[N],minimum_pulley_teeth [1],maximum_speed [m/s],price_per_length [1/m]");
    const auto [p, m] = of("GT3-9", 5.0, 0.02);
    add(fmt::format("tiny,GT3-9,GT3,3,9,180,{},60000,16,40,{}{}", m, p, said));
    header("pulleys",
           "type,profile,pitch [mm],teeth [1],belt_width [mm],bore [mm],pitch_diameter [mm],inertia [g.cm2],mass "
           "[kg],price");
    add(fmt::format("tiny,G20-5,pulley,GT3,3,20,9,5,20,20,0.02,4{}", said));
    add(fmt::format("tiny,G20-6.35,pulley,GT3,3,20,9,6.35,20,20,0.02,4{}", said));
    add(fmt::format("tiny,I20,idler,GT3,3,20,9,5,20,10,0.015,3{}", said));
  }

  void racks() {
    header("racks",
           "module [mm],pressure_angle [deg],face_width [mm],allowable_stress [MPa],pitch_error_per_1000mm "
           "[um],piece_length [mm],mass_per_length [kg/m],price_per_length [1/m]");
    const auto rack = [&](const char* name, const char* figures, double price, double mass) {
      const auto [p, m] = of(name, price, mass);
      add(fmt::format("tiny,{},{},{},{}{}", name, figures, m, p, said));
    };
    rack("R1", "1,20,10,150,50,1000", 30.0, 0.7);
    rack("R1.5", "1.5,20,15,100,100,500", 40.0, 1.5);
    header("pinions",
           "module [mm],pressure_angle [deg],teeth [1],face_width [mm],bore [mm],allowable_stress [MPa],inertia "
           "[g.cm2],mass [kg],price");
    const auto pinion = [&](const char* name, const char* figures, double price, double mass) {
      const auto [p, m] = of(name, price, mass);
      add(fmt::format("tiny,{},{},{},{}{}", name, figures, m, p, said));
    };
    pinion("P1-16-5", "1,20,16,10,5,120,8", 3.0, 0.02);
    pinion("P1-20-8", "1,20,20,10,8,120,20", 4.0, 0.03);
    pinion("P1.5-20-6.35", "1.5,20,20,12,6.35,120,95", 6.0, 0.085);
    pinion("P1.5-20-8", "1.5,20,20,12,8,120,90", 6.0, 0.08);
  }

  void structure() {
    header("materials",
           "class,elastic_modulus [MPa],density [kg/m3],yield_strength [MPa],price_per_mass [1/kg],shear_modulus "
           "[MPa],ultimate_strength [MPa],endurance_limit [MPa],endurance_basis");
    add(fmt::format("tiny,steel,steel,200000,8000,240,2,80000,400,,{}", said));
    add(fmt::format("tiny,CuSn8,copper,110000,8800,150,12,42000,,,{}", said));
    add(fmt::format("tiny,alloy,aluminium,70000,2700,250,7,,300,100,measured{}", said));
    header("steel_sections",
           "kind,height [mm],width [mm],area [mm2],mass_per_length [kg/m],second_moment_x [mm4],second_moment_y "
           "[mm4],material,elastic_modulus [MPa],price_per_length [1/m],torsion_constant [mm4]");
    add(fmt::format("tiny,box20,square tube,20,20,200,1.6,10000,10000,steel,200000,4,{}", said));
    add(fmt::format("tiny,box60,square tube,60,60,1000,8,500000,500000,steel,200000,15,750000{}", said));
    header("extrusions",
           "height [mm],width [mm],area [mm2],mass_per_length [kg/m],second_moment_x [mm4],second_moment_y "
           "[mm4],elastic_modulus [MPa],yield_strength [MPa],price_per_length [1/m]");
    add(fmt::format("tiny,slot4080,80,40,1000,2.7,600000,160000,70000,200,30{}", said));
    header("screws",
           "designation,nominal_diameter [mm],pitch [mm],property_class,tensile_stress_area [mm2],proof_strength "
           "[MPa],yield_strength [MPa],price");
    add(fmt::format("tiny,M6 8.8,M6,6,1,8.8,20,600,640,0.05{}", said));
    add(fmt::format("tiny,M8 8.8,M8,8,1.25,8.8,36,600,640,0.1{}", said));
    add(fmt::format("tiny,M8 12.9,M8,8,1.25,12.9,36,970,,0.3{}", said));
  }

  Vary vary_;
  std::vector<std::string> without_;
  std::string family_;
  std::map<std::string, std::string> files_;
  TemporaryFolder folder_;
  catalogue::Catalogue parts_;
};

}  // namespace millwright
