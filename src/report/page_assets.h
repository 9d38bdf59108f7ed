// SPDX-License-Identifier: Apache-2.0
// Style and script of the page, from src/report/page/: they are bundled when the program is built (page/build.cmake).
#pragma once

#include <string>

namespace millwright::report {

std::string page_style();
std::string page_script();

}  // namespace millwright::report
