// SPDX-License-Identifier: Apache-2.0
#include "app/commands.h"
#include "app/output.h"
#include "report/problem_reference.h"

namespace millwright::app {

int run_reference(const Options& options) {
  const std::string text = options.verb == Verb::schema ? report::problem_schema() : report::problem_reference();
  return deliver(options, text, "") ? exit_done : exit_bad_input;
}

}  // namespace millwright::app
