// SPDX-License-Identifier: Apache-2.0
// `--write-lock` records what a result was made from, `--locked` refuses to go on when any of that is not as it was.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/machine_input.h"
#include "app/options.h"
#include "catalogue/inventory.h"
#include "evaluation/ledger.h"
#include "report/lock.h"

namespace millwright::app {

/// Bills of materials that were read beside the problem.
using BomTexts = std::vector<std::shared_ptr<const text::SourceText>>;

/// The files of the catalogues, the shipped ones under the name "catalogues" wherever they are installed.
catalogue::Inventory inventory_of(const MachineInput& input);

/// Whether the result is to tell the files that it rests on: where a program, a page or a lock takes it up.
bool wants_inventory(const Options& options);

/// What the command line asks for.
report::LockedQuestion question_of(const Options& options);

/// The problem, the measured motions that it names, and the bills of materials.
std::vector<report::LockedInput> locked_inputs(const MachineInput& input, const BomTexts& boms);

/// How a file of a catalogue is told: "mine/steppers/x.csv", or the place alone where that is the file.
std::string file_in_place(const std::string& place, const std::string& name);

/// The parts of the designs, each once, with their figures; also the torque curves of their motors.
std::vector<report::LockedPart> locked_parts(const MachineInput& input,
                                             const std::vector<const evaluation::Design*>& designs);

/// Writes the lock that `--write-lock` asks for, if any. False, with a complaint on standard error, if it cannot be
/// written.
bool write_lock(const Options& options,
                const MachineInput& input,
                const std::vector<const evaluation::Design*>& designs,
                const BomTexts& boms = {});

/// Reads the lock of `--locked`, if any, and reports every file and every figure of its parts that is not as it was, as
/// errors; what was asked for then and now, and another version of the program, as warnings.
std::optional<report::Lock> verify_lock(const Options& options,
                                        const MachineInput& input,
                                        text::Diagnostics& diagnostics,
                                        const BomTexts& boms = {});

/// Warns on standard error where the build is not the one of the lock.
void compare_with_lock(const report::Lock& lock, const MachineInput& input, const evaluation::Design& design);

}  // namespace millwright::app
