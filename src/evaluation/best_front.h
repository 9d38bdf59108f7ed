// SPDX-License-Identifier: Apache-2.0
//
// The front of builds in several objectives, and what is made of it where time is too short for the whole.
#pragma once

#include "evaluation/search_options.h"

namespace millwright::evaluation {

/// The front by the objectives of the options. One that is not done when most of a limited time is used up is covered
/// as far as the rest of it allows, and one that was stopped but may go on (SearchOptions::resume) too; its status is a
/// limit, and Summary::front_tolerance tells to what it is proved.
solver::Summary best_front(const MachineModel& model, const SearchOptions& options);

}  // namespace millwright::evaluation
