// SPDX-License-Identifier: Apache-2.0
#include "evaluation/supply_stage.h"

#include <array>
#include <span>

#include "evaluation/drive_tables.h"
#include "evaluation/figure_reader.h"

namespace millwright::evaluation {

using catalogue::column;
using catalogue::Family;

SupplyStage::SupplyStage(const std::vector<double>& voltages,
                         SupplyData data,
                         const catalogue::Catalogue& catalogue,
                         const PriceBook& prices)
    : voltages_(voltages), data_(std::move(data)) {
  name_ = "machine.supply";
  SlotTable table("supply", 3);
  const catalogue::Table& t = catalogue.table(Family::power_supplies);
  for (const int row : t.rows_in_order()) {
    std::vector<catalogue::Column> missing;
    constexpr std::array soft{column(Family::power_supplies, "output_current")};
    const FigureReader number(t, row, missing, soft);
    const std::array<double, 3> readings{number(column(Family::power_supplies, "power")),
                                         number(column(Family::power_supplies, "output_voltage")),
                                         number(column(Family::power_supplies, "output_current"))};
    const double mass = number(column(Family::power_supplies, "mass"));
    CandidateDraft candidate =
        candidate_of({{"supply", Family::power_supplies, row, 1.0, 0.0, prices.line(t, row, 1.0, 0.0), mass}}, 0.0);
    if (t.has_ranges())
      candidate.ranges = candidate_ranges(std::array{t.range(column(Family::power_supplies, "power"), row),
                                                     t.range(column(Family::power_supplies, "output_voltage"), row),
                                                     t.range(column(Family::power_supplies, "output_current"), row)},
                                          candidate.price,
                                          {},
                                          t.range(column(Family::power_supplies, "mass"), row));
    if (!table.admits(candidate, std::span(readings).first(2), missing)) continue;
    table.add(std::move(candidate), readings);
  }
  tables_.push_back(std::move(table));
  finish_slots();
  supply_constraints([&](const machine::Declaration& d, auto&&, auto&&, auto&&) {
    constraint_count_ += machine::is_searched(d, data_.require);
  });
}

template <class T>
Supply<T> SupplyStage::design(const Selection<T>& s) const {
  const auto read = [&](std::size_t field) { return tables_[0].template read<T>(s.rows[0], field); };
  Supply<T> d;
  d.data = &data_;
  d.demanded_power = T(data_.reserve) * s.inherited[power_state];
  d.rated_power = read(0);
  d.voltage = read(1);
  d.required_voltage = T(voltages_[s.shared.empty() ? 0 : s.shared.front()]);
  if constexpr (machine::shows_everything<T>) d.rated_current = read(2);
  return d;
}

template <class T>
void SupplyStage::answer(const Selection<T>& s, solver::Answer<T>& out) const {
  const Supply<T> d = design(s);
  supply_constraints(UtilisationVisitor<T, Supply<T>>(d, s.kept, out.utilisation));
  out.resources[cost_resource] = total<T>(s, Total::price);
  out.resources[mass_resource] = total<T>(s, Total::mass);
}

template Supply<double> SupplyStage::design(const Selection<double>&) const;

template class ElementStage<SupplyStage>;

}  // namespace millwright::evaluation
