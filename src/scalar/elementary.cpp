// SPDX-License-Identifier: Apache-2.0
#include "scalar/elementary.h"

namespace millwright::scalar {

double power_of(double x, double exponent) { return std::pow(x, exponent); }

}  // namespace millwright::scalar
