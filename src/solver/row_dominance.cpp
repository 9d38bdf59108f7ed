// SPDX-License-Identifier: Apache-2.0
#include "solver/row_dominance.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "solver/archive.h"

namespace millwright::solver {
namespace {

/// The plan's region in parts, in each of which all rows of a slot are of one kind where there are few kinds: what
/// holds for some kinds only can be said to hold, or not, of such a part.
std::vector<Region> parts_by_kinds(const StagePlan& plan) {
  constexpr std::size_t few_kinds = 4, few_parts = 16;
  std::vector<Region> parts{plan.region};
  for (std::size_t slot = 0; slot < plan.region.rows.size(); ++slot) {
    if (plan.stage->graded_readings(slot) == 0) continue;
    std::map<std::size_t, std::vector<Row>> of_kind;
    for (const Row row : *plan.region.rows[slot]) {
      of_kind[plan.stage->row_kind(slot, row)].push_back(row);
      if (of_kind.size() > few_kinds) break;
    }
    if (of_kind.size() < 2 || of_kind.size() > few_kinds || parts.size() * of_kind.size() > few_parts) continue;
    std::vector<Region> finer;
    for (auto& [kind, rows] : of_kind) {
      const RowSet set = make_rows(*plan.stage, plan.shared, slot, std::move(rows));
      for (const Region& part : parts) finer.emplace_back(part).rows[slot] = set;
    }
    parts = std::move(finer);
  }
  return parts;
}

class DominatedRows {
 public:
  DominatedRows(const StagePlan& plan, std::span<const Region> parts, std::size_t slot, Desk& desk)
      : plan_(plan), parts_(parts), slot_(slot), graded_(plan.stage->graded_readings(slot)), desk_(desk) {}

  /// The rows that are left.
  std::vector<Row> others() {
    std::map<std::size_t, std::map<std::uint32_t, std::vector<Row>>> comparable;  // [kind][partners]
    for (const Row row : *plan_.region.rows[slot_]) {
      const std::uint32_t fit = plan_.fits.everything_fits() ? 0 : plan_.fits.kinds(slot_)[row];
      comparable[plan_.stage->row_kind(slot_, row)][fit].push_back(row);
    }
    std::vector<Row> left;
    for (const auto& [kind, by_fit] : comparable) {
      ask_about(kind);
      for (const auto& [fit, rows] : by_fit) keep_best(rows, left);
    }
    std::sort(left.begin(), left.end());
    return left;
  }

 private:
  /// Directions are asked for where rows of this kind are.
  void ask_about(std::size_t kind) {
    directions_.assign(graded_, std::nullopt);
    questions_.clear();
    for (const Region& part : parts_) {
      const Rows& rows = *part.rows[slot_];
      const bool all_kinds = rows.size() == plan_.region.rows[slot_]->size();
      if (!all_kinds && plan_.stage->row_kind(slot_, rows.front()) != kind) continue;
      questions_.push_back({plan_.stage, plan_.shared, plan_.criteria, &part, plan_.inherited, plan_.after});
    }
  }

  void keep_best(const std::vector<Row>& rows, std::vector<Row>& left) {
    if (rows.size() < 2) {
      left.insert(left.end(), rows.begin(), rows.end());
      return;
    }
    find_coordinates(rows);
    const std::size_t width = alike_ + graded_coordinates_;
    const auto of_row = [&](std::size_t i) { return std::span<const double>(coordinates_.data() + i * width, width); };
    // Rows that are alike in what has to be equal come together; of these, what is at most another one in all graded
    // coordinates comes before it, among equals the smaller number.
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < rows.size(); ++i) {
      const auto of = of_row(i);
      // What is not known compares with nothing.
      if (std::any_of(of.begin(), of.end(), [](double coordinate) { return std::isnan(coordinate); }))
        left.push_back(rows[i]);
      else
        order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::lexicographical_compare(of_row(a).begin(), of_row(a).end(), of_row(b).begin(), of_row(b).end());
    });
    std::optional<Archive> best;
    std::span<const double> known;
    for (const std::uint32_t i : order) {
      look_at_time();
      const auto alike = of_row(i).first(alike_);
      const auto graded = of_row(i).subspan(alike_);
      if (!best || !std::equal(alike.begin(), alike.end(), known.begin())) best.emplace(graded_coordinates_);
      known = alike;
      if (best->dominates(graded)) continue;
      best->add(graded);
      left.push_back(rows[i]);
    }
  }

  /// An end of a reading that is to be small, or, with a negative sign, to be large.
  struct Coordinate {
    std::size_t reading = 0;
    double Interval::*end = nullptr;
    double sign = 1.0;
  };

  /// Coordinates of rows: first what has to be equal where one row stands in for another, then what is to be small.
  /// What is equal in all rows is neither.
  void find_coordinates(const std::vector<Row>& rows) {
    const std::vector<bool> differs = what_differs(rows);
    std::vector<Coordinate> alike, graded;
    for (std::size_t r = 0; r < differs.size(); ++r) {
      if (!differs[r]) continue;
      const Direction direction = r < graded_ ? direction_of(r) : Direction::equal_only;
      if (direction == Direction::irrelevant) continue;
      std::vector<Coordinate>& kind = direction == Direction::equal_only ? alike : graded;
      if (direction != Direction::larger_is_better) kind.push_back({r, &Interval::upper, 1.0});
      if (direction != Direction::smaller_is_better) kind.push_back({r, &Interval::lower, -1.0});
    }
    alike_ = alike.size();
    graded_coordinates_ = graded.size();
    coordinates_.clear();
    coordinates_.reserve(rows.size() * (alike_ + graded_coordinates_));
    for (const Row& row : rows) {
      read(row);
      for (const auto* const kind : {&alike, &graded})
        for (const auto& [reading, end, sign] : *kind) coordinates_.push_back(sign * (readings_[reading].*end));
    }
  }

  /// Of each reading, whether it is another in some row than in the first. (All readings of all rows of a long table
  /// would be more than is worth keeping.)
  std::vector<bool> what_differs(const std::vector<Row>& rows) {
    read(rows.front());
    const std::vector<Interval> first = readings_;
    std::vector<bool> differs(first.size(), false);
    for (const Row& row : rows) {
      read(row);
      for (std::size_t r = 0; r < first.size(); ++r)
        if (readings_[r].lower != first[r].lower || readings_[r].upper != first[r].upper) differs[r] = true;
    }
    return differs;
  }

  /// Now and then.
  void look_at_time() {
    constexpr std::size_t now_and_then = 1024;
    if (++steps_ % now_and_then == 0) desk_.look_at_time();
  }

  void read(const Row& row) {
    look_at_time();
    plan_.stage->read(plan_.shared, slot_, std::span(&row, 1), readings_);
  }

  Direction direction_of(std::size_t reading) {
    std::optional<Direction>& known = directions_[reading];
    if (!known) known = prove_reading_direction(questions_, slot_, reading, desk_);
    return *known;
  }

  const StagePlan& plan_;
  std::span<const Region> parts_;
  std::size_t slot_;
  std::size_t graded_;
  Desk& desk_;
  std::vector<MonotonicityQuestion> questions_;       ///< about the kind that is compared
  std::vector<std::optional<Direction>> directions_;  ///< [graded reading], of that kind
  std::vector<Interval> readings_;                    ///< of the row read last
  std::size_t steps_ = 0;
  std::size_t alike_ = 0, graded_coordinates_ = 0;  ///< of each row
  std::vector<double> coordinates_;                 ///< [row][coordinate]
};

/// The rows of a slot that are left; nothing where all are.
RowSet others_of(const StagePlan& plan, std::span<const Region> parts, std::size_t slot, Desk& desk) {
  const std::size_t rows = plan.region.rows[slot]->size();
  std::vector<Row> left = DominatedRows(plan, parts, slot, desk).others();
  return left.size() < rows ? make_rows(*plan.stage, plan.shared, slot, std::move(left)) : nullptr;
}

}  // namespace

void leave_out_dominated_rows(StagePlan& plan, Desk& desk, std::size_t least_rows) {
  std::vector<std::size_t> asked;
  for (std::size_t slot = 0; slot < plan.region.rows.size(); ++slot)
    if (plan.region.rows[slot]->size() >= least_rows && plan.stage->graded_readings(slot) > 0) asked.push_back(slot);
  if (asked.empty()) return;
  const std::vector<Region> parts = parts_by_kinds(plan);
  std::vector<RowSet> rows;  // all of a plan or none: it may be interrupted
  for (const std::size_t slot : asked) rows.push_back(others_of(plan, parts, slot, desk));
  for (std::size_t i = 0; i < asked.size(); ++i) {
    if (rows[i] == nullptr) continue;
    plan.region.rows[asked[i]] = std::move(rows[i]);
    keep_within_region(plan, asked[i]);
  }
}

void leave_out_dominated_rows(std::vector<StagePlan>& plans, Desk& desk) {
  for (StagePlan& plan : plans) leave_out_dominated_rows(plan, desk, 2);
}

}  // namespace millwright::solver
