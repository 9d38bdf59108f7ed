// SPDX-License-Identifier: Apache-2.0
// What is written into the program when it is built (page/embed.cmake): style and script of the page, from
// src/report/page/, and the list of sources.
#pragma once

#include <string>

namespace millwright::report {

std::string page_style();
std::string page_script();
/// mechanics/sources.bib.
std::string sources_bib();

}  // namespace millwright::report
