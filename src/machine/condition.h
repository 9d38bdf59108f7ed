// SPDX-License-Identifier: Apache-2.0
//
// What a problem asks for and could ask less of: factors and limits, times and forces of moves, loads, budgets, the
// supply voltage, wishes about kinds of parts, what the command line fixes or leaves out. Each knows its place, its
// value, and how to be eased or lifted, so that whoever explains an answer can try what becomes of the machine then.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "catalogue/catalogue.h"
#include "machine/problem.h"
#include "machine/steering.h"
#include "text/document.h"

namespace millwright::machine {

/// All that a machine is asked: the problem, and what the command line fixes and leaves out.
struct Asked {
  Problem problem;
  BillOfMaterials fixed;
  std::vector<ExcludedPart> without;
  std::vector<LimitOption> limits;  ///< those of the command line, which are in the problem too
};

/// number: a value with a looser side. budget: a limit of the whole machine. choice: a list of what is permitted.
enum class ConditionKind { number, budget, choice };

struct Condition {
  std::string axis;     ///< "machine" for what no single axis asks
  std::string name;     ///< "torque_margin", "time of move 'lift'", "supply voltage"
  std::string meaning;  ///< of a factor or limit
  std::string setting;  ///< what `--set` would change; empty if there is no such path
  text::SourceSpan where;
  bool given = true;   ///< else a default, and `source` says whose
  std::string source;  ///< of a default
  ConditionKind kind = ConditionKind::number;
  double value = std::numeric_limits<double>::quiet_NaN();  ///< SI, or in the problem's currency
  std::string unit;                                         ///< SI; empty for money
  bool larger_is_looser = true;
  Quantity quantity = Quantity::cost;  ///< of a budget
  double from_zero = 0.0;              ///< SI, of a value near 0: eased by a factor, it gains this times what exceeds 1
  double furthest = 1e6;               ///< by this factor eased it is as good as lifted, or as far as makes sense
  std::string present;                 ///< of a choice, in words: "NEMA17, NEMA23"
  std::string slot;                    ///< of a choice: the slot or setting in which a build shows what it took instead
  bool no_part = false;  ///< what gives more of it is bought, but is none of the parts that are chosen and priced here
  std::vector<double> stops;       ///< of what may be had instead: values to try, ascending, as more of it is no looser
  std::vector<Condition> instead;  ///< numbers of which some serves as well as less of this condition
  std::function<void(Asked&, double)> set;  ///< to another value; none of a choice
  std::function<void(Asked&)> lift;         ///< not asked any more
  /// What has to be written beside `setting`, which alone changes that too:
  /// "axis.z.require.torque_margin_estimate=0.5".
  std::string beside = {};

  /// The value eased by a factor above 1.
  [[nodiscard]] double eased(double factor) const {
    return larger_is_looser ? value * factor + from_zero * (factor - 1.0) : value / factor;
  }
};

/// Everything that could be eased: what the user wrote before defaults, loads last. `document`: where the problem was
/// read from, for places; `catalogue`: for the supplies that there are.
std::vector<Condition> conditions_of(const Asked& asked,
                                     const text::Document& document,
                                     const catalogue::Catalogue& catalogue);

/// "10000 h", "0.7", "24 V", "400 USD": a value of a condition as people read it, in the unit of its present value,
/// to `digits` significant digits.
std::string shown(const Condition& condition, double value, const std::string& currency, int digits = 4);

/// The unit in which shown() gives a condition's values.
struct ShownUnit {
  std::string name;    ///< "1" of a plain number
  double in_si = 1.0;  ///< how much of the SI unit one of it is
};
ShownUnit shown_unit(const Condition& condition, const std::string& currency);

/// The next value on the looser side that has at most three significant digits in the unit in which it is shown.
double rounded_looser(const Condition& condition, double value);

}  // namespace millwright::machine
