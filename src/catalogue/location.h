// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace millwright::catalogue {

/// Where the shipped catalogues are: environment MILLWRIGHT_CATALOGUES if set; else share/millwright/catalogues beside
/// the folder of the running program (an installation); else a folder `catalogues` that contains `steppers`, in the
/// source tree or above the program. Empty if there is none.
std::filesystem::path shipped_catalogues();

/// The same for a program at `executable`, without the environment.
std::filesystem::path shipped_catalogues(const std::filesystem::path& executable);

}  // namespace millwright::catalogue
