// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/catalogue.h"

namespace millwright::evaluation {

/// For a catalogue whose figures are not what they are stated as: what is bought is what the stated ones ask for, and
/// no piece may be too long for its bar only because a block is a little longer. Bars get a quarter longer at the same
/// price.
void lengthen_bars(catalogue::Catalogue& parts);

}  // namespace millwright::evaluation
