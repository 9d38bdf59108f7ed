// SPDX-License-Identifier: Apache-2.0
#include "machine/screw.h"

namespace millwright::machine {

double end_fixity(Ends ends) {
  switch (ends) {
    case Ends::fixed_free:
      return 0.25;
    case Ends::supported_supported:
      return 1.0;
    case Ends::fixed_supported:
      return 2.0;
    case Ends::fixed_fixed:
      return 4.0;
  }
  return 0.25;
}

double bending_eigenvalue(Ends ends) {
  switch (ends) {
    case Ends::fixed_free:
      return 1.875104069;
    case Ends::supported_supported:
      return 3.141592653589793;
    case Ends::fixed_supported:
      return 3.926602312;
    case Ends::fixed_fixed:
      return 4.730040745;
  }
  return 1.875104069;
}

}  // namespace millwright::machine
