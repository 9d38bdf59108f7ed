// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "evaluation/ledger.h"
#include "machine/problem.h"
#include "text/diagnostic.h"
#include "text/document.h"

namespace millwright::app {

/// Warns at each limit without a default, and at each check under `enforce`, that the problem states and no check of
/// the build reads: who asks for a frame's natural frequency of an axis that has no frame believes it to be held.
/// `document`: of the problem.
void note_idle_requirements(const machine::Problem& problem,
                            const text::Document& document,
                            const evaluation::Design& design,
                            text::Diagnostics& diagnostics);

}  // namespace millwright::app
