// SPDX-License-Identifier: Apache-2.0
//
// What a person wants: a machine of axes, what each must do, and from which catalogues its parts may be chosen. Plain
// data in SI; `where` fields point into the problem file, so that whatever is said later about an axis can name its
// line.
#pragma once

#include <array>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "machine/cutting_process.h"
#include "machine/measured_profile.h"
#include "machine/objective.h"
#include "machine/requirement.h"
#include "text/source_text.h"

namespace millwright::machine {

using text::SourceSpan;

/// A value that may be fixed (lower == upper) or left to the optimiser.
struct Range {
  double lower = 0.0;
  double upper = 0.0;
  [[nodiscard]] bool fixed() const { return lower == upper; }
};

enum class Direction { horizontal, vertical, inclined };

/// End conditions of a screw: motor end first.
enum class Ends { fixed_free, supported_supported, fixed_supported, fixed_fixed };

/// One rest-to-rest move. Trapezoidal profile with equal ramps, or jerk-limited with equal ramps where a jerk is given;
/// time fixes the speed, or the speed is given. Or what was measured on a machine.
struct Move {
  std::string name;
  double distance = 0.0;                    ///< m; of a rotary axis rad, as below rad/s and N.m
  std::optional<double> time;               ///< s, of the move; a limit if `speed` is given too
  std::optional<double> speed;              ///< m/s, of the constant part
  std::optional<double> acceleration_time;  ///< s; else the axis's
  std::optional<double> jerk;               ///< m/s^3, its own or the axis's; without one acceleration may jump
  std::optional<MeasuredProfile> profile;   ///< instead of distance, time, speed, ramps, jerk and force
  double force = 0.0;                       ///< N, process force against the motion; of `cutting` if that is given
  std::optional<CuttingProcess> cutting;    ///< what the tool does in this move; sets force and speed
  double dwell = 0.0;                       ///< s after the move
  bool counts_in_cycle = true;              ///< of the machine; a coordinated move counts on one of its axes only
  bool returns = false;                     ///< done there and back: a coordinated move on which an axis climbs
  SourceSpan where;
};

/// Whether a move is done with the ramps that are chosen for its axis.
inline bool uses_chosen_ramp(const Move& move) { return !move.acceleration_time && !move.profile; }

/// rack: the motor's pinion rolls on a rack. rotary: the motor turns a table; every length of such an axis is an angle
/// (rad), every force a torque (N.m), and inertias (kg.m2) stand for masses.
enum class MechanismKind { screw, belt, rack, rotary };

/// A reduction by gear or belt between the motor and what it turns, as the problem states it.
struct Reduction {
  std::string name;    ///< on the bill of materials; may be empty where it is the only one
  double ratio = 1.0;  ///< turns of the motor for one of its output
  double efficiency = 1.0;
  double inertia = 0.0;                 ///< kg.m2, at its input
  double backlash = 0.0;                ///< rad, at its output
  double mass = 0.0;                    ///< kg
  double shaft = 0.0;                   ///< m, diameter of the output shaft; 0 where its last wheel sits on the screw
  std::optional<double> rated_torque;   ///< N.m, at its output
  std::optional<double> largest_speed;  ///< rad/s, of its input
  std::optional<double> stiffness;      ///< N.m/rad, at its output; without it counts as stiff
  double price = 0.0;                   ///< in `currency`
  std::string currency = "USD";
  SourceSpan where;
};

struct Mechanism {
  MechanismKind kind = MechanismKind::screw;
  double drives = 1.0;      ///< equal drives side by side (two screws of a gantry), each with its own motor
  double load_share = 1.0;  ///< of mass and forces that the most loaded of them takes
  // screw
  bool ball_screws = false;
  bool lead_screws = false;
  std::vector<std::string> thread_forms;   ///< of lead screws; empty = all
  std::vector<std::string> nut_materials;  ///< words that must occur in the nut's material; empty = all
  Ends ends = Ends::fixed_supported;
  double end_allowance = 0.080;           ///< m, both journals and the coupling side together
  bool greased = true;                    ///< friction of sliding nuts: greased or dry
  std::optional<double> thread_friction;  ///< overrides the nut's catalogue friction
  double ball_friction = 0.005;           ///< of the balls, DIN/THK range 0.003 to 0.01
  double preload_fraction = 0.0;          ///< of the dynamic load rating
  std::optional<double> length;           ///< m, supported length if it is given
  bool nut_rotates = false;               ///< the screw stands; nut and motor move with the axis
  double nut_inertia = 0.0;               ///< kg.m2, of a nut that turns with the wheel on it
  // belt
  std::vector<std::string> profiles;  ///< belt profiles; empty = all
  double belt_efficiency = 0.95;
  double idler_distance = 0.0;  ///< m, added to stroke + carriage for the pulley centre distance
  // rack
  bool motor_rides = true;        ///< motor and pinion move with the axis and the rack stands; else the other way round
  double rack_efficiency = 0.95;  ///< of the mesh
  double backlash = 1e-4;         ///< m, of the mesh, as it is set
  std::vector<Reduction> reductions;  ///< of which one is chosen; empty = the motor drives directly
  SourceSpan where;
};

/// A part by its names.
struct PartName {
  std::string manufacturer;  ///< empty = whoever makes it
  std::string part_number;
};

struct MotorChoice {
  std::vector<std::string> frames;  ///< NEMA frames that may be mounted; empty = all
  std::vector<double> currents;     ///< A, that may be set at the driver; empty = current_factor times the rated one
  double microsteps = 16.0;
  double brake_torque = 0.0;  ///< N.m; 0 = no brake
  /// Of what is judged instead of chosen: no other motor, no other driver matters.
  std::optional<PartName> given, given_driver;
  SourceSpan where;
  /// A, peak currents [row of the drivers] that say which of `currents` a driver gives, where its own figure is moved
  /// within its tolerance; empty = its own figures.
  std::vector<double> driver_currents;
};

/// Directions of the machine: x and y level, z upright.
inline constexpr std::array<std::string_view, 3> direction_names{"x", "y", "z"};
inline constexpr std::size_t upright = 2;

/// What presses on the tool and how far it may give way (C-TOOL-DEFL-X, -Y, -Z) or be off (C-TOOL-ERROR-X, -Y, -Z).
struct Tool {
  std::size_t axis = 0;                                        ///< that carries the tool
  std::array<double, 3> force{};                               ///< N, along each direction; 0 = not asked
  std::optional<double> deflection;                            ///< m, in any of them
  double stiffness = std::numeric_limits<double>::infinity();  ///< N/m, of the tool in its holder
  std::optional<double> position_error;                        ///< m, in any direction, with the tool pressed
  /// m, in whose hundredths what gives way and errors are counted: the limits themselves, unless another is stated.
  std::optional<double> deflection_scale, position_error_scale;
  SourceSpan where;
};

/// Profile rails or round shafts that carry the axis.
struct GuideChoice {
  std::vector<std::string> kinds;  ///< words in the catalogue's kind; empty = all
  double rails = 2.0;
  double carriages = 4.0;         ///< in all
  double carriage_spacing = 0.0;  ///< m along the travel
  double rail_spacing = 0.0;      ///< m
  double load_offset_x = 0.0;     ///< m, of the moved weight from the centre of the carriages
  double load_offset_y = 0.0;
  double load_height = 0.0;  ///< m, of the moved mass above the line of the drive
  bool load_height_stated = false;
  double force_height = 0.0;               ///< m, process force above the carriages
  bool self_aligning = false;              ///< bushings that follow the slope of their shaft
  std::optional<double> drive_offset;      ///< m, of the drive's line from the shaft, across it
  std::optional<double> bushing_friction;  ///< overrides the catalogue's, for plain bushings
  /// m, of the tool from the centre of the carriages: along the travel, across it, above the guides. With every other
  /// axis in the middle of its stroke.
  std::optional<std::array<double, 3>> tool_at;
  SourceSpan where;
};

enum class MemberKind { round_shaft, rectangular_bar, section_beam, column, weld, plate, portal_frame, bolts };
enum class BeamSupport { supported, fixed, cantilever };
/// How the surface of a shaft was made, for its endurance limit.
enum class SurfaceFinish { ground, machined, hot_rolled, forged };

/// What a joint of screws holds: all that its axis carries, each motor at its flange, or each carriage of the guide.
enum class Held { burden, motor, carriage };

/// A joint of a rectangular pattern of equal screws on an upright face: the load pulls down along the face at a lever
/// arm from it, so that the joint is sheared and tilts about its lower edge; a lateral force does so sideways.
struct BoltPattern {
  Held holds = Held::burden;
  double rows = 2.0, columns = 2.0;           ///< upwards, across
  double row_spacing = 0.0;                   ///< m
  double column_spacing = 0.0;                ///< m
  double edge_distance = 0.0;                 ///< m, from the edge about which the joint tilts to the nearest screws
  double eccentricity = 0.0;                  ///< m, of the load from the centre of the pattern, along the face
  double pull_force = 0.0;                    ///< N, straight off the face, on all joints together
  double friction = 0.15;                     ///< of the joint; 0.15 steel dry, 0.12 aluminium, 0.10 painted
  double joint_constant = 0.25;               ///< share of an external tension that a screw feels
  double nut_factor = 0.2;                    ///< tightening torque over preload and diameter, dry
  std::optional<double> tightening_torque;    ///< N.m; without it the preload is a share of the proof load
  bool fitted = false;                        ///< screws fill their holes and carry the shear themselves
  std::vector<std::string> sizes;             ///< designations (M6, M8x1, ...); empty = all
  std::vector<std::string> property_classes;  ///< 8.8, 10.9, A2-70, ...; empty = all
  [[nodiscard]] double count() const { return rows * columns; }
};

/// A piece of structure: its size is chosen (a catalogue section, or free dimensions) so that it carries the axis.
struct Member {
  std::string name;  ///< slot name: beam, column, shaft, weld
  MemberKind kind = MemberKind::section_beam;
  BeamSupport support = BeamSupport::supported;
  double length = 0.0;                     ///< m, span; of a plate between the rails, of a portal's beam
  double count = 1.0;                      ///< members sharing the load equally
  double extra_force = 0.0;                ///< N, beside the weight of what the axis carries
  double lateral_force = 0.0;              ///< N, horizontal, across the member
  double torque = 0.0;                     ///< N.m, twisting the members
  double load_share = 1.0;                 ///< of the carried weight that this group of members takes
  bool is_guide = false;                   ///< a guide shaft: C-GD-*, else a frame member: C-FR-*
  bool rides = false;                      ///< moves with the axis instead of standing on its parent
  std::vector<std::string> sections;       ///< families a section may come from
  std::vector<std::string> section_kinds;  ///< words in the catalogue's kind (channel, angle, ...); empty = all
  std::string material;                    ///< part number in materials; bolts have none
  Range diameter;                          ///< round_shaft
  bool rotating = false;                   ///< round_shaft that turns under its load: fatigue counts
  SurfaceFinish surface = SurfaceFinish::machined;
  double notch_factor = 1.0;                    ///< on the stress amplitude of a rotating shaft
  Range width, height;                          ///< rectangular_bar
  Range thickness;                              ///< plate
  double plate_width = 0.0;                     ///< m, plate, across its span
  double column_height = 0.0;                   ///< m, portal_frame
  double lever_arm = 0.0;                       ///< m, weld, bolts: of the force about the joint
  double joint_width = 0.0, joint_depth = 0.0;  ///< m, weld all around a rectangle
  Range leg;                                    ///< m, weld leg
  BoltPattern bolts;
  double end_fixity = 1.0;           ///< column; a portal free to sway 0.25
  std::optional<std::size_t> along;  ///< direction of the machine in which it lies; else the travel of its axis
  SourceSpan where;
};

struct Axis {
  std::string name;
  std::vector<std::string> carries;
  Direction direction = Direction::horizontal;
  std::optional<std::size_t> along;   ///< direction of the machine in which the axis travels
  std::optional<std::size_t> normal;  ///< direction of the machine in which its guides press
  double inclination = 0.0;           ///< rad; 0 horizontal, pi/2 vertical
  double stroke = 0.0;                ///< m
  double structure_mass = 0.0;        ///< kg, moves with the axis and is not chosen here
  double payload_mass = 0.0;          ///< kg, tool or workpiece
  double guide_friction = 0.0;        ///< coefficient on the weight normal to the travel
  double guide_drag = 0.0;            ///< N, constant
  double counterbalance_force = 0.0;  ///< N
  double inertia = 0.0;               ///< kg.m2, of a rotary axis, about its axis of rotation: table and workpiece
  double friction_torque = 0.0;       ///< N.m, of a rotary axis
  Mechanism mechanism;
  MotorChoice motor;
  std::optional<GuideChoice> guide;
  std::vector<Member> members;
  std::vector<Move> moves;
  Range acceleration_time{0.05, 0.5};
  std::optional<double> jerk;  ///< m/s^3, of moves that state none
  Requirements require;
  bool keep_every_candidate = false;     ///< whatever is given is judged: also what can never be compliant
  bool keep_every_driver = false;        ///< that gives a current which may be set, whatever it costs and runs at
  bool keep_covered_candidates = false;  ///< also candidates that another one beats in every respect
  /// Of those only such as fewer than so many others beat.
  std::size_t most_covering = std::numeric_limits<std::size_t>::max();
  /// Whether what is asked reads the total cost, and the total mass; it decides between equals even where it does not.
  bool cost_counts = true, mass_counts = true;
  SourceSpan where;

  // filled by the reader
  std::optional<std::size_t> carried_by;  ///< index of the parent axis
  bool stiffness_counts = false;          ///< [tool] reads how far its parts give way
};

inline bool is_rotary(const Axis& axis) { return axis.mechanism.kind == MechanismKind::rotary; }

/// Mass of what rides of the drives and is chosen after guides and structure, for which these are sized [kg]; each
/// drive is held to its part (F-NUT-MASS, F-NUT-RIDING-MASS, F-BELT-MASS, F-RACK-RIDING-MASS).
inline double riding_mass_allowance(const Axis& axis) {
  const auto allowance = [&](Requirement each) { return axis.mechanism.drives * axis.require(each); };
  switch (axis.mechanism.kind) {
    case MechanismKind::screw:
      return allowance(axis.mechanism.nut_rotates ? Requirement::rotating_nut_mass_allowance
                                                  : Requirement::nut_mass_allowance);
    case MechanismKind::belt:
      return allowance(Requirement::belt_mass_allowance);
    case MechanismKind::rack:
      return allowance(Requirement::rack_drive_mass_allowance);
    case MechanismKind::rotary:
      break;
  }
  return 0.0;
}

/// Whether a coupling joins the screw to the shaft that turns it: not where the nut turns, round the screw, and not
/// where the last wheel of a reduction sits on the screw.
inline bool has_coupling(const Mechanism& mechanism) {
  return mechanism.kind == MechanismKind::screw && !mechanism.nut_rotates &&
         (mechanism.reductions.empty() || mechanism.reductions.front().shaft > 0.0);
}

struct CurrencyRate {
  double rate = 1.0;  ///< of one unit, in the problem's currency
  std::string date;
};

/// Pieces bought beside those that the machine takes.
struct Spare {
  std::string axis;  ///< empty: of every axis that has the slot, or of the machine
  std::string slot;
  double pieces = 0.0;
};

inline constexpr double usual_preference = 0.05;

struct Problem {
  std::string title;
  std::string source;
  std::string file;
  std::string objective = "cost";  ///< by its name, see objective.h
  std::vector<Quantity> counted;   ///< beside cost and mass: what an objective or limit asks for
  std::string currency = "USD";
  std::map<std::string, CurrencyRate, std::less<>> currencies;
  SourceSpan currencies_where;          ///< their table; the beginning of the file if it has none
  std::vector<double> supply_voltages;  ///< V
  std::vector<std::string> catalogues;  ///< overlay folders beside the problem file
  std::vector<Axis> axes;               ///< as in the file
  std::vector<std::size_t> order;       ///< axes from the tools to the bases: an axis comes after all it carries
  Requirements require;                 ///< of the whole machine; each axis has its own, which start from these
  std::optional<Tool> tool;
  std::vector<Spare> spares;
  /// By how much of its price a preferred part may be dearer than what would be chosen otherwise; without it nothing is
  /// preferred.
  std::optional<double> preference = usual_preference;
  QuantityLimits limits;  ///< of the whole machine
};

/// Of the part that is chosen for a slot; both where a slot is named alone and with its axis.
double spares_of(const Problem& problem, std::string_view axis, std::string_view slot);

/// Why a quantity of this problem cannot be summed up, and what to do about it.
struct Uncountable {
  std::string message, hint;
};
std::optional<Uncountable> uncountable(const Problem& problem, Quantity quantity);

/// Whether the machine's cycle time hangs on the ramp that is chosen for an axis: the shorter, the less.
bool cycle_time_hangs_on_ramp(const Axis& axis);

}  // namespace millwright::machine
