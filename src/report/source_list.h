// SPDX-License-Identifier: Apache-2.0
// The sources that formulas and defaults name by a key: mechanics/sources.bib, built into the program.
#pragma once

#include <string>
#include <string_view>

namespace millwright::report {

/// "Khurmi, R. S.; Gupta, J. K.: A Textbook of Machine Design, Eurasia, 2005"; empty if there is no such key.
std::string citation(std::string_view key);

}  // namespace millwright::report
