// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "machine/problem.h"
#include "text/diagnostic.h"
#include "text/node.h"
#include "text/table_reader.h"

namespace millwright::machine {

/// What of the whole problem file an axis depends on.
struct AxisSurroundings {
  Requirements require;            ///< of the whole machine, which the axis's own override
  std::set<std::string> together;  ///< axes that [[moves]] of the machine move, and that need none of their own
  std::filesystem::path folder;    ///< of the problem file
};

/// One [[axis]] of a problem file.
Axis read_axis(const text::Node& node, const AxisSurroundings& around, text::Diagnostics& diagnostics);

/// A table of requirements, by their declared keys and units.
void read_requirements(const text::Node& node,
                       const std::string& title,
                       Requirements& require,
                       text::Diagnostics& diagnostics);

/// The parts of an axis: what drives it, its motor, what it slides on. `title` in messages: "mechanism of axis 'x'".
Mechanism read_mechanism(const text::Node& node, const std::string& title, text::Diagnostics& diagnostics);
/// The keys of a rack and of a rotary table in the table of a mechanism.
void read_rack(text::TableReader& table, Mechanism& mechanism, text::Diagnostics& diagnostics);
void read_rotary(text::TableReader& table, Mechanism& mechanism, text::Diagnostics& diagnostics);
/// The reductions of a mechanism whose other keys have been read: one table, or a list of which one is chosen.
void read_reductions(text::TableReader& table, Mechanism& mechanism, text::Diagnostics& diagnostics);
/// Whether an [[axis]] says that it turns; its stroke, loads and moves are angles, inertias and torques then.
bool says_rotary(const text::Node& axis);
void read_rotary_loads(text::TableReader& table, Axis& axis, text::Diagnostics& diagnostics);
/// Refuses requirements of an [axis.require] that are about the other kind of travel.
void check_accuracy_keys(const text::Node& require, bool rotary, text::Diagnostics& diagnostics);
MotorChoice read_motor(const text::Node& node, const std::string& title, text::Diagnostics& diagnostics);
GuideChoice read_guide(const text::Node& node, const std::string& title, text::Diagnostics& diagnostics);

/// The moves of an axis, checked against its stroke and its ramps as far as those could be read themselves. `axis` has
/// everything but its moves and gets them here.
struct MoveLimits {
  bool stroke = false;                      ///< whether the axis's stroke is known
  bool ramps = false;                       ///< whether its range of acceleration times is known (or the default)
  const text::Node* ramps_given = nullptr;  ///< the range in the file, if any
  const text::Node* jerk_given = nullptr;   ///< the axis's jerk in the file, if any
  std::filesystem::path folder;             ///< of the problem file, where measured profiles are
};
void read_moves(const text::Node& moves, const MoveLimits& limits, Axis& axis, text::Diagnostics& diagnostics);

/// Reports a move whose own ramp, or the shortest of `ramps`, does not fit, or whose jerk asks for a longer one than
/// there is time for. `node` has its keys.
void check_ramps(const text::Node& node,
                 const Move& move,
                 bool rotary,
                 const MoveLimits& limits,
                 const Range& ramps,
                 text::Diagnostics& diagnostics);
/// Reports a travel that is longer than the stroke of its axis.
void check_travel(
    const SourceSpan& where, std::string_view what, double travel, const Axis& axis, text::Diagnostics& diagnostics);

/// An axis whose moves all bring their own ramps, or were measured, has none to choose.
void settle_ramps(Axis& axis);

/// The names of all axes in the [[moves]] of a machine, whether there are such axes or not.
std::set<std::string> axes_moved_together(const text::Node& moves);
/// The [[moves]] of a machine: coordinated moves of axes that have been read; each becomes a move of every axis it
/// names. `strokes`: whether all axes could be read.
void read_coordinated_moves(const text::Node& moves, bool strokes, Problem& problem, text::Diagnostics& diagnostics);

/// A measured profile, from the file that the node names. Its first column is the time; of a rotary axis the others
/// are angle or speed, and torque.
std::optional<MeasuredProfile> read_profile(const text::Node& node,
                                            bool rotary,
                                            const std::filesystem::path& folder,
                                            text::Diagnostics& diagnostics);

/// What the tool does in a move; none if it cannot be read.
std::optional<CuttingProcess> read_cutting(const text::Node& node,
                                           const std::string& title,
                                           text::Diagnostics& diagnostics);

/// What a joint of screws has beside the load of every member.
void read_bolts(text::TableReader& table, Member& member, text::Diagnostics& diagnostics);

/// x, y or z.
std::optional<std::size_t> read_direction_name(text::TableReader& table, const text::Key& key);
/// In which directions of the machine an axis travels and its guides press, as far as that is said or follows.
void read_axis_directions(text::TableReader& table, Axis& axis, text::Diagnostics& diagnostics);
/// [tool], once the axes are known. `axes`: their nodes, if they could be read.
void read_tool(const text::Node& node, const text::Node* axes, Problem& problem, text::Diagnostics& diagnostics);

/// A structure member of an axis.
Member read_member(const text::Node& node, const std::string& axis, text::Diagnostics& diagnostics);

/// Warns at the value if a coefficient that could be read is above what is usual.
void warn_above(const text::Node& table,
                std::string_view key,
                double value,
                double usual,
                const std::string& hint,
                text::Diagnostics& diagnostics);

}  // namespace millwright::machine
