// SPDX-License-Identifier: Apache-2.0
// The builds that come next after the best one: what they cost and weigh more, and in what they differ from it.
#pragma once

#include <string>

#include "report/json_value.h"
#include "report/page_texts.h"
#include "report/result.h"
#include "report/text_table.h"

namespace millwright::report {

/// One line a build; empty if none was asked for.
std::string alternatives_text(const MachineResult& result, const Style& style);

/// What of it is proved, for the certificate; empty if none was asked for.
std::string alternatives_certificate(const MachineResult& result, const Texts& t);

/// `alternatives` of a result: the builds after the best one in full; nothing is added if none was asked for.
void add_alternatives(const MachineResult& result, Json& json);

}  // namespace millwright::report
