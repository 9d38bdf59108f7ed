// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "app/options.h"
#include "catalogue/catalogue.h"
#include "evaluation/ledger.h"
#include "machine/problem.h"
#include "machine/steering.h"
#include "text/diagnostic.h"
#include "text/document.h"

namespace millwright::app {

/// A problem with the catalogues its parts come from.
struct MachineInput {
  machine::Problem problem;        ///< with the budgets of `--limit`
  catalogue::Catalogue catalogue;  ///< without the parts of `--without`
  machine::Steering steering;
  std::optional<text::Document> document;               ///< from which the problem was read, after `--set`
  std::optional<catalogue::Catalogue> whole_catalogue;  ///< where parts are left out: with them
};

/// Reads the problem, after `--set`, and the catalogues: the shipped ones, those the problem names (relative to its
/// file), those of `--catalogue`; then what the other options ask of both. Everything wrong in all of them is reported;
/// nothing if there was an error.
std::optional<MachineInput> read_machine(const Options& options, text::Diagnostics& diagnostics);

/// The measured motions that a problem file names, as it names them.
std::vector<std::string> profile_names(const text::Document& document);

/// The shipped folder followed by `overlays`; reports if there is none.
std::vector<std::filesystem::path> catalogue_places(const std::vector<std::string>& overlays,
                                                    text::Diagnostics& diagnostics);

/// Names the rows of shipped catalogues by their place in the catalogue folder, "catalogues/steppers/x.csv:14", so that
/// a result does not depend on where the program is installed.
void shorten_places(evaluation::Design& design);

}  // namespace millwright::app
