// SPDX-License-Identifier: Apache-2.0
// One function a verb. Each reads what it needs, reports everything that is wrong with it, prints its answer and
// returns the exit code.
#pragma once

#include "app/options.h"

namespace millwright::app {

/// solve and pareto.
int run_search(const Options& options);
/// solve, where a value of the problem goes over a range.
int run_sweep(const Options& options);
/// Whether a --set gives a range.
bool has_range(const Options& options);
int run_check(const Options& options);
int run_compare(const Options& options);
int run_explain(const Options& options);
int run_audit(const Options& options);
int run_calc(const Options& options);
int run_formulas(const Options& options);
/// reference and schema.
int run_reference(const Options& options);
int run_new(const Options& options);
/// catalogue list, show, lint, diff.
int run_catalogue(const Options& options);
int run_import(const Options& options);

}  // namespace millwright::app
