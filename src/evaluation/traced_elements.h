// SPDX-License-Identifier: Apache-2.0
//
// The elements of a finished design once more, on numbers that remember their formulas: every figure that an element
// starts from gets a symbol, and its own `derive` and constraints do the rest. The values are those of the element on
// double, bit for bit.
#pragma once

#include <span>
#include <vector>

#include "evaluation/machine_stages.h"
#include "evaluation/worksheet.h"

namespace millwright::evaluation {

/// What a figure is called on a worksheet; literals.
struct FigureName {
  const char *symbol, *meaning, *unit;
};

/// Collects the figures of an element as they get their symbols.
class GivenFigures {
 public:
  explicit GivenFigures(std::vector<GivenFigure>& given) : given_(given) {}

  scalar::Traced take(const FigureName& name, double value) { return take_of({}, name, value); }
  /// A figure from the calculation of an axis' drive.
  scalar::Traced take_of(const std::string& axis, const FigureName& name, double value) {
    given_.push_back({name.symbol, name.meaning, value, name.unit, axis});
    return scalar::Traced::leaf(name.symbol, value, scalar::Unit::of(name.unit));
  }
  /// Field by field; `walk(reading, visit)` visits the fields of a reading on any scalar, in the order of the names.
  template <class From, class To, class Walk>
  void take_all(std::span<const FigureName> names, const From& from, To& to, Walk walk) {
    std::vector<double> values;
    walk(from, [&](const double& x) { values.push_back(x); });
    std::size_t i = 0;
    walk(to, [&](scalar::Traced& x) {
      x = take(names[i], values[i]);
      ++i;
    });
  }

 private:
  std::vector<GivenFigure>& given_;
};

/// Rows that were chosen in a stage, and the place of the supply voltage among those of the problem.
struct ChosenRows {
  std::span<const solver::Row> rows;
  std::size_t voltage = 0;
};

/// The sides of every check that concerns the element, and the figures behind them.
void write_calculation(const ScrewDriveStage& stage,
                       const machine::ScrewDrive<double>& element,
                       const ChosenRows& chosen,
                       ElementWorksheet& sheet);
void write_calculation(const BeltDriveStage& stage,
                       const machine::BeltDrive<double>& element,
                       const ChosenRows& chosen,
                       ElementWorksheet& sheet);
void write_calculation(const RackDriveStage& stage,
                       const machine::RackDrive<double>& element,
                       const ChosenRows& chosen,
                       ElementWorksheet& sheet);
void write_calculation(const RotaryDriveStage& stage,
                       const machine::RotaryDrive<double>& element,
                       const ChosenRows& chosen,
                       ElementWorksheet& sheet);
void write_calculation(const machine::GuideSystem<double>& element, ElementWorksheet& sheet);
void write_calculation(const machine::StructureMember<double>& element, ElementWorksheet& sheet);
void write_calculation(const machine::BoltedJoint<double>& element, ElementWorksheet& sheet);
void write_calculation(const Supply<double>& element, ElementWorksheet& sheet);
void write_calculation(const WholeMachine<double>& element, ElementWorksheet& sheet);

/// Takes the constraints of an element one by one and writes down both sides of those that concern it.
template <class Element>
class CalculationVisitor {
 public:
  CalculationVisitor(const Element& element, ElementWorksheet& sheet) : element_(element), sheet_(sheet) {}
  template <class When, class Demand, class Capacity>
  void operator()(const machine::Declaration& declaration, When when, Demand demand, Capacity capacity) {
    if (when(element_) != machine::Applies::yes) return;
    const scalar::Traced used = demand(element_);
    add(declaration.id, used, capacity(element_));
  }

 private:
  void add(std::string_view id, const scalar::Traced& demand, const scalar::Traced& capacity) {
    sheet_.checks.push_back({std::string(id), demand, capacity});
  }

  const Element& element_;
  ElementWorksheet& sheet_;
};

}  // namespace millwright::evaluation
