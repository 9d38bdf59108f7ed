// SPDX-License-Identifier: Apache-2.0
#include "evaluation/outside_validity.h"

#include <algorithm>

namespace millwright::evaluation {

namespace {

std::vector<OutsideValidity::Value> values_of(const mechanics::LeftRange& left) {
  std::vector<OutsideValidity::Value> values;
  for (std::size_t i = 0; i < left.arguments.size(); ++i) {
    const mechanics::Argument& argument = left.formula->arguments()[i];
    if (const double* number = std::get_if<double>(&left.arguments[i]))
      values.push_back({argument.name, argument.unit, {*number}});
    if (const auto* list = std::get_if<std::vector<double>>(&left.arguments[i]))
      values.push_back({argument.name, argument.unit, *list});
  }
  return values;
}

}  // namespace

void ValidityLedger::take(const mechanics::ValidityWatch& watch,
                          const std::string& axis,
                          const std::string& element,
                          std::string_view constraint) {
  formulas_.insert(watch.formulas().begin(), watch.formulas().end());
  for (const mechanics::LeftRange& left : watch.left()) {
    const auto same = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
      return entry.axis == axis && entry.element == element && entry.left.formula == left.formula &&
             entry.left.limit.index == left.limit.index;
    });
    if (same == entries_.end())
      entries_.push_back({axis, element, std::string(constraint), left});
    else if (left.limit.excess > same->left.limit.excess)
      same->left = left;
  }
}

void ValidityLedger::write(Design& design) const {
  design.formulas_watched = formulas_.size();
  for (const Entry& entry : entries_) {
    OutsideValidity line;
    line.axis = entry.axis;
    line.element = entry.element;
    line.constraint = entry.constraint;
    line.formula = entry.left.formula->name();
    line.title = entry.left.formula->title();
    line.sentence = entry.left.limit.sentence;
    line.source = entry.left.formula->source();
    line.values = values_of(entry.left);
    design.outside_validity.push_back(std::move(line));
  }
}

}  // namespace millwright::evaluation
