// SPDX-License-Identifier: Apache-2.0
#include "machine/steering.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "machine/option_word.h"
#include "machine/quantity_reader.h"
#include "text/nearest.h"

namespace millwright::machine {

using text::Diagnostics;

namespace {

constexpr const char* fix_example = "--fix x.motor=17HS4401S or --fix x.acceleration_time='0.2 s'";

bool contains(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// The maker of all these parts; empty if they have several.
std::string maker_of(const catalogue::Catalogue& catalogue, const std::vector<catalogue::Part>& parts) {
  std::string maker;
  for (const catalogue::Part& part : parts) {
    const std::string name(catalogue.table(part.family).manufacturer(part.row));
    if (!maker.empty() && name != maker) return {};
    maker = name;
  }
  return maker;
}

std::string number_of(const catalogue::Catalogue& catalogue, const catalogue::Part& part) {
  return std::string(catalogue.table(part.family).part_number(part.row));
}

/// What excludes a part; null: nothing does.
const ExcludedPart* excluding(const std::vector<ExcludedPart>& without,
                              const std::string& part,
                              const std::string& maker) {
  const auto found = std::find_if(without.begin(), without.end(), [&](const ExcludedPart& each) {
    return each.part_number == part && (maker.empty() || each.manufacturer.empty() || each.manufacturer == maker);
  });
  return found == without.end() ? nullptr : &*found;
}
bool is_excluded(const std::vector<ExcludedPart>& without, const std::string& part, const std::string& maker) {
  return excluding(without, part, maker) != nullptr;
}
std::string told_why(const std::string& part, const ExcludedPart& excluded) {
  return excluded.said_in.empty()
             ? fmt::format("{} is excluded by --without", text::in_quotes(part))
             : fmt::format("{} is not available, as {} says", text::in_quotes(part), excluded.said_in);
}

/// The reduction that an axis states by this name, with or without the maker that bills of material give it.
const Reduction* stated_reduction(const Axis& axis, const std::string& name) {
  for (const Reduction& each : axis.mechanism.reductions)
    if (!each.name.empty() && (name == each.name || name == "generic " + each.name)) return &each;
  return nullptr;
}

/// The axis that states a reduction of this name; null if none does.
const Axis* axis_with_reduction(const Problem& problem, const std::string& name) {
  for (const Axis& axis : problem.axes)
    if (stated_reduction(axis, name) != nullptr) return &axis;
  return nullptr;
}

class FixedReader {
 public:
  FixedReader(const Problem& problem,
              const catalogue::Catalogue& catalogue,
              const std::vector<ExcludedPart>& without,
              Diagnostics& diagnostics)
      : problem_(problem), catalogue_(catalogue), without_(without), diagnostics_(diagnostics) {}

  BillOfMaterials read(const std::vector<std::string>& words) {
    for (const std::string& word : words) read_one(word);
    return std::move(result_);
  }

 private:
  void read_one(const std::string& text) {
    const auto word = read_option_word("--fix", text, fix_example, diagnostics_);
    if (!word) return;
    const std::size_t dot = word->name.find('.');
    if (dot == std::string::npos) {
      diagnostics_.error(word->name_span(),
                         fmt::format("{} names no slot of an axis", text::in_quotes(word->name)),
                         fmt::format("write {}", fix_example));
      return;
    }
    BomLine line;
    line.axis = word->name.substr(0, dot);
    line.slot = word->name.substr(dot + 1);
    line.where = word->value_span();
    std::vector<std::string> slots{"supply"};
    std::vector<std::string> settings{"supply_voltage"};
    if (!find_slots(*word, line.axis, slots, settings)) return;
    const bool setting = contains(settings, line.slot);
    if (!setting && !contains(slots, line.slot)) {
      slots.insert(slots.end(), settings.begin(), settings.end());
      diagnostics_.error(text::span_at(word->text, word->name_at + dot + 1, std::max<std::size_t>(line.slot.size(), 1)),
                         fmt::format("axis '{}' has no {}", line.axis, text::in_quotes(line.slot)),
                         text::did_you_mean(line.slot, slots, fmt::format("slots: {}", fmt::join(slots, ", "))));
      return;
    }
    if (setting ? read_value(*word, line) : read_part(*word, line)) keep(*word, std::move(line));
  }

  bool find_slots(const OptionWord& word,
                  const std::string& name,
                  std::vector<std::string>& slots,
                  std::vector<std::string>& settings) {
    if (name == "machine") return true;
    std::vector<std::string> names{"machine"};
    for (const Axis& axis : problem_.axes) {
      names.push_back(axis.name);
      if (axis.name != name) continue;
      slots = slot_names(axis);
      settings = setting_names(axis);
      return true;
    }
    diagnostics_.error(text::span_at(word.text, word.name_at, std::max<std::size_t>(name.size(), 1)),
                       fmt::format("the problem has no axis {}", text::in_quotes(name)),
                       text::did_you_mean(name, names, fmt::format("axes: {}", fmt::join(names, ", "))));
    return false;
  }

  bool read_value(const OptionWord& word, BomLine& line) {
    const std::string_view unit = unit_of_setting(line.slot);
    QuantityFault fault;
    line.value = read_quantity(word.value, unit, Sign::positive, fault);
    if (line.value) return true;
    if (fault.hint.starts_with("write for example"))
      fault.hint = fmt::format(
          "write for example --fix {}='{}'", word.name, unit == "mm" ? "12 mm" : usual_values(unit).example);
    diagnostics_.error(
        word.value_span(fault.offset, fault.length), fmt::format("{}: {}", word.name, fault.message), fault.hint);
    return false;
  }

  /// A reduction is of the problem, everything else of the catalogues.
  bool read_part(const OptionWord& word, BomLine& line) {
    line.part_number = word.value;
    if (line.slot == "reduction") {
      for (const Axis& axis : problem_.axes)
        if (const Reduction* stated = axis.name == line.axis ? stated_reduction(axis, word.value) : nullptr)
          line.part_number = stated->name;
      return true;
    }
    const catalogue::FoundParts found = catalogue_.find_named(word.value);
    if (found.parts.empty()) {
      diagnostics_.error(word.value_span(), fmt::format("{}: {}", word.name, found.error), found.hint);
      return false;
    }
    line.part_number = number_of(catalogue_, found.parts.front());
    line.manufacturer = maker_of(catalogue_, found.parts);
    if (line.manufacturer.empty()) {
      diagnostics_.error(word.value_span(),
                         fmt::format("{}: several makers have a part {}", word.name, text::in_quotes(word.value)),
                         "write the maker before it, with a blank between");
      return false;
    }
    const ExcludedPart* const excluded = excluding(without_, line.part_number, line.manufacturer);
    if (excluded == nullptr) return true;
    diagnostics_.error(word.value_span(),
                       fmt::format("{}: {}", word.name, told_why(word.value, *excluded)),
                       excluded->said_in.empty() ? "leave one of the two options out" : "fix another part");
    return false;
  }

  void keep(const OptionWord& word, BomLine line) {
    const auto same = std::find_if(result_.lines.begin(), result_.lines.end(), [&](const BomLine& other) {
      return other.axis == line.axis && other.slot == line.slot;
    });
    if (same == result_.lines.end()) {
      result_.lines.push_back(std::move(line));
      return;
    }
    const bool equal = line.value ? std::abs(*same->value - *line.value) <= 1e-12 * *line.value
                                  : same->part_number == line.part_number && same->manufacturer == line.manufacturer;
    if (equal) return;
    text::Diagnostic twice;
    twice.where = line.where;
    twice.message = fmt::format("{} is fixed twice, and differently", word.name);
    twice.hint = "leave one out";
    twice.related = same->where;
    twice.related_message = "first fixed here";
    diagnostics_.add(std::move(twice));
  }

  const Problem& problem_;
  const catalogue::Catalogue& catalogue_;
  const std::vector<ExcludedPart>& without_;
  Diagnostics& diagnostics_;
  BillOfMaterials result_;
};

}  // namespace

std::vector<ExcludedPart> read_excluded(const std::vector<std::string>& words,
                                        const Problem& problem,
                                        const catalogue::Catalogue& catalogue,
                                        Diagnostics& diagnostics) {
  std::vector<ExcludedPart> result;
  for (const std::string& text : words) {
    const OptionWord word = plain_option_word("--without", text);
    if (word.value.empty()) {
      diagnostics.error(word.value_span(), "no part is named", "write for example --without 17HS4401S");
      continue;
    }
    catalogue::FoundParts found = catalogue.find_named(word.value);
    if (const Axis* axis = found.parts.empty() ? axis_with_reduction(problem, word.value) : nullptr) {
      diagnostics.error(
          word.value_span(),
          fmt::format("{} is stated by the problem, and is no part of the catalogues", text::in_quotes(word.value)),
          fmt::format("leave it out there, or choose another one with --fix {}.reduction=...", axis->name));
      continue;
    }
    if (found.parts.empty()) {
      diagnostics.error(word.value_span(), found.error, found.hint);
      continue;
    }
    if (found.parts.front().family == catalogue::Family::materials) {
      diagnostics.error(
          word.value_span(),
          fmt::format("{} is a material, and those are chosen by the problem", text::in_quotes(word.value)),
          "name another one there, or with --set");
      continue;
    }
    ExcludedPart part{
        maker_of(catalogue, found.parts), number_of(catalogue, found.parts.front()), std::move(found.parts)};
    if (!is_excluded(result, part.part_number, part.manufacturer)) result.push_back(std::move(part));
  }
  return result;
}

void exclude_unavailable(const catalogue::Catalogue& catalogue, std::vector<ExcludedPart>& without) {
  for (const catalogue::FamilyDeclaration& family : catalogue::families) {
    if (!family.priced() || family.family == catalogue::Family::materials) continue;
    const catalogue::Table& table = catalogue.table(family.family);
    const catalogue::Column availability = catalogue::column(family.family, "availability");
    for (int row = 0; row < table.rows(); ++row) {
      const std::string_view maker = table.manufacturer(row), number = table.part_number(row);
      const catalogue::StockMark* mark = catalogue.stock().find(family.family, maker, number);
      const bool said_by_row = table.text(availability, row) == catalogue::unavailable;
      if (mark != nullptr ? mark->available : !said_by_row) continue;
      if (is_excluded(without, std::string(number), std::string(maker))) continue;
      const text::SourceSpan where = mark != nullptr ? mark->where : table.where(row, availability);
      without.push_back({std::string(maker),
                         std::string(number),
                         {{family.family, row}},
                         fmt::format("{}:{}", where.text ? where.text->path() : "", where.line)});
    }
  }
}

BillOfMaterials read_fixed(const std::vector<std::string>& words,
                           const Problem& problem,
                           const catalogue::Catalogue& catalogue,
                           const std::vector<ExcludedPart>& without,
                           Diagnostics& diagnostics) {
  return FixedReader(problem, catalogue, without, diagnostics).read(words);
}

void refuse_excluded(const BillOfMaterials& bom, const std::vector<ExcludedPart>& without, Diagnostics& diagnostics) {
  for (const BomLine& line : bom.lines) {
    if (line.is_dimension()) continue;
    const ExcludedPart* const excluded = excluding(without, line.part_number, line.manufacturer);
    if (excluded == nullptr) continue;
    diagnostics.error(line.where,
                      told_why(line.part_number, *excluded),
                      excluded->said_in.empty() ? "leave the option out, or name another part"
                                                : "name another part, or leave that mark out");
  }
}

}  // namespace millwright::machine
