// SPDX-License-Identifier: Apache-2.0
//
// Machines for tests: a shipped problem, or one written in the test.
#pragma once

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

#include "catalogue/catalogue.h"
#include "evaluation/machine_model.h"
#include "machine/problem_file.h"
#include "text/document.h"

namespace millwright {

inline machine::Problem problem_of_text(const std::string& toml) {
  text::Diagnostics diagnostics;
  const auto document = text::read_toml(text::SourceText::from_string("problem.toml", toml), diagnostics);
  auto problem = document ? machine::problem_of(*document, diagnostics) : std::nullopt;
  if (!problem) throw std::runtime_error(text::format(diagnostics));
  return *problem;
}

inline machine::Problem shipped_problem(const std::string& name) {
  text::Diagnostics diagnostics;
  auto problem =
      machine::read_problem(std::string(MILLWRIGHT_SOURCE_DIR) + "/problems/" + name + ".toml", {}, diagnostics);
  if (!problem) throw std::runtime_error(text::format(diagnostics));
  return *problem;
}

inline catalogue::Catalogue catalogue_of(const std::vector<std::filesystem::path>& places) {
  text::Diagnostics diagnostics;
  auto catalogue = catalogue::Catalogue::load(places, diagnostics);
  if (diagnostics.error_count() > 0) throw std::runtime_error(text::format(diagnostics));
  return catalogue;
}

/// The catalogues of the project, read once.
inline const catalogue::Catalogue& shipped_catalogue() {
  static const catalogue::Catalogue catalogue =
      catalogue_of({std::string(MILLWRIGHT_SOURCE_DIR) + "/catalogues",
                    std::string(MILLWRIGHT_SOURCE_DIR) + "/problems/sander-parts"});
  return catalogue;
}

}  // namespace millwright
