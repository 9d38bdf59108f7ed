// SPDX-License-Identifier: Apache-2.0
// A source line as it is shown under a message: on one screen line, with the caret under the right characters.
#pragma once

#include <string>

#include "text/source_text.h"

namespace millwright::text {

/// The line of a span and the marker that stands under it (`^~~~`), both made of printable characters. Tabs become
/// blanks, unprintable bytes \x00, long lines are cut to a window around the caret with "..." at the cut ends.
struct Excerpt {
  std::string line;
  std::string marker;
};

Excerpt excerpt(const SourceSpan& span);

}  // namespace millwright::text
