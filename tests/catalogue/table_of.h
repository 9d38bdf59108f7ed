// SPDX-License-Identifier: Apache-2.0
//
// A catalogue file written in a test, read as its family.
#pragma once

#include <string>

#include "catalogue/read_table.h"
#include "catch.h"

namespace millwright {

/// The rows of `text`, which reads without an error.
inline catalogue::Table table_of(catalogue::Family family, const std::string& text) {
  text::Diagnostics diagnostics;
  catalogue::Table table = catalogue::read_table(text::SourceText::from_string("x.csv", text), family, 0, diagnostics);
  INFO(text::format(diagnostics));
  REQUIRE_FALSE(diagnostics.has_errors());
  return table;
}

}  // namespace millwright
