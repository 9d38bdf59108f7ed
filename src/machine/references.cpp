// SPDX-License-Identifier: Apache-2.0
#include "machine/references.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "machine/word_column.h"
#include "text/nearest.h"

namespace millwright::machine {

namespace {

/// Words that choose among the screws must each choose one.
void check_screws(const Axis& axis,
                  const Member& member,
                  const char* key,
                  const WordColumn& column,
                  const std::vector<std::string>& words,
                  const catalogue::Table& screws,
                  text::Diagnostics& diagnostics) {
  std::vector<std::string> known;
  for (int row = 0; row < screws.rows(); ++row) known.emplace_back(column.text(screws, row));
  for (const std::string& word : words) {
    if (std::any_of(known.begin(), known.end(), [&](const auto& text) { return column.takes(word, text); })) continue;
    diagnostics.error(
        member.where,
        fmt::format(
            "axis '{}', {}: {}: no screw {} in the catalogues", axis.name, member.name, key, text::in_quotes(word)),
        text::did_you_mean(word, known, "'millwright catalogue list screws' shows what there is"));
  }
}

/// Steel sections are rolled of the grade that the material names; extrusions are of the alloy of their row, and beside
/// steel sections take no notice of it. A material that contradicts its sections would be computed as one or the other.
void check_material_of_sections(const Axis& axis,
                                const Member& member,
                                std::string_view material_class,
                                text::Diagnostics& diagnostics) {
  const auto cut_of = [&](const char* family) {
    return std::find(member.sections.begin(), member.sections.end(), family) != member.sections.end();
  };
  if (material_class.empty()) return;  // not said in the user's own catalogue
  const bool steel = cut_of("steel_sections"), extruded = !steel && cut_of("extrusions");
  const auto is = [&](const char* metal) { return material_class.find(metal) != std::string_view::npos; };
  if (!(steel && !is("steel")) && !(extruded && !is("alumin"))) return;
  diagnostics.error(member.where,
                    fmt::format("axis '{}', {}: {} are not of {} ({})",
                                axis.name,
                                member.name,
                                steel ? "steel_sections" : "extrusions",
                                text::in_quotes(member.material),
                                text::printable(material_class, 20)),
                    steel ? "name the grade of steel: S235JR; extrusions beside them keep the alloy of their row"
                          : "name an aluminium alloy: Al 6063-T5; computed is the alloy of each extrusion's row");
}

/// Says once of each currency without a rate how many parts it takes from the choice: nobody would miss them in an
/// answer that is proved for the others.
void note_unpriced(const Problem& problem, const catalogue::Catalogue& catalogue, text::Diagnostics& diagnostics) {
  struct Unpriced {
    int rows = 0;
    std::string first;
    std::string owned;  // the first that is owned
  };
  std::map<std::string_view, Unpriced> by_currency;
  const auto has_rate = [&](std::string_view currency) {
    return currency.empty() || currency == problem.currency || problem.currencies.contains(currency);
  };
  const auto note = [&](std::string_view currency, bool owned, const auto& name) {
    Unpriced& noted = by_currency[currency];
    if (noted.rows++ == 0) noted.first = name();
    if (owned && noted.owned.empty()) noted.owned = name();
  };
  for (std::size_t family = 0; family < catalogue::family_count; ++family) {
    const catalogue::Table& table = catalogue.table(static_cast<catalogue::Family>(family));
    for (int row = 0; row < table.rows(); ++row) {
      const catalogue::Price price = table.price(row);
      const std::string_view currency = price.currency;
      const bool priced = !std::isnan(price.piece) || !std::isnan(price.length) || !std::isnan(price.mass);
      if (priced && !has_rate(currency))
        note(currency, catalogue::owned_pieces(table, row, catalogue.stock()) > 0.0, [&] {
          return fmt::format("{} {}", table.manufacturer(row), table.part_number(row));
        });
    }
  }
  for (const catalogue::Offer& offer : catalogue.suppliers().offers)
    if (!has_rate(offer.currency))
      note(offer.currency, false, [&] { return fmt::format("{} of {}", offer.part_number, offer.supplier); });
  for (const auto& [currency, parts] : by_currency)
    diagnostics.warning(
        problem.currencies_where,
        fmt::format("the problem gives no rate for {}: {} priced in it {} not for sale ({}{}){}",
                    text::in_quotes(currency),
                    parts.rows == 1 ? "the part" : fmt::format("{} parts", parts.rows),
                    parts.rows == 1 ? "is" : "are",
                    text::printable(parts.first, 60),
                    parts.rows == 1 ? "" : ", ...",
                    parts.owned.empty()
                        ? ""
                        : fmt::format("; what is owned of them ({}) is used only where it is priced otherwise",
                                      text::printable(parts.owned, 60))),
        fmt::format("add it to [currency]: {} = 1.1", text::printable(currency, 20)));
}

}  // namespace

bool check_references(const Problem& problem, const catalogue::Catalogue& catalogue, text::Diagnostics& diagnostics) {
  const std::size_t errors = diagnostics.error_count();
  const catalogue::Table& materials = catalogue.table(catalogue::Family::materials);
  for (const Axis& axis : problem.axes) {
    for (const Member& member : axis.members) {
      if (member.kind == MemberKind::bolts) {  // screws bring their own material
        const catalogue::Table& screws = catalogue.table(catalogue::Family::screws);
        const BoltPattern& bolts = member.bolts;
        check_screws(axis, member, "sizes", word_columns::screw_size, bolts.sizes, screws, diagnostics);
        const WordColumn& property_class = word_columns::property_class;
        check_screws(axis, member, "property_classes", property_class, bolts.property_classes, screws, diagnostics);
        continue;
      }
      const catalogue::Found found = materials.find(member.material);
      if (found) {
        const catalogue::Column kind = catalogue::column(catalogue::Family::materials, "class");
        check_material_of_sections(axis, member, materials.text(kind, found.rows.front()), diagnostics);
        continue;
      }
      diagnostics.error(member.where,
                        fmt::format("axis '{}', {}: {}", axis.name, member.name, found.error),
                        found.hint.empty() ? "'millwright catalogue list materials' shows what there is" : found.hint);
    }
  }
  for (const catalogue::Supplier& supplier : catalogue.suppliers().suppliers) {
    if (!supplier.charges() || supplier.currency == problem.currency || problem.currencies.contains(supplier.currency))
      continue;
    diagnostics.error(
        supplier.where,
        fmt::format(
            "the problem gives no rate for {}, in which {} charges", supplier.currency, text::in_quotes(supplier.name)),
        fmt::format("add it to [currency]: {} = 1.1", supplier.currency));
  }
  note_unpriced(problem, catalogue, diagnostics);
  return diagnostics.error_count() == errors;
}

}  // namespace millwright::machine
