// SPDX-License-Identifier: Apache-2.0
// Two like axes on the tiny catalogue, so that both may take the same motor, driver, coupling and supports: what tests
// of orders are tried on.
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "evaluation/synthesis.h"
#include "evaluation/tiny_catalogue.h"

namespace millwright {

/// `screws`: families to choose from, quoted. `tables`: further tables of the problem, before the axes.
inline machine::Problem two_axes(double load,
                                 const std::string& screws = "\"ball_screws\", \"lead_screws\"",
                                 const std::string& tables = {}) {
  const auto axis = [&](const char* name, const char* carries, double force) {
    return fmt::format(R"(
[[axis]]
name = "{}"
{}
stroke = "300 mm"
structure_mass = "{} kg"
guide_friction = 0.05
acceleration_time = ["0.02 s", "0.5 s"]
mechanism = {{ kind = "screw", screw = [{}], ends = "fixed-supported" }}
motor = {{ microsteps = 8 }}
[[axis.moves]]
distance = "200 mm"
time = "6 s"
force = "{} N"
)",
                       name,
                       carries,
                       load,
                       screws,
                       force);
  };
  return problem_of_text("[currency]\nUSD = 1.0\n[supply]\nvoltage = [\"24 V\", \"36 V\"]\n" + tables +
                         axis("x", "", 60.0) + axis("y", "carries = [\"x\"]", 40.0));
}

inline evaluation::Synthesis solved(const evaluation::MachineModel& model,
                                    std::vector<std::string> objectives,
                                    unsigned threads = 1) {
  evaluation::SearchOptions options;
  options.objectives = std::move(objectives);
  options.threads = threads;
  return evaluation::synthesise(model, options);
}

}  // namespace millwright
