// SPDX-License-Identifier: Apache-2.0
//
// Problem files drawn over what the format can say: axes that carry each other, upright, inclined and balanced ones,
// all mechanisms and reductions, several drives, moves of both kinds, jerk, currents to be set, guides, structure of
// fixed and of free dimensions, position errors of axes and at the tool, and bands and least values that are not
// monotone in anything (resonance, stiffness, natural frequencies).
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "evaluation/random_catalogue.h"

namespace millwright {

class RandomMachine {
 public:
  explicit RandomMachine(Draw& draw) : draw_(draw) {
    count_ = draw_.of({1, 1, 2, 2, 2, 3});
    tool_ = count_ <= 2 && draw_.chance(0.2);  // which looks along x and y only
    text_ = "[currency]\nUSD = 1.0\n[supply]\n";
    text_ += draw_.chance(0.5) ? "voltage = [\"24 V\", \"36 V\"]\n" : "voltage = [\"24 V\"]\n";
    machine_requirements();
    for (int i = 0; i < count_; ++i) axis(i);
    if (tool_) tool();
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  template <class... Arguments>
  void add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    text_ += fmt::format(format, std::forward<Arguments>(arguments)...);
  }
  [[nodiscard]] static std::string name(int axis) { return std::string(1, "xyz"[axis]); }

  void machine_requirements() {
    add("[require]\nlife = \"{:.0f} h\"\n", draw_.scale(300.0, 20000.0));
    add("inertia_ratio = {:.4g}\n", draw_.scale(4.0, 500.0));
    add("step_rate = \"{:.4g} kHz\"\n", draw_.scale(20.0, 200.0));
    if (draw_.chance(0.5)) add("supply_reserve = {:.4g}\n", draw_.scale(1.0, 4.0));
    if (draw_.chance(0.3)) add("torque_margin = {:.3g}\n", draw_.between(0.3, 0.9));
  }

  void axis(int index) {
    rotary_ = index == 0 && !tool_ && draw_.chance(0.1);
    const double way = tool_ ? 1.0 : draw_.uniform();
    upright_ = !rotary_ && way < 0.25;
    add("[[axis]]\nname = \"{}\"\n", name(index));
    if (index > 0 && draw_.chance(0.8)) add("carries = [\"{}\"]\n", name(index - 1));
    if (rotary_) {
      add("stroke = \"360 deg\"\nstructure_inertia = \"{:.4g} kg.m2\"\n", draw_.scale(1e-5, 5e-3));
      add("structure_mass = \"{:.4g} kg\"\nfriction_torque = \"{:.3g} N.m\"\n",
          draw_.scale(0.2, 4.0),
          0.05 * draw_.uniform());
    } else {
      linear_axis(way);
    }
    ramp_ = draw_.chance(0.4) ? 0.0 : draw_.scale(2.0, 10.0);
    shortest_ = draw_.scale(0.04, 0.3);
    if (ramp_ > 0.0)
      add("acceleration_time = [\"{:.4g} s\", \"{:.4g} s\"]\n", shortest_, shortest_ * ramp_);
    else
      add("acceleration_time = \"{:.4g} s\"\n", shortest_);
    mechanism();
    add("motor = {{ microsteps = {}{}{} }}\n",
        draw_.of({2, 4, 8, 16}),
        draw_.chance(0.15) ? ", current = [\"0.8 A\", \"1.5 A\", \"2.5 A\"]" : "",
        upright_ && draw_.chance(0.8) ? brake() : "");
    has_guide_ = !rotary_ && (tool_ || draw_.chance(0.6));
    if (has_guide_) guide();
    const int moves = draw_.of({1, 1, 2});
    for (int i = 0; i < moves; ++i) move();
    axis_requirements();
    if (!rotary_ && draw_.chance(0.45)) member(index);
  }

  /// One that holds everything, or some of what comes through a thread.
  std::string brake() {
    return fmt::format(", brake_torque = \"{:.4g} N.m\"", draw_.chance(0.5) ? 2.0 : draw_.scale(0.004, 0.5));
  }

  void linear_axis(double way) {
    if (upright_) add("direction = \"vertical\"\n");
    if (way >= 0.25 && way < 0.4)
      add("direction = \"inclined\"\ninclination = \"{:.4g} deg\"\n", draw_.between(5.0, 80.0));
    stroke_ = draw_.between(60.0, 400.0);
    mass_ = draw_.scale(0.3, 9.0);
    add("stroke = \"{:.4g} mm\"\nstructure_mass = \"{:.4g} kg\"\n", stroke_, mass_);
    if (draw_.chance(0.3)) add("payload_mass = \"{:.4g} kg\"\n", draw_.scale(0.2, 10.0));
    if (draw_.chance(0.7)) add("guide_friction = {:.4g}\n", draw_.scale(0.003, 0.3));
    if (draw_.chance(0.5)) add("guide_drag = \"{:.4g} N\"\n", draw_.scale(1.0, 30.0));
    // From a help to more than the weight: then the drive pulls down.
    if (way < 0.4 && draw_.chance(0.35))
      add("counterbalance_force = \"{:.4g} N\"\n", 9.80665 * mass_ * draw_.between(0.2, 1.6));
  }

  std::string reductions(bool shaft) {
    std::string list;
    const std::size_t count = 1 + draw_.below(2);
    for (std::size_t i = 0; i < count; ++i)
      list += fmt::format(
          "{}{{ name = \"r{}\", ratio = {:.3g}, efficiency = {:.3g}, inertia = \"{:.3g} kg.m2\", backlash = \"{:.3g} "
          "arcmin\", mass = "
          "\"{:.3g} kg\", torque = \"{:.3g} N.m\", price = \"{:.4g} USD\"{} }}",
          i == 0 ? "" : ", ",
          i,
          draw_.scale(1.0, 8.0),
          draw_.between(0.8, 0.98),
          draw_.scale(1e-6, 1e-4),
          draw_.between(1.0, 20.0),
          draw_.scale(0.1, 1.5),
          draw_.scale(1.0, 20.0),
          draw_.scale(10.0, 100.0),
          shaft ? draw_.of({", shaft = \"5 mm\"", ", shaft = \"6.35 mm\"", ", shaft = \"8 mm\""}) : "");
    return ", reduction = [" + list + "]";
  }

  void mechanism() {
    const double kind = draw_.uniform();
    const bool reduced = draw_.chance(0.2);
    if (rotary_) return add("mechanism = {{ kind = \"rotary\"{} }}\n", reduced ? reductions(false) : "");
    std::string several;
    if (draw_.chance(0.15)) several = draw_.of({", drives = 2", ", drives = 2, load_share = 0.7"});
    if (kind < 0.6) {
      const bool nut = draw_.chance(0.1);
      const char* screws = draw_.of({"\"ball_screws\", \"lead_screws\"", "\"ball_screws\"", "\"lead_screws\""});
      const std::string ends =
          nut ? "fixed-fixed" : draw_.of({"fixed-free", "supported-supported", "fixed-supported", "fixed-supported"});
      add("mechanism = {{ kind = \"screw\", screw = [{}], ends = \"{}\"{}{}{} }}\n",
          screws,
          ends,
          nut ? ", rotating = \"nut\", nut_inertia = \"2 kg.cm2\"" : "",
          nut       ? reductions(false)
          : reduced ? reductions(draw_.chance(0.5))
                    : "",
          several);
    } else if (kind < 0.85) {
      add("mechanism = {{ kind = \"belt\"{}{} }}\n", reduced ? reductions(true) : "", several);
    } else {
      add("mechanism = {{ kind = \"rack\"{}{}{} }}\n",
          draw_.chance(0.4) ? ", motor_rides = false" : "",
          reduced ? reductions(true) : "",
          several);
    }
  }

  void guide() {
    add("guide = {{ {}carriages = 4, carriage_spacing = \"{:.4g} mm\", rail_spacing = \"{:.4g} mm\", "
        "load_offset_x = \"{:.4g} mm\", force_height = \"{:.4g} mm\"{} }}\n",
        draw_.chance(0.8) ? "kinds = [\"profile rail\"], " : "",
        draw_.between(80.0, 200.0),
        draw_.between(60.0, 300.0),
        draw_.between(-80.0, 80.0),
        draw_.between(0.0, 100.0),
        tool_ ? ", tool_at = [\"50 mm\", \"0 mm\", \"60 mm\"]" : "");
  }

  void move() {
    add("[[axis.moves]]\n");
    const double longest = shortest_ * std::max(ramp_, 1.0);
    if (rotary_) {
      const double angle = draw_.between(10.0, 360.0);
      add("distance = \"{:.4g} deg\"\ntime = \"{:.4g} s\"\n", angle, 2.1 * longest + angle / draw_.scale(60.0, 720.0));
      if (draw_.chance(0.4)) add("torque = \"{:.3g} N.m\"\n", draw_.scale(0.005, 0.2));
    } else {
      const double distance = draw_.between(0.3, 1.0) * stroke_;
      const double speed = draw_.scale(2.0, 80.0);
      add("distance = \"{:.4g} mm\"\n", distance);
      if (draw_.chance(0.75) || distance < 1.2 * speed * longest)
        add("time = \"{:.4g} s\"\n", 2.1 * longest + distance / speed);
      else
        add("speed = \"{:.4g} mm/s\"\n", speed);
      if (draw_.chance(0.6)) add("force = \"{:.4g} N\"\n", draw_.scale(2.0, 60.0));
      if (draw_.chance(0.15)) add("jerk = \"{:.4g} m/s^3\"\n", draw_.scale(5.0, 200.0));
    }
    if (draw_.chance(0.5)) add("dwell = \"{:.3g} s\"\n", draw_.scale(0.1, 10.0));
  }

  void axis_requirements() {
    add("[axis.require]\n");
    if (rotary_) {
      if (draw_.chance(0.4)) add("angle_error = \"{:.3g} deg\"\n", draw_.scale(0.1, 3.0));
      return;
    }
    if (tool_ || draw_.chance(0.4))
      add("position_error = {{ limit = \"{:.3g} mm\", over = \"{:.4g} mm\" }}\n",
          draw_.scale(0.15, 2.0),
          0.8 * stroke_);
    if (draw_.chance(0.1)) add("axial_stiffness = \"{:.3g} N/um\"\n", draw_.scale(2.0, 40.0));
    // What is only reported otherwise: a forbidden band about the resonance, RMS torque, least frequencies.
    std::string enforced;
    for (const char* id : {"\"C-ST-RES\"", "\"C-ST-RMS\"", "\"C-CP-RES\"", "\"C-ST-POWER\""})
      if (draw_.chance(0.08)) enforced += (enforced.empty() ? "" : ", ") + std::string(id);
    if (!enforced.empty()) add("enforce = [{}]\n", enforced);
  }

  void member(int index) {
    add("[[axis.members]]\nname = \"m{}\"\n", index);
    const bool rides = draw_.chance(0.5);
    // Dimensions that move cost and mass only on small machines: the enumeration has them on a grid.
    const bool free_dimension = count_ <= 2 && !has_dimension_ && draw_.chance(0.8);
    const double length = draw_.between(100.0, 500.0);
    const double kind = draw_.uniform();
    if (kind >= 0.88) return held_joint();
    if (rides) add("rides = true\n");
    const auto support = [&] { return draw_.of({"supported", "fixed", "cantilever"}); };
    if (kind < 0.35 || (!free_dimension && kind < 0.6)) {
      add("kind = \"beam\"\nsupport = \"{}\"\nlength = \"{:.4g} mm\"\nmaterial = \"steel\"\nsections = "
          "[\"steel_sections\", \"extrusions\"]\n",
          support(),
          length);
    } else if (kind < 0.5) {
      size("shaft",
           support(),
           length,
           "diameter",
           draw_.between(6.0, 12.0),
           free_dimension ? draw_.scale(1.5, 5.0) : 1.0);
      if (!rides && draw_.chance(0.3)) add("guide = true\n");
    } else if (kind < 0.7) {
      add("width = \"{:.4g} mm\"\n", draw_.between(80.0, 300.0));
      size("plate",
           support(),
           length,
           "thickness",
           draw_.between(2.0, 6.0),
           free_dimension ? draw_.scale(1.5, 6.0) : 1.0);
    } else if (kind < 0.8) {
      add("width = \"{:.4g} mm\"\n", draw_.between(10.0, 40.0));
      size("bar", support(), length, "height", draw_.between(5.0, 15.0), free_dimension ? draw_.scale(1.5, 6.0) : 1.0);
    } else {
      add("kind = \"bolts\"\nrows = 2\ncolumns = 2\nrow_spacing = \"60 mm\"\ncolumn_spacing = \"60 mm\"\nedge_distance "
          "= "
          "\"15 mm\"\nlever_arm = \"{:.4g} mm\"\n",
          draw_.between(20.0, 250.0));
    }
    if (draw_.chance(0.4)) add("extra_force = \"{:.4g} N\"\n", draw_.scale(10.0, 1000.0));
  }

  /// Of motors or carriages: tightened so little that which motor or guide it is matters.
  void held_joint() {
    add("kind = \"bolts\"\nholds = \"{}\"\nrow_spacing = \"31 mm\"\ncolumn_spacing = \"31 mm\"\ntightening_torque = "
        "\"{:.3g} N.m\"\n",
        has_guide_ && draw_.chance(0.5) ? "guide" : "motor",
        draw_.scale(0.05, 2.0));
    if (draw_.chance(0.4)) add("extra_force = \"{:.4g} N\"\n", draw_.scale(1.0, 100.0));
  }

  void size(const char* kind, const char* support, double length, const char* dimension, double least, double times) {
    add("kind = \"{}\"\nsupport = \"{}\"\nlength = \"{:.4g} mm\"\nmaterial = \"{}\"\n",
        kind,
        support,
        length,
        tool_ ? "steel" : draw_.of({"steel", "alloy"}));
    if (times > 1.0) {
      has_dimension_ = true;
      add("{} = [\"{:.4g} mm\", \"{:.4g} mm\"]\n", dimension, least, least * times);
    } else {
      add("{} = \"{:.4g} mm\"\n", dimension, least);
    }
  }

  void tool() {
    add("[tool]\naxis = \"x\"\nforce = {{ x = \"{:.4g} N\" }}\ndeflection = \"{:.3g} mm\"\n",
        draw_.scale(5.0, 150.0),
        draw_.scale(0.02, 1.0));
    if (draw_.chance(0.6)) add("position_error = \"{:.3g} mm\"\n", draw_.scale(0.1, 1.0));
  }

  Draw& draw_;
  std::string text_;
  int count_ = 1;
  bool tool_ = false, rotary_ = false, upright_ = false, has_dimension_ = false;
  bool has_guide_ = false;
  double stroke_ = 100.0, mass_ = 1.0, ramp_ = 0.0, shortest_ = 0.1;
};

}  // namespace millwright
