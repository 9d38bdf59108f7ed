// SPDX-License-Identifier: Apache-2.0
//
// The outcome for one design: what it is made of and every check with value, limit and verdict, evaluated from scratch
// in double.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/tolerance_check.h"
#include "evaluation/worksheet.h"
#include "machine/constraint.h"
#include "machine/objective.h"

namespace millwright::evaluation {

/// Totals of cost and mass are sums of the same numbers in another order here and there.
inline constexpr double rounding_of_totals = 1e-9;

enum class Verdict { satisfied, violated, not_evaluated };

struct Check {
  std::string axis;     ///< "machine" for what no single axis owns
  std::string element;  ///< "drive", "guide", a member's name, "supply"
  std::string id, title, symbol;
  machine::ConstraintKind kind = machine::ConstraintKind::hard;
  double value = 0.0;  ///< demand, in `unit`
  double limit = 0.0;  ///< capacity, in `unit`
  std::string unit;
  double utilisation = 0.0;  ///< demand/capacity, 1 is the limit
  Verdict verdict = Verdict::satisfied;
  std::string phase;     ///< of the duty cycle, where the worst case occurs; empty if it has none
  std::string position;  ///< of the travel, where the worst case occurs; empty if it is the same everywhere
  std::vector<Contribution> contributions;  ///< to an error budget, in `unit`
  std::string source;
  std::string requirement;  ///< key of the factor or limit, empty if none
  std::string note;         ///< "torque is an estimate: no published curve", ...
};

/// Equal pieces to cut from what is sold by length or mass.
struct Cut {
  double count = 1.0;
  double length = 0.0;  ///< m
  double width = 0.0;   ///< m, of a plate
};

struct PartLine {
  std::string axis, slot, family, manufacturer, part_number;
  double quantity = 1.0;
  double spares = 0.0;        ///< pieces bought beside those in the machine
  double length = 0.0;        ///< m, 0 for whole pieces
  double owned = 0.0;         ///< pieces of both that are there already
  double unit_price = 0.0;    ///< of each piece that is not, in `currency`
  double price = 0.0;         ///< of the line, in `currency`
  std::vector<Cut> cuts;      ///< empty for what is bought in whole pieces; of a guide its rails
  double length_price = 0.0;  ///< share of `price` that is paid for lengths and for work on what is cut
  double cutting_loss = 0.0;  ///< m, paid with every piece where no whole bars are bought
  double cut_price = 0.0;     ///< of it, of cutting one piece
  double end_price = 0.0;     ///< of it, of machining one end
  double ends = 0.0;          ///< so many ends are machined
  bool from_bars = false;     ///< cut from whole bars (Design::bars), whose price lines share by length
  std::string currency;
  std::string stated_currency;  ///< in which `price` was stated before it was converted; empty if it was not
  double mass = 0.0;            ///< kg, of the line
  std::string where;            ///< catalogue file and line
  std::string price_basis, confidence;
  std::string supplier;         ///< who sells it at that price, where the catalogue says so
  std::string source;           ///< where the figures come from
  bool estimate = false;        ///< price or a figure of the part is an estimate
  bool price_estimate = false;  ///< the price is
  bool preferred = false;       ///< marked as such in a catalogue or stock file
  bool paper_only = false;      ///< a publication names it; no maker's document is known
  std::string origin;           ///< "paper", "ours" from a BOM; empty otherwise
};

struct DimensionLine {
  std::string axis, name;
  double value = 0.0;  ///< SI
  std::string unit;    ///< SI unit
};

/// A limit within which a formula is stated, and which the design leaves. That fails no check: it tells how far a check
/// can be trusted.
struct OutsideValidity {
  struct Value {
    std::string name, unit;
    std::vector<double> numbers;  ///< SI; one, or the elements of a list
  };
  std::string axis, element;
  std::string constraint;      ///< id of the check that uses the formula; empty where it serves several
  std::string formula, title;  ///< in the register
  std::string sentence;        ///< "lead_angle = 1.6 rad is above 1.5 rad"
  std::string source;          ///< of the formula
  std::vector<Value> values;   ///< its arguments there
};

/// What an objective or a limit counts beside cost and mass, of the whole machine.
struct CountedTotal {
  machine::Quantity quantity = machine::Quantity::cycle_time;
  double value = 0.0;  ///< SI
};

/// What has to be bought of a part whose price depends on how many are taken; the prices of its lines add up to it.
struct Purchase {
  std::string family, manufacturer, part_number, supplier;
  double taken = 0.0;   ///< pieces that the machine takes, with spares
  double owned = 0.0;   ///< of them, pieces that are there already
  double bought = 0.0;  ///< pieces to buy: whole packs, and more than needed where that costs less
  double price = 0.0;   ///< of those, in `currency` of the design
};

/// A piece that is cut.
struct BarPiece {
  std::string axis, slot;
  double length = 0.0;  ///< m
};

struct CutBar {
  std::vector<BarPiece> pieces;
  double left_over = 0.0;  ///< m
};

/// The whole bars that pieces of one part are cut from.
struct BarPurchase {
  std::string family, manufacturer, part_number, supplier;
  double stock_length = 0.0;  ///< m
  double cutting_loss = 0.0;  ///< m, between two pieces
  double bar_price = 0.0;     ///< in `currency` of the design
  std::vector<CutBar> bars;
  bool is_fewest = true;  ///< proved: these pieces need so many
};

/// An order from a supplier that charges for the order itself, in `currency` of the design.
struct ShopOrder {
  std::string supplier;  ///< empty: of what names none
  double goods = 0.0;
  double shipping_fee = 0.0;
  double minimum_order = 0.0;
  double top_up = 0.0;  ///< what the goods lack of the minimum: the order is filled up
  std::string stated_currency =
      {};  ///< in which fee and minimum were stated before conversion; empty if there was none
};

/// A rate of exchange that prices of a design were converted at.
struct Conversion {
  std::string currency;  ///< of the prices as they are stated
  double rate = 1.0;     ///< of one unit, in `currency` of the design
  std::string date;      ///< of the rate, "2026-01-15"; empty if the problem states none
};

/// What an axis has by the problem's word only: nobody has chosen a part for it.
struct StatedOnly {
  std::string axis;
  double brake_torque = 0.0;          ///< N.m, of a holding brake; 0 = none
  double counterbalance_force = 0.0;  ///< N; 0 = none
};

/// A machine fully decided.
struct Design {
  std::vector<PartLine> parts;
  std::vector<Purchase> purchases;      ///< of counted parts only
  std::vector<BarPurchase> bars;        ///< where whole bars are bought
  bool all_fewest_bars = true;          ///< of every build that this one was compared with, too
  std::vector<ShopOrder> orders;        ///< from suppliers that charge for orders only
  std::vector<Conversion> conversions;  ///< each once, by currency
  std::vector<StatedOnly> stated_only;  ///< neither bought nor weighed here
  std::vector<DimensionLine> dimensions;
  std::vector<Check> checks;
  std::vector<OutsideValidity> outside_validity;
  std::size_t formulas_watched = 0;  ///< with stated limits, among those that the design was computed with
  double cost = 0.0;
  double mass = 0.0;  ///< kg, of everything chosen
  std::vector<CountedTotal> counted;
  /// Where preferred parts could be chosen: what the search compared in place of the cost (preferred_parts.h), and by
  /// how much dearer than others they may be.
  struct Preference {
    double premium = 0.0;
    double compared_cost = 0.0;
  };
  std::optional<Preference> preference;
  std::string currency;
  double supply_voltage = 0.0;
  std::shared_ptr<const Worksheet> worksheet;        ///< null unless it was asked for
  std::shared_ptr<const ToleranceCheck> tolerances;  ///< null unless it was asked for
  /// Total of a quantity, or of the weighted sum of an objective; NaN for what was not counted.
  [[nodiscard]] double total(machine::Quantity quantity) const;
  [[nodiscard]] double total(const machine::Objective& objective) const;
  /// The same as the search compares builds: with preferred parts counted less.
  [[nodiscard]] double compared(const machine::Objective& objective) const;
  [[nodiscard]] bool satisfied() const;
  /// The hard check with the largest utilisation of an axis, null if the axis has none.
  [[nodiscard]] const Check* governing(const std::string& axis) const;
};

}  // namespace millwright::evaluation
