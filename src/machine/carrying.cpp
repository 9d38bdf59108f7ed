// SPDX-License-Identifier: Apache-2.0
#include "machine/carrying.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "text/nearest.h"

namespace millwright::machine {

using text::Diagnostics;
using text::Node;

namespace {

class Forest {
 public:
  Forest(const Node& axes, Problem& problem, Diagnostics& diagnostics)
      : axes_(axes), problem_(problem), diagnostics_(diagnostics), carried_at_(problem.axes.size(), nullptr) {}

  void link() {
    for (const Axis& axis : problem_.axes) names_.push_back(axis.name);
    for (std::size_t parent = 0; parent < problem_.axes.size(); ++parent)
      for (const Node* entry : entries(parent))
        if (entry->is_string()) link_one(parent, *entry);
    report_circles();
    std::vector<bool> visited(problem_.axes.size(), false);
    for (std::size_t i = 0; i < problem_.axes.size(); ++i)
      if (!problem_.axes[i].carried_by) visit(i, visited);
  }

 private:
  std::vector<const Node*> entries(std::size_t parent) const {
    std::vector<const Node*> nodes;
    const Node* carries = axes_.at(parent).find("carries");
    if (carries == nullptr) return nodes;
    if (!carries->is_array()) return {carries};
    for (const Node& item : carries->items()) nodes.push_back(&item);
    return nodes;
  }

  void link_one(std::size_t parent, const Node& entry) {
    const std::string name = *entry.as_string();
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found == names_.end()) {
      diagnostics_.error(entry.span(),
                         fmt::format("carries: there is no axis {}", text::in_quotes(name)),
                         text::did_you_mean(name, names_, fmt::format("axes: {}", fmt::join(names_, ", "))));
      return;
    }
    const auto child = static_cast<std::size_t>(found - names_.begin());
    if (child == parent) {
      diagnostics_.error(entry.span(), fmt::format("carries: axis '{}' carries itself", name), "leave it out");
      return;
    }
    if (carried_at_[child] != nullptr) {
      text::Diagnostic twice;
      twice.where = entry.span();
      twice.message = fmt::format(
          "carries: axis '{}' is carried already, by '{}'", name, problem_.axes[*problem_.axes[child].carried_by].name);
      twice.hint = "an axis stands on one other axis; name it in one place only";
      twice.related = carried_at_[child]->span();
      twice.related_message = "first here";
      diagnostics_.add(std::move(twice));
      return;
    }
    problem_.axes[child].carried_by = parent;
    carried_at_[child] = &entry;
  }

  /// Whoever is carried has one carrier, so walking upwards from an axis either ends at a base or runs in a circle.
  void report_circles() {
    std::vector<bool> known(problem_.axes.size(), false);
    for (std::size_t start = 0; start < problem_.axes.size(); ++start) {
      std::vector<std::size_t> path;
      std::optional<std::size_t> at = start;
      while (at && !known[*at]) {
        known[*at] = true;
        path.push_back(*at);
        at = problem_.axes[*at].carried_by;
      }
      if (!at) continue;
      const auto begin = std::find(path.begin(), path.end(), *at);
      if (begin != path.end()) report_circle({begin, path.end()});
    }
  }

  /// `circle`: each axis is carried by the next one, the last by the first.
  void report_circle(const std::vector<std::size_t>& circle) {
    std::string chain = fmt::format("'{}'", names_[circle.front()]);
    for (std::size_t i = circle.size(); i-- > 0;) chain += fmt::format(" carries '{}'", names_[circle[i]]);
    diagnostics_.error(carried_at_[circle.back()]->span(),
                       fmt::format("carries: a circle, {}", chain),
                       "an axis cannot stand on what it carries; leave one of these out");
  }

  void visit(std::size_t index, std::vector<bool>& visited) {
    if (visited[index]) return;
    visited[index] = true;
    for (std::size_t child = 0; child < problem_.axes.size(); ++child)
      if (problem_.axes[child].carried_by == index) visit(child, visited);
    problem_.order.push_back(index);
  }

  const Node& axes_;
  Problem& problem_;
  Diagnostics& diagnostics_;
  std::vector<const Node*> carried_at_;  ///< the entry of `carries` that names the axis
  std::vector<std::string> names_;
};

}  // namespace

void link_axes(const Node& axes, Problem& problem, Diagnostics& diagnostics) {
  Forest(axes, problem, diagnostics).link();
}

std::vector<std::size_t> carriers(const Problem& problem, std::size_t axis) {
  std::vector<std::size_t> result{axis};
  while (problem.axes[result.back()].carried_by) result.push_back(*problem.axes[result.back()].carried_by);
  return result;
}

double stated_mass(const Problem& problem, std::size_t axis) {
  double mass = problem.axes[axis].structure_mass + problem.axes[axis].payload_mass;
  for (std::size_t i = 0; i < problem.axes.size(); ++i)
    if (problem.axes[i].carried_by == axis) mass += stated_mass(problem, i);
  return mass;
}

}  // namespace millwright::machine
