// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "app/help.h"
#include "app/lock.h"
#include "app/output.h"
#include "catalogue/difference.h"
#include "catalogue/figures.h"
#include "scalar/unit.h"
#include "text/document.h"

namespace millwright::app {

namespace {

using report::Lock;
using report::LockedFile;
using report::LockedInput;
using report::LockedPart;
using text::Diagnostics;

constexpr const char* how_to_accept = "if the change is meant, write the lock again with --write-lock";

std::string shortened(const std::string& sha256) { return sha256.substr(0, 12) + "..."; }

std::string list_of(const std::vector<std::string>& texts) {
  return texts.empty() ? "nothing" : text::printable(fmt::format("{}", fmt::join(texts, ", ")));
}

void report_figure(const text::SourceSpan& where,
                   const std::string& message,
                   const text::SourceSpan* now,
                   Diagnostics& diagnostics) {
  text::Diagnostic diagnostic;
  diagnostic.where = where;
  diagnostic.message = message;
  if (now != nullptr) {
    diagnostic.related = *now;
    diagnostic.related_message = "what it is now";
  }
  diagnostics.add(std::move(diagnostic));
}

void compare_figures(const LockedPart& part,
                     const std::vector<catalogue::NamedFigure>& now,
                     const text::SourceSpan& row,
                     Diagnostics& diagnostics) {
  const std::string who = text::printable(fmt::format("{} ({})", part.title, fmt::join(part.slots, ", ")));
  std::map<std::string, const catalogue::NamedFigure*> unseen;
  for (const catalogue::NamedFigure& figure : now) unseen.emplace(figure.name, &figure);
  for (const report::LockedFigure& then : part.figures) {
    const auto found = unseen.find(then.name);
    if (found == unseen.end()) {
      report_figure(
          then.where,
          fmt::format(
              "{}: {} was {}, and is no longer given", who, text::printable(then.name), text::printable(then.value)),
          &row,
          diagnostics);
      continue;
    }
    const catalogue::NamedFigure& figure = *found->second;
    const std::string value = report::lock_text(figure.value);
    if (!catalogue::same_figure(then.value, value))
      report_figure(then.where,
                    fmt::format("{}: {} was {}, is {}{}",
                                who,
                                figure.name,
                                text::printable(then.value),
                                text::printable(value),
                                catalogue::relative_note(then.value, value)),
                    &figure.where,
                    diagnostics);
    unseen.erase(found);
  }
  for (const auto& [name, figure] : unseen)
    report_figure(part.where,
                  fmt::format("{}: {} was not given, is {}", who, name, text::printable(figure->value)),
                  &figure->where,
                  diagnostics);
}

void verify_part(const LockedPart& part, const catalogue::Catalogue& parts, Diagnostics& diagnostics) {
  const catalogue::Table& table = parts.table(*catalogue::find_family(part.family));
  for (const int each : table.find(part.part_number, part.manufacturer).rows) {
    if (report::lock_text(catalogue::part_title(table, each)) != part.title) continue;
    const auto rows = catalogue::rows_of_part(
        table, table.manufacturer(each), table.part_number(each), catalogue::part_title(table, each));
    if (!rows.empty()) {
      compare_figures(part, catalogue::figures_of(table, rows), table.where(rows.front()), diagnostics);
      return;
    }
  }
  diagnostics.error(
      part.where,
      text::printable(fmt::format("{} ({}) is no longer in the catalogues", part.title, fmt::join(part.slots, ", "))));
}

/// Curves that a motor of the lock did not have count as figures too.
void find_new_curves(const Lock& lock, const catalogue::Catalogue& parts, Diagnostics& diagnostics) {
  const catalogue::Table& curves = parts.table(catalogue::Family::stepper_curves);
  std::set<std::string> known;
  for (const LockedPart& part : lock.parts) known.insert(part.family + "\n" + part.title);
  for (const LockedPart& part : lock.parts) {
    if (part.family != "steppers") continue;
    for (const int row : curves.find(part.part_number, part.manufacturer).rows) {
      const std::string title = report::lock_text(catalogue::part_title(curves, row));
      if (!known.insert("stepper_curves\n" + title).second) continue;
      const text::SourceSpan now = curves.where(row);
      report_figure(part.where, text::printable(title) + ": this torque curve is new", &now, diagnostics);
    }
  }
}

using FileKey = std::tuple<int, std::string, std::string>;  // layer, name, family

void verify_files(const Lock& lock, const catalogue::Inventory& inventory, bool same_parts, Diagnostics& diagnostics) {
  std::map<FileKey, const catalogue::FileRecord*> unseen;
  for (const catalogue::FileRecord& file : inventory.files)
    unseen.emplace(FileKey{file.layer, report::lock_text(file.name), catalogue::declaration(file.family).name}, &file);
  for (const LockedFile& file : lock.files) {
    const std::string name =
        text::printable(file_in_place(lock.places[static_cast<std::size_t>(file.layer)], file.name));
    const auto found = unseen.find(FileKey{file.layer, file.name, file.family});
    if (found == unseen.end()) {
      const bool whole_layer = static_cast<std::size_t>(file.layer) >= inventory.layers.size();
      diagnostics.error(
          file.where, name + " is missing", whole_layer ? "its catalogue is not given: --catalogue" : how_to_accept);
      continue;
    }
    if (found->second->sha256 != file.sha256)
      diagnostics.error(
          file.where,
          fmt::format(
              "{} changed: SHA-256 {} is now {}", name, shortened(file.sha256), shortened(found->second->sha256)),
          same_parts ? std::string("no figure of a part of the locked build changed; ") + how_to_accept
                     : how_to_accept);
    unseen.erase(found);
  }
  for (const auto& [key, file] : unseen)
    diagnostics.error(text::whole(lock.source),
                      fmt::format("{} is new: the lock does not know it",
                                  text::printable(file_in_place(
                                      inventory.layers[static_cast<std::size_t>(file->layer)].place, file->name))),
                      how_to_accept);
}

void report_changed(const LockedInput& then, const LockedInput& now, Diagnostics& diagnostics) {
  if (then.sha256 == now.sha256) return;
  diagnostics.error(then.where,
                    fmt::format("the {} {} changed: SHA-256 {} is now {}",
                                then.kind,
                                text::printable(now.file),
                                shortened(then.sha256),
                                shortened(now.sha256)),
                    how_to_accept);
}

/// A bill of materials counts where both have one: what `solve` locked, `check` may look at.
void verify_inputs(const Lock& lock, const std::vector<LockedInput>& inputs, Diagnostics& diagnostics) {
  const auto of_kind = [](const std::vector<LockedInput>& list, const std::string& kind) {
    std::vector<const LockedInput*> found;
    for (const LockedInput& each : list)
      if (each.kind == kind) found.push_back(&each);
    return found;
  };
  for (const char* kind : {"problem", "bill of materials", "stock", "suppliers", "offers"}) {
    const auto then = of_kind(lock.inputs, kind), now = of_kind(inputs, kind);
    for (std::size_t i = 0; i < std::min(then.size(), now.size()); ++i) report_changed(*then[i], *now[i], diagnostics);
  }
  for (const char* kind : {"stock", "suppliers", "offers"}) {
    const auto then = of_kind(lock.inputs, kind), now = of_kind(inputs, kind);
    if (then.size() < now.size())
      diagnostics.error(text::whole(lock.source),
                        fmt::format("{} is new: the lock does not know it", text::printable(now.back()->file)),
                        how_to_accept);
    else if (then.size() > now.size())
      diagnostics.error(
          then.back()->where, fmt::format("{} is missing", text::printable(then.back()->file)), how_to_accept);
  }
  const auto profiles = of_kind(inputs, "profile");
  for (const LockedInput* then : of_kind(lock.inputs, "profile"))
    for (const LockedInput* now : profiles)
      if (now->file == then->file) report_changed(*then, *now, diagnostics);
}

void compare_question(const Lock& lock, const report::LockedQuestion& now, Diagnostics& diagnostics) {
  const report::LockedQuestion& then = lock.question;
  const text::SourceSpan where = text::whole(lock.source);
  const auto compare = [&](const char* option, const auto& old_texts, const auto& new_texts) {
    if (old_texts != new_texts)
      diagnostics.warning(
          where,
          fmt::format(
              "{} asked for {} when the lock was written, now for {}", option, list_of(old_texts), list_of(new_texts)));
  };
  compare("--set", then.settings, now.settings);
  compare("--limit", then.limits, now.limits);
  compare("--without", then.without, now.without);
  compare("--fix", then.fixed, now.fixed);
  if (then.command == now.command) compare("--minimise", then.objectives, now.objectives);
  if (lock.version != version)
    diagnostics.warning(where,
                        fmt::format("the lock was written by millwright {}, this is {}: from the same files another "
                                    "build may follow",
                                    text::printable(lock.version),
                                    version));
}

/// The part of each slot.
std::map<std::string, std::string> slots_of(const std::vector<LockedPart>& parts) {
  std::map<std::string, std::string> slots;
  for (const LockedPart& part : parts)
    if (part.family != "stepper_curves")
      for (const std::string& slot : part.slots) slots[slot] += (slots[slot].empty() ? "" : ", ") + part.title;
  return slots;
}

}  // namespace

std::optional<Lock> verify_lock(const Options& options,
                                const MachineInput& input,
                                Diagnostics& diagnostics,
                                const BomTexts& boms) {
  if (options.locked.empty()) return std::nullopt;
  const auto text = text::SourceText::load(options.locked, diagnostics, text::document_size_limit);
  auto lock = text ? report::read_lock(text, diagnostics) : std::nullopt;
  if (!lock) return std::nullopt;
  compare_question(*lock, question_of(options), diagnostics);
  verify_inputs(*lock, locked_inputs(input, boms), diagnostics);
  const catalogue::Catalogue& parts = input.whole_catalogue ? *input.whole_catalogue : input.catalogue;
  const std::size_t errors = diagnostics.error_count();
  for (const LockedPart& part : lock->parts) verify_part(part, parts, diagnostics);
  find_new_curves(*lock, parts, diagnostics);
  verify_files(*lock, inventory_of(input), diagnostics.error_count() == errors, diagnostics);
  return lock;
}

void compare_with_lock(const Lock& lock, const MachineInput& input, const evaluation::Design& design) {
  if (lock.cost.empty()) return;  // of no build, or of several
  Diagnostics diagnostics;
  const text::SourceSpan where = text::whole(lock.source);
  const auto then = slots_of(lock.parts), now = slots_of(locked_parts(input, {&design}));
  std::string changes;
  const auto add = [&](const std::string& slot, const std::string& before, const std::string& after) {
    changes += (changes.empty() ? "" : "; ") + fmt::format("{} was {}, is {}", slot, before, after);
  };
  for (const auto& [slot, part] : then) {
    const auto found = now.find(slot);
    if (found == now.end())
      add(slot, part, "nothing");
    else if (found->second != part)
      add(slot, part, found->second);
  }
  for (const auto& [slot, part] : now)
    if (then.count(slot) == 0) add(slot, "nothing", part);
  const auto add_total = [&](const char* name, const std::string& before, double value, const std::string& unit) {
    constexpr int digits = 7;  // as many as a search decides
    const std::string after = scalar::format_number(value, digits) + " " + unit;
    const std::size_t blank = std::min(before.find(' '), before.size());
    std::string reason;
    const auto number = scalar::parse_number(before.substr(0, blank), reason);
    if (number && scalar::format_number(*number, digits) + before.substr(blank) != after) add(name, before, after);
  };
  add_total("cost", lock.cost, design.cost, design.currency);
  add_total("mass", lock.mass, design.mass, "kg");
  if (!changes.empty())
    diagnostics.warning(where, "the build is not the locked one: " + text::printable(changes, 1000));
  print(diagnostics);
}

}  // namespace millwright::app
