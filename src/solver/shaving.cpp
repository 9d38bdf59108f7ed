// SPDX-License-Identifier: Apache-2.0
#include "solver/shaving.h"

#include <algorithm>
#include <memory>
#include <optional>

namespace millwright::solver {

bool hopeless(const StagePlan& plan, const Answer<Interval>& answer) {
  return worst_lower(answer.utilisation) > 1.0 || !bearable(plan, answer.handed_on);
}

bool hopeless(const StagePlan& plan, std::span<const Interval> inherited, const Region& region, Desk& desk) {
  return hopeless(plan, desk.bound(*plan.stage, plan.shared, inherited, region));
}

void find_profile(
    const StagePlan& plan, std::span<const Interval> inherited, std::size_t slot, RowProfile& profile, Desk& desk) {
  Bounds bounds;
  read_bounds(plan, desk.bound(*plan.stage, plan.shared, inherited, plan.region), bounds);
  profile.find(
      plan.region, slot, bounds.score, [&](const RowsAlive& rows, std::span<double> score) -> const Answer<Interval>& {
        const auto& answer = desk.bound_with(*plan.stage, plan.shared, inherited, plan.region, slot, rows);
        plan.criteria->least_scores(answer.resources, score);
        return answer;
      });
}

namespace {

/// Whether rows of a slot have partners in all others of the plan's region; rows of one kind are asked about once.
class Partners {
 public:
  Partners(const StagePlan& plan, std::size_t slot) : plan_(plan), slot_(slot) {}

  bool of(Row row, const std::vector<Interval>& readings) {
    if (plan_.fits.everything_fits()) return true;
    const std::uint32_t kind = plan_.fits.kinds(slot_)[row];
    if (kind >= known_.size()) known_.resize(kind + std::size_t{1});
    if (!known_[kind]) {
      Region region = plan_.region;
      region.rows[slot_] = std::make_shared<const Rows>(std::vector<Row>(1, row), readings);
      known_[kind] = plan_.fits.possible(region, slot_);
    }
    return *known_[kind];
  }

 private:
  const StagePlan& plan_;
  std::size_t slot_;
  std::vector<std::optional<bool>> known_;  ///< [kind]
};

/// Removes rows that have no hope at any of the inherited states.
class Shaving {
 public:
  Shaving(StagePlan& plan, std::span<const Interval> inherited, Desk& desk, TableMemory& tables)
      : plan_(plan), inherited_(inherited), desk_(desk), tables_(tables) {}

  /// False: nothing is left.
  bool run() {
    const std::size_t slots = plan_.region.rows.size();
    for (bool again = true; again;) {
      again = false;
      for (std::size_t slot = 0; slot < slots; ++slot) {
        const RowSet all = plan_.region.rows[slot];
        const bool is_long = all->size() >= long_table;
        if (is_long && sample_has_hope(slot, all->all(), long_sample)) continue;
        std::vector<Row> kept = is_long ? sieved(slot) : hopeful_rows(slot);
        if (kept.empty()) return false;
        if (kept.size() == all->size()) continue;
        // Fewer rows here may leave others without hope; a few fewer are not worth asking about all others again.
        again = again || 2 * kept.size() <= all->size();
        plan_.region.rows[slot] = make_rows(*plan_.stage, plan_.shared, slot, std::move(kept));
        if (!plan_.fits.filter(plan_.region, is_long ? slots : slot)) return false;
      }
    }
    return !hopeless(plan_, inherited_, plan_.region, desk_);
  }

 private:
  static constexpr std::size_t long_table = 1024, long_sample = 128;

  const Answer<Interval>& ask(std::size_t slot, const RowsAlive& rows) {
    return desk_.bound_with(*plan_.stage, plan_.shared, inherited_, plan_.region, slot, rows);
  }
  bool hopeless_alone(std::size_t slot, const Row& row) {
    const std::span<const Row> alone(&row, 1);
    plan_.stage->read(plan_.shared, slot, alone, readings_);
    return hopeless(plan_, ask(slot, {alone, readings_}));
  }

  std::vector<Row> hopeful_rows(std::size_t slot) {
    std::vector<Row> kept;
    Partners partners(plan_, slot);
    for (const Row& row : *plan_.region.rows[slot])
      if (!hopeless_alone(slot, row) && partners.of(row, readings_)) kept.push_back(row);
    return kept;
  }

  bool one_has_hope(std::size_t slot, const std::vector<Row>& rows, std::size_t sample) {
    for (std::size_t i = 0; i < sample; ++i)
      if (!hopeless_alone(slot, rows[i * rows.size() / sample])) return true;
    return false;
  }

  /// Rows of which none in a sample is without hope are left as they are.
  bool sample_has_hope(std::size_t slot, const std::vector<Row>& rows, std::size_t sample) {
    for (std::size_t i = 0; i < sample; ++i)
      if (hopeless_alone(slot, rows[i * rows.size() / sample])) return false;
    return true;
  }

  /// Rows that are looked at together.
  struct Part {
    RowSet read = nullptr;     ///< with what is read of them; null: not read
    std::vector<Row> rows;     ///< where they are not
    std::uint64_t open = 0;    ///< constraints that were when a set was last asked about of which these are some
    bool from_memory = false;  ///< a part that was asked about with other shared choices, or other rows elsewhere
    [[nodiscard]] const std::vector<Row>& all() const { return read != nullptr ? read->all() : rows; }
  };

  std::vector<Part> first_parts(std::size_t slot) {
    std::vector<Part> parts;
    for (RowSet& part : tables_.parts(*plan_.stage, plan_.shared, slot, *plan_.region.rows[slot]))
      parts.push_back({.read = std::move(part), .rows = {}, .from_memory = true});
    if (parts.empty()) parts.push_back({.read = plan_.region.rows[slot], .rows = {}});
    return parts;
  }

  /// Of a long table sets of alike rows are asked about instead of rows, down to small ones, or to some hundred rows of
  /// which a sample has hope. A large set of which a row has hope need not be read to know that it has: to read such
  /// sets takes far longer than to ask about some of their rows.
  std::vector<Row> sieved(std::size_t slot) {
    constexpr std::size_t few = 16, not_many = 512, some = 4, sample = 16;
    if (hopeless(plan_, ask(slot, plan_.region.rows[slot]->alive()))) return {};
    std::vector<Part> open = first_parts(slot);
    std::optional<RowProfile> profile;
    std::vector<RowSet> settled;
    std::vector<Row> kept;
    Bounds bounds;
    const auto split = [&](const Part& part) {
      if (!profile) find_profile(plan_, inherited_, slot, profile.emplace(*plan_.stage, plan_.shared), desk_);
      RowProfile::Halves halves = profile->cut_slot(part.all(), slot, part.open);
      open.push_back({.rows = std::move(halves.left), .open = part.open});
      open.push_back({.rows = std::move(halves.right), .open = part.open});
    };
    while (!open.empty()) {
      Part part = std::move(open.back());
      open.pop_back();
      const std::size_t size = part.all().size();
      if (part.read == nullptr && size > not_many && one_has_hope(slot, part.rows, some)) {
        split(part);
        continue;
      }
      if (part.read == nullptr) part.read = make_rows(*plan_.stage, plan_.shared, slot, std::move(part.rows));
      const auto& answer = ask(slot, part.read->alive());
      if (hopeless(plan_, answer)) {
        settled.push_back(std::move(part.read));
        continue;
      }
      read_bounds(plan_, answer, bounds);
      part.open = bounds.open;
      const bool is_small =
          size <= few || (size <= not_many && sample_has_hope(slot, part.all(), part.from_memory ? some : sample));
      if (!is_small) {
        split(part);
        continue;
      }
      kept.insert(kept.end(), part.read->begin(), part.read->end());
      settled.push_back(std::move(part.read));
    }
    tables_.keep_parts(*plan_.stage, plan_.shared, slot, std::move(settled));
    std::sort(kept.begin(), kept.end());
    return kept;
  }

  StagePlan& plan_;
  std::span<const Interval> inherited_;
  Desk& desk_;
  TableMemory& tables_;
  std::vector<Interval> readings_;  ///< of the row asked about last
};

}  // namespace

bool shave(StagePlan& plan, std::span<const Interval> inherited, Desk& desk, TableMemory& tables) {
  return Shaving(plan, inherited, desk, tables).run();
}

}  // namespace millwright::solver
