// SPDX-License-Identifier: Apache-2.0
// One search, watched: what solve and pareto do once, and a sweep at each of its values.
#pragma once

#include "app/machine_input.h"
#include "app/options.h"
#include "app/search_watch.h"
#include "evaluation/machine_model.h"
#include "report/result.h"

namespace millwright::app {

/// By name (machine/objective.h): those asked for, or that of the problem file.
std::vector<std::string> objectives_of(const Options& options, const MachineInput& input);

/// The unit in which progress counts.
std::string objective_unit_of(const Options& options, const MachineInput& input);

/// The answer with its certificate; for machines without a build, what fails whatever is chosen. Every build was
/// evaluated again from scratch: one that then fails a check is a mistake of ours, std::logic_error.
report::MachineResult search_machine(const Options& options,
                                     const MachineInput& input,
                                     const evaluation::MachineModel& model,
                                     StopSignal& stop,
                                     ProgressLine& line);

/// Adds to the answer of a machine without a build the ways out; the search for them is within the time limit too.
void add_ways_out(const Options& options,
                  const evaluation::MachineModel& model,
                  const StopSignal& stop,
                  report::MachineResult& result);

}  // namespace millwright::app
