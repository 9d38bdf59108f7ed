// SPDX-License-Identifier: Apache-2.0
// Prints a torque by a formula of the installed package: once from the header, once from the registry in the library.
#include <cstdio>
#include <vector>

#include "mechanics/formula.h"
#include "mechanics/power_screw.h"

int main() {
  const int narrowed = 3.5;  // -Wconversion -Werror would stop here: our warnings must not become the consumer's
  // force 6400 N, mean diameter 30 mm, lead 8 mm, friction 0.08
  const double direct = millwright::mechanics::power_screw::raising_torque(6400.0, 0.030, 0.008, 0.08);
  const auto* formula = millwright::mechanics::find_formula("power_screw.raising_torque");
  const double looked_up = formula->evaluate<double>({6400.0, 0.030, 0.008, 0.08});
  std::printf("%.6f %d %d\n", direct, direct == looked_up, narrowed);
}
