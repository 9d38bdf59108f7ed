// SPDX-License-Identifier: Apache-2.0
// A build as it stands in a result that `--json` wrote. Its figures are taken as they were recorded: catalogues and
// problem may have changed since, and what was asked for on the command line then is not known to be asked for now.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/ledger.h"
#include "text/diagnostic.h"
#include "text/source_text.h"

namespace millwright::report {

struct RecordedBuild {
  std::string command;             ///< "solve" or "check"
  std::string title;               ///< of the problem
  std::string problem_file;        ///< as it was named then; may be gone
  std::string bom_file;            ///< of check
  bool proved = true;              ///< not a best build of a search that a limit ended
  std::vector<std::string> asked;  ///< beside the problem, as on a command line: "--set axis.z.stroke=1 m"
  std::vector<std::string> axes;   ///< without "machine"
  evaluation::Design design;
};

/// The text of a result of solve or check. Reported, all at once: what is no JSON (at its place), no result, a result
/// without a build or with several, values that are missing or of another kind (by their path in the file).
std::optional<RecordedBuild> read_recorded_build(const std::shared_ptr<const text::SourceText>& text,
                                                 text::Diagnostics& diagnostics);

}  // namespace millwright::report
