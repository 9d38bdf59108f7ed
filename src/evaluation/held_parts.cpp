// SPDX-License-Identifier: Apache-2.0
#include "evaluation/held_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "evaluation/belt_drive_stage.h"
#include "evaluation/drive_tables.h"

namespace millwright::evaluation {

namespace {

using machine::BomLine;

/// The problem itself states what this slot takes.
bool is_stated(const SlotTable& table) {
  return table.rows() > 0 && !table.candidate(0).parts.empty() && !table.candidate(0).parts.front().stated.empty();
}

bool is_given(const catalogue::Catalogue& catalogue, const PartUse& use, const BomLine& line) {
  if (!use.stated.empty())
    return use.stated == line.part_number && (line.manufacturer.empty() || line.manufacturer == "generic");
  return is_part(catalogue.table(use.family), use.row, {line.manufacturer, line.part_number});
}

class Holder {
 public:
  Holder(const MachineModel& model,
         const machine::BillOfMaterials& bom,
         const std::string& only_origin,
         bool wishes_count)
      : bom_(bom), only_origin_(only_origin), model_(model), wishes_count_(wishes_count) {
    for (const BomLine& line : bom.lines)
      if (only_origin.empty() || line.origin == only_origin) lines_.push_back(&line);
  }

  HeldParts hold() {
    for (const StageEntry& entry : model_.entries()) hold_stage(entry);
    hold_voltage();
    return std::move(result_);
  }

 private:
  const BomLine* line_for(std::string_view axis, std::string_view slot) const {
    for (const BomLine* line : lines_)
      if (line->axis == axis && line->slot == slot) return line;
    return nullptr;
  }

  void hold_stage(const StageEntry& entry) {
    HeldStage held;
    for (const SlotTable& table : entry.tables()) hold_slot(entry, table, held);
    const bool has_belt = std::holds_alternative<std::unique_ptr<BeltDriveStage>>(entry.stage);
    const bool apart = has_belt && !keep_what_runs_together(entry, held);
    for (std::size_t slot = 0; slot < held.allowed.size(); ++slot) {
      if (held.allowed[slot].empty() || (apart && slot <= BeltDriveStage::idler_slot)) continue;
      // A belt is as long as the smallest pulleys that are left make it.
      const auto length = [&](solver::Row row) {
        const std::span<const PartUse> parts = entry.tables()[slot].candidate(row).parts;
        return parts.empty() ? 0.0 : parts.front().length;
      };
      report_too_little(entry,
                        entry.tables()[slot].candidate(*std::min_element(
                            held.allowed[slot].begin(), held.allowed[slot].end(), [&](solver::Row a, solver::Row b) {
                              return length(a) < length(b);
                            })));
      remark_too_much(entry, entry.tables()[slot], held.allowed[slot]);
    }
    const auto variables = entry.as_stage().variables();
    for (const solver::Variable& variable : variables) {
      const std::string name = entry.element == "drive" ? variable.name : entry.element + "." + variable.name;
      const BomLine* line = line_for(entry.axis, name);
      held.variables.push_back(line != nullptr ? line->value : std::nullopt);
    }
    result_.stages.push_back(std::move(held));
  }

  void hold_slot(const StageEntry& entry, const SlotTable& table, HeldStage& held) {
    std::vector<const BomLine*> given;
    bool all = true;
    for (const std::string& slot : slots_of(table)) {
      given.push_back(line_for(entry.axis, slot));
      all = all && given.back() != nullptr;
    }
    std::vector<solver::Row> rows;
    for (solver::Row row = 0; row < table.rows(); ++row) {
      const auto& parts = table.candidate(row).parts;
      bool matches = true;
      for (std::size_t i = 0; i < parts.size() && matches; ++i) {
        // A pulley that brings its second piece along fills a line of another slot too.
        const BomLine* line = i < given.size() ? given[i] : line_for(entry.axis, parts[i].slot);
        matches = line == nullptr || is_given(model_.catalogue(), parts[i], *line);
      }
      if (matches) rows.push_back(row);
    }
    if (rows.empty()) report_no_candidate(entry, table, given);
    // The only one that the problem states needs no line.
    const bool only = table.rows() == 1 && is_stated(table);
    held.allowed.push_back(std::move(rows));
    held.named.push_back(all || only);
  }

  /// A belt that does not run on its pulleys is no machine to judge; of the rows that stand for one part those stay
  /// that go with the rest. False where something was reported.
  bool keep_what_runs_together(const StageEntry& entry, HeldStage& held) {
    using Drive = BeltDriveStage;
    constexpr std::array slots{Drive::belt_slot, Drive::pulley_slot, Drive::idler_slot};
    std::vector<const BomLine*> given;
    bool reported = false;
    for (const std::size_t slot : slots) {
      const BomLine* const line = line_for(entry.axis, entry.tables()[slot].name());
      if (line != nullptr) given.push_back(line);
      reported = reported || held.allowed[slot].empty();
    }
    for (const BomLine* line : given) {
      // The idler's slot has a candidate whatever is said of it.
      if (line->slot != entry.tables()[Drive::idler_slot].name() || can_be(entry, *line)) continue;
      report_lines(entry, {line});
      reported = true;
    }
    if (given.empty() || reported) return !reported;
    const solver::Stage& stage = entry.as_stage();
    for (bool fewer = true; fewer;) {
      fewer = false;
      for (const std::size_t slot : slots)
        for (const std::size_t other : slots) {
          if (slot == other) continue;
          const std::vector<solver::Row>& partners = held.allowed[other];
          fewer = std::erase_if(held.allowed[slot],
                                [&](solver::Row row) {
                                  return std::none_of(partners.begin(), partners.end(), [&](solver::Row partner) {
                                    return stage.fits({}, slot, row, other, partner);
                                  });
                                }) > 0 ||
                  fewer;
        }
    }
    if (!held.allowed.front().empty()) return true;
    report_apart(
        entry,
        given,
        "belt and pulleys need one profile and one width; at the far end turns an idler, or the drive pulley's like");
    return false;
  }

  /// Each of the lines could be, but not together.
  void report_apart(const StageEntry& entry, const std::vector<const BomLine*>& given, const char* hint) {
    std::vector<std::string> parts;
    for (const BomLine* line : given) parts.push_back(fmt::format("'{}' as {}", line->part_number, line->slot));
    result_.problems.push_back(
        {given.back()->where,
         fmt::format("{} of axis '{}': they do not run together", fmt::join(parts, ", "), entry.axis),
         hint});
  }

  /// Fewer or shorter pieces than the axis needs would be another machine than the one that is checked.
  void report_too_little(const StageEntry& entry, const Candidate& candidate) {
    for (const PartUse& part : candidate.parts) {
      const BomLine* const given = line_for(entry.axis, part.slot);
      if (given == nullptr) continue;
      const BomLine& line = *given;
      if (line.quantity && *line.quantity < part.quantity * (1.0 - 1e-9))
        result_.problems.push_back(
            {line.where,
             fmt::format("{} of '{}', and the {} of axis '{}' takes {}",
                         *line.quantity,
                         line.part_number,
                         line.slot,
                         entry.axis,
                         part.quantity),
             "order as many as the problem file has of it (carriages, drives, members), or change the problem"});
      if (line.length && part.length <= 0.0)
        result_.problems.push_back(
            {line.where,
             fmt::format(
                 "'{}' has a length, and the {} of axis '{}' is not cut", line.part_number, line.slot, entry.axis),
             "leave the column length empty"});
      else if (line.length && *line.length < part.length * (1.0 - 1e-6))  // a bill has 7 digits
        result_.problems.push_back({line.where,
                                    fmt::format("'{}' is cut to {:.6g} mm, and the {} of axis '{}' needs {:.6g} mm",
                                                line.part_number,
                                                1e3 * *line.length,
                                                line.slot,
                                                entry.axis,
                                                1e3 * part.length),
                                    "leave the length away to have it computed"});
    }
  }

  /// More or longer pieces than any of these rows takes.
  void remark_too_much(const StageEntry& entry, const SlotTable& table, const std::vector<solver::Row>& rows) {
    for (const std::string& slot : slots_of(table)) {
      const BomLine* const line = line_for(entry.axis, slot);
      if (line == nullptr) continue;
      double pieces = 0.0, length = 0.0;
      for (const solver::Row row : rows)
        for (const PartUse& part : table.candidate(row).parts) {
          if (part.slot != slot) continue;
          pieces = std::max(pieces, part.pieces());
          length = std::max(length, part.length);
        }
      const auto remark = [&](std::string what, std::string takes) {
        result_.remarks.push_back(
            {line->where,
             fmt::format(
                 "{}, and the {} of axis '{}' takes {}: no more is priced and weighed", what, slot, entry.axis, takes),
             "what is bought beside the machine's own stands under [spares] of the problem"});
      };
      if (pieces > 0.0 && line->quantity && *line->quantity > pieces * (1.0 + 1e-9))
        remark(fmt::format("{} of '{}'", *line->quantity, line->part_number), fmt::format("{}", pieces));
      if (length > 0.0 && line->length && *line->length > length * (1.0 + 1e-6))
        remark(fmt::format("'{}' is cut to {:.6g} mm", line->part_number, 1e3 * *line->length),
               fmt::format("{:.6g} mm", 1e3 * length));
    }
  }

  void report_no_candidate(const StageEntry& entry, const SlotTable& table, const std::vector<const BomLine*>& given) {
    if (std::all_of(given.begin(), given.end(), [](const BomLine* line) { return line == nullptr; })) {
      if (wishes_count_) return;
      result_.problems.push_back({lines_.empty() ? machine::SourceSpan{} : lines_.back()->where,
                                  fmt::format("no catalogue row can be the {} of axis '{}'", table.name(), entry.axis),
                                  "add a catalogue that has one, or ask less of it"});
      return;
    }
    if (is_stated(table)) {
      std::vector<std::string> names;
      for (solver::Row row = 0; row < table.rows(); ++row)
        names.emplace_back(table.candidate(row).parts.front().stated);
      result_.problems.push_back(
          {given.front()->where,
           fmt::format("axis '{}' states no {} '{}'", entry.axis, table.name(), given.front()->part_number),
           fmt::format("stated: {}", fmt::join(names, ", "))});
      return;
    }
    report_lines(entry, given);
  }

  /// Why these lines, or nothing where a slot has none, give no candidate.
  void report_lines(const StageEntry& entry, const std::vector<const BomLine*>& given) {
    for (const BomLine* line : given) {
      if (line == nullptr) continue;
      const catalogue::FoundParts found = model_.catalogue().find(line->part_number, line->manufacturer);
      if (found.parts.empty()) {
        result_.problems.push_back(
            {line->where,
             found.error.empty() ? fmt::format("no part '{}' in the catalogues", line->part_number) : found.error,
             found.hint});
        return;
      }
    }
    bool said = false;
    for (const BomLine* line : given) {
      if (line == nullptr || can_be(entry, *line)) continue;
      report_unfit(entry, *line);
      said = true;
    }
    if (said) return;
    std::vector<const BomLine*> lines = given;
    std::erase(lines, nullptr);
    if (lines.size() == 1)
      report_unfit(entry, *lines.front());
    else
      report_apart(entry, lines, "each can be had with another one: leave one of them open");
  }

  /// Whether some candidate has this part, whatever its other parts are.
  bool can_be(const StageEntry& entry, const BomLine& line) const {
    for (const SlotTable& table : entry.tables())
      for (solver::Row row = 0; row < table.rows(); ++row)
        for (const PartUse& part : table.candidate(row).parts)
          if (part.slot == line.slot && is_given(model_.catalogue(), part, line)) return true;
    return false;
  }

  void report_unfit(const StageEntry& entry, const BomLine& line) {
    result_.problems.push_back(
        {line.where,
         fmt::format("'{}' cannot be the {} of axis '{}'", line.part_number, line.slot, entry.axis),
         fmt::format("it belongs to another family, {}lacks a figure that a check needs (see 'catalogue show'), or "
                     "does not go with the other part of its pair",
                     wishes_count_
                         ? "is not of the kinds that the problem asks for (frames, threads, voltages, currents), "
                         : "")});
  }

  void hold_voltage() {
    const auto stated = stated_voltage(bom_, model_.catalogue(), only_origin_);
    if (!stated) return;
    const auto& voltages = model_.machine().supply_voltages;
    for (std::size_t i = 0; i < voltages.size(); ++i)
      if (std::abs(voltages[i] - stated->volts) < 1e-6) result_.voltage = static_cast<solver::Row>(i);
    if (result_.voltage) return;
    result_.problems.push_back(
        {stated->line->where,
         stated->line->slot == "supply"
             ? fmt::format("the supply gives {} V, which is not among the problem's supply voltages", stated->volts)
             : fmt::format("supply voltage {} V is not among those of the problem", stated->volts),
         "add it to [supply] voltage"});
  }

  const machine::BillOfMaterials& bom_;
  const std::string& only_origin_;
  const MachineModel& model_;
  bool wishes_count_;
  std::vector<const BomLine*> lines_;
  HeldParts result_;
};

}  // namespace

std::vector<std::string> slots_of(const SlotTable& table) {
  std::vector<std::string> result;
  if (table.rows() > 0)
    for (const PartUse& part : table.candidate(0).parts) result.emplace_back(part.slot);
  if (!result.empty()) return result;
  if (table.name() == "screw") return {"screw", "nut"};
  if (table.name() == "motor") return {"motor", "driver"};
  return {table.name()};
}

HeldParts hold_parts(const MachineModel& model,
                     const machine::BillOfMaterials& bom,
                     const std::string& only_origin,
                     bool wishes_count) {
  return Holder(model, bom, only_origin, wishes_count).hold();
}

std::optional<StatedVoltage> stated_voltage(const machine::BillOfMaterials& bom,
                                            const catalogue::Catalogue& catalogue,
                                            const std::string& only_origin) {
  const BomLine* supply = nullptr;
  for (const BomLine& line : bom.lines) {
    if (line.axis != "machine" || (!only_origin.empty() && line.origin != only_origin)) continue;
    if (line.slot == "supply_voltage" && line.value) return StatedVoltage{*line.value, &line};
    if (line.slot == "supply" && supply == nullptr) supply = &line;
  }
  if (supply == nullptr) return std::nullopt;
  const catalogue::Table& table = catalogue.table(catalogue::Family::power_supplies);
  const catalogue::Found found = table.find(supply->part_number, supply->manufacturer);
  if (!found || found.rows.empty()) return std::nullopt;
  constexpr catalogue::Column volts = catalogue::column(catalogue::Family::power_supplies, "output_voltage");
  return StatedVoltage{table.number(volts, found.rows.front()), supply};
}

solver::Restriction restriction_of(const MachineModel& model, const HeldParts& held) {
  solver::Restriction result = solver::unrestricted(model.problem());
  for (std::size_t i = 0; i < held.stages.size(); ++i)
    result.stages[i] = {held.stages[i].allowed, held.stages[i].variables};
  return result;
}

}  // namespace millwright::evaluation
