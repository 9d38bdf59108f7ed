// SPDX-License-Identifier: Apache-2.0
// What a result rests on: parts with their prices and sources, requirements, assumptions, estimates, the certificate.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "report/certificate_text.h"
#include "report/conversion_text.h"
#include "report/cut_text.h"
#include "report/design_text.h"
#include "report/html.h"
#include "report/machine_text.h"
#include "report/page_parts.h"
#include "scalar/unit.h"

namespace millwright::report {

using evaluation::Check;
using evaluation::Design;
using evaluation::PartLine;

namespace {

/// Where prices and figures come from: each text once, under a number.
class Notes {
 public:
  explicit Notes(const Texts& t) : t_(t) {}
  /// "1, 4" with links; empty if nothing is known.
  std::string of(const PartLine& part) {
    std::string out;
    for (const auto& [label, text] :
         {std::pair<std::string_view, const std::string&>{"parts.price_basis", part.price_basis},
          {"parts.source", part.source}}) {
      if (text.empty()) continue;
      const std::size_t number = index(t_(label) + ": " + text);
      out += fmt::format("{0}<a href=\"#note-{1}\">{1}</a>", out.empty() ? "" : ", ", number);
    }
    return out;
  }
  [[nodiscard]] std::string list() const {
    if (texts_.empty()) return {};
    std::string out = "<ol class=\"notes\">\n";
    for (std::size_t i = 0; i < texts_.size(); ++i)
      out += fmt::format("<li id=\"note-{}\">{}</li>\n", i + 1, escaped(texts_[i]));
    return out + "</ol>\n";
  }

 private:
  std::size_t index(const std::string& text) {
    const auto found = std::find(texts_.begin(), texts_.end(), text);
    if (found != texts_.end()) return static_cast<std::size_t>(found - texts_.begin()) + 1;
    texts_.push_back(text);
    return texts_.size();
  }
  const Texts& t_;
  std::vector<std::string> texts_;
};

std::string requirements_html(const MachineResult& result, const Texts& t) {
  HtmlTable table("<><<<",
                  {t("requirements.name"),
                   t("check.value"),
                   t("requirements.axes"),
                   t("requirements.meaning"),
                   t("requirements.from")},
                  "stacked");
  for (const RequirementLine& line : result.requirements)
    table.add({"<code>" + escaped(line.key) + "</code>",
               escaped(shown_value(line)),
               escaped(fmt::format("{}", fmt::join(line.axes, " "))),
               escaped(t.said(line.meaning)),
               escaped(line.given ? t("requirements.given") : t("requirements.default") + ": " + line.source)});
  return section("requirements", t("requirements"), table.str());
}

std::string outside_html(const Design& design, const Texts& t) {
  HtmlTable table(
      "<<<<<", {t("axis"), t("outside.element"), t("check"), t("outside.formula"), t("outside.limit")}, "stacked");
  for (const evaluation::OutsideValidity& line : design.outside_validity)
    table.add({escaped(line.axis),
               escaped(line.element),
               escaped(line.constraint),
               escaped(line.title) + "<small><code>" + escaped(line.formula) + "</code> · " + escaped(line.source) +
                   "</small>",
               escaped(line.sentence)});
  if (table.empty()) return {};
  return section("outside", t("outside"), "<p>" + escaped(t("outside.about")) + "</p>\n" + table.str());
}

/// What of a part is an estimate; what is quoted or measured of it is not mentioned.
std::vector<std::string> estimated_of(const PartLine& part, const Design& design, const Texts& t) {
  std::vector<std::string> what;
  if (part.price_estimate) what.push_back(t("parts.price_basis") + ": " + part.price_basis);
  if (part.confidence == "low") what.push_back(t("parts.confidence") + ": " + t.said(part.confidence));
  const bool modelled = std::any_of(design.checks.begin(), design.checks.end(), [&](const Check& check) {
    return check.axis == part.axis && check.id == "C-ST-TORQUE" && !check.note.empty();
  });
  if (part.slot == "motor" && modelled) what.push_back(t("assume.torque"));
  return what;
}

std::string assumptions_html(const Design& design, const Texts& t) {
  std::string list;
  const auto item = [&](const std::string& text) { list += "<li>" + escaped(text) + "</li>\n"; };
  item(t(machining_assumption(design)));
  item(t(length_assumption(design)));
  for (const std::string& line : stated_only_lines(design, t)) item(line);
  if (!std::isnan(design.total(machine::Quantity::cycle_time))) item(t("assume.cycle"));
  if (!std::isnan(design.total(machine::Quantity::energy))) item(t("assume.energy"));
  std::set<std::string> bases;
  for (const PartLine& part : design.parts)
    if (!part.price_basis.empty()) bases.insert(part.price_basis);
  if (!bases.empty()) item(t("assume.prices") + ": " + fmt::format("{}", fmt::join(bases, "; ")));
  std::string estimates;
  for (const PartLine& part : design.parts) {
    if (!part.estimate) continue;
    const std::vector<std::string> why = estimated_of(part, design, t);
    estimates += fmt::format("<li>{} {}: {} <small>{}</small></li>\n",
                             escaped(t.axis(part.axis)),
                             escaped(t.slot(part.slot)),
                             escaped(part_name(part)),
                             escaped(fmt::format("{}", fmt::join(why, " · "))));
  }
  std::set<std::string> notes;
  for (const Check& check : design.checks)
    if (!check.note.empty()) notes.insert(check.axis + " " + check.id + ": " + t.said(check.note));
  for (const std::string& note : notes) estimates += "<li>" + escaped(note) + "</li>\n";
  std::string content = "<ul>\n" + list + "</ul>\n";
  if (!estimates.empty())
    content += "<h3>" + escaped(t("assume.estimates")) + "</h3>\n<ul class=\"columns\">\n" + estimates + "</ul>\n";
  return section("assumptions", t("assumptions"), content);
}

}  // namespace

namespace {

/// Bar by bar what is cut from it; empty where no whole bars are bought.
std::string bars_table(const Design& design, const Texts& t) {
  HtmlTable table("<><>", {t("parts.part"), t("parts.bar"), t("parts.pieces"), t("parts.left_over")});
  const auto millimetres = [](double metres) { return escaped(shown_millimetres(metres)); };
  for (const evaluation::BarPurchase& purchase : design.bars) {
    bool first = true;
    for (const evaluation::CutBar& bar : purchase.bars) {
      std::vector<std::string> pieces;
      for (const evaluation::BarPiece& piece : bar.pieces)
        pieces.push_back(escaped(piece.axis + "." + piece.slot) + " " + millimetres(piece.length));
      table.add({first ? escaped(part_name(purchase.manufacturer, purchase.part_number)) : "",
                 millimetres(purchase.stock_length),
                 fmt::format("{}", fmt::join(pieces, ", ")),
                 millimetres(bar.left_over)},
                first ? "first" : "");
      first = false;
    }
  }
  return table.empty() ? std::string() : "<h3>" + escaped(t("parts.bars")) + "</h3>\n" + table.str();
}

/// What it is called, and beside that the word for bills of materials and the command line.
std::string slot_cell(const std::string& slot, const Texts& t) {
  const std::string called = t.slot(slot);
  return escaped(called) + (called == slot ? "" : "<small><code>" + escaped(slot) + "</code></small>");
}

}  // namespace

std::string parts_table(const MachineResult& result, const Design& design, const Texts& t) {
  HtmlTable table("<<<>>>><<<",
                  {t("axis"),
                   t("parts.slot"),
                   t("parts.part"),
                   t("parts.quantity"),
                   t("parts.length"),
                   escaped(design.currency),
                   "kg",
                   t("parts.supplier"),
                   t("parts.confidence"),
                   t("parts.notes")},
                  "parts");
  // Where the columns have no heads, on a narrow screen.
  const auto unit = [](const std::string& text) { return "<span class=\"unit\"> " + escaped(text) + "</span>"; };
  const auto label = [&](const char* key) { return "<span class=\"unit\">" + escaped(t(key)) + ": </span>"; };
  const auto stated = [&](const std::string& currency, double price) {
    const std::string text = stated_price(design, currency, price);
    return text.empty() ? text : "<small>" + escaped(text) + "</small>";
  };
  Notes notes(t);
  std::vector<std::string> axes = result.axes;
  axes.emplace_back("machine");
  double cost = design.cost;
  double mass = design.mass;
  for (const std::string& axis : axes) {
    bool first = true;
    for (const PartLine& part : design.parts) {
      if (part.axis != axis) continue;
      cost -= part.price;
      mass -= part.mass;
      table.add(
          {first ? "<b>" + escaped(t.axis(axis)) + "</b>" : std::string(),
           slot_cell(part.slot, t) + (part.origin.empty() ? "" : "<small>" + escaped(part.origin) + "</small>"),
           escaped(part_name(part)) + (part.preferred ? "<small>" + escaped(t("parts.preferred")) + "</small>" : "") +
               (part.paper_only ? "<small class=\"note\">" + escaped(t("parts.paper_only")) + "</small>" : ""),
           scalar::format_number(part.quantity) + unit("x") +
               (part.owned > 0.0
                    ? fmt::format("<small>{} {}</small>", scalar::format_number(part.owned), t("parts.owned"))
                    : "") +
               (part.spares > 0.0
                    ? fmt::format("<small>+ {} {}</small>", scalar::format_number(part.spares), t("parts.spare"))
                    : ""),
           part.length > 0.0 ? escaped(shown_millimetres(part.length)) : "",
           fmt::format("{}{:.2f}", part.estimate ? "~" : "", part.price) + unit(design.currency) +
               stated(part.stated_currency, part.price),
           part.mass > 0.0 ? fmt::format("{:.3f}", part.mass) + unit("kg") : "",
           label("parts.supplier") + (part.supplier.empty() ? "<small>" + escaped(t("parts.no_supplier")) + "</small>"
                                                            : escaped(part.supplier)),
           part.confidence.empty() ? std::string() : label("parts.confidence") + escaped(t.said(part.confidence)),
           notes.of(part)},
          first ? "first" : "");
      first = false;
    }
  }
  for (const evaluation::ShopOrder& order : design.orders) {
    cost -= order.shipping_fee + order.top_up;
    const std::string name = order.supplier.empty() ? "-" : order.supplier;
    const auto add = [&](const std::string& what, double charge) {
      if (charge > 0.0)
        table.add({"",
                   "",
                   escaped(what),
                   "",
                   "",
                   fmt::format("{:.2f}", charge) + stated(order.stated_currency, charge),
                   "",
                   escaped(name),
                   "",
                   ""});
    };
    add(t("parts.shipping"), order.shipping_fee);
    add(t("parts.top_up"), order.top_up);
  }
  if (cost >= 0.005 || mass >= 5e-4)
    table.add({"",
               "",
               escaped(t("parts.made")),
               "",
               "",
               fmt::format("{:.2f}", cost),
               fmt::format("{:.3f}", mass),
               "",
               "",
               ""});
  table.add({"",
             "",
             escaped(t("parts.total")),
             "",
             "",
             fmt::format("{:.2f}", design.cost) + unit(design.currency),
             fmt::format("{:.3f}", design.mass) + unit("kg"),
             "",
             "",
             ""},
            "sum");
  std::string out = table.str() + "<p class=\"hint\">" + escaped(t("parts.estimate")) + "</p>\n";
  for (const evaluation::Conversion& each : design.conversions)
    out += "<p class=\"hint\">" + escaped(t("parts.converted")) + " " +
           escaped(rate_text(each, design.currency, t("parts.no_date"))) + "</p>\n";
  return out + bars_table(design, t) + notes.list();
}

std::string basis_sections(const MachineResult& result, const Design& design, const Texts& t) {
  return outside_html(design, t) + requirements_html(result, t) + assumptions_html(design, t);
}

std::string nothing_section(const MachineResult& result, const Texts&) {
  return "<pre>" + escaped(nothing_text(result, Style{})) + "</pre>\n";
}

std::string catalogues_section(const MachineResult& result, const Texts& t) {
  const catalogue::Inventory& all = result.catalogues;
  if (all.layers.empty()) return {};
  const auto hash = [](const std::string& sha256) { return "<code class=\"hash\">" + escaped(sha256) + "</code>"; };
  HtmlTable layers("<>><", {t("catalogues.place"), t("catalogues.files"), t("catalogues.rows"), "SHA-256"});
  for (const catalogue::LayerRecord& layer : all.layers) {
    std::string parts = std::to_string(layer.files);
    for (const catalogue::RemarkFile& each : layer.remarks) parts += " + " + escaped(each.name);
    layers.add({escaped(layer.place), parts, std::to_string(layer.rows), hash(layer.sha256)});
  }
  std::set<std::string> used;
  for (const Design& design : result.designs)
    for (const PartLine& part : design.parts) used.insert(part.where.substr(0, part.where.rfind(':')));
  HtmlTable files("<><", {t("catalogues.file"), t("catalogues.rows"), "SHA-256"});
  for (const catalogue::FileRecord& file : all.files) {
    const std::string& place = all.layers[static_cast<std::size_t>(file.layer)].place;
    const std::string name = used.count(place) > 0 ? place : place + "/" + file.name;
    if (used.count(name) > 0) files.add({escaped(name), std::to_string(file.rows), hash(file.sha256)});
  }
  return section("catalogues",
                 t("catalogues"),
                 "<p class=\"hint\">" + escaped(t("catalogues.about")) + "</p>\n" + layers.str() +
                     (files.empty() ? std::string() : files.str()));
}

std::string certificate_section(const MachineResult& result, const Texts& t) {
  const std::string text = certificate_text(result, Style{}, t);
  const std::size_t line = text.find('\n');
  return section("certificate", t("certificate"), "<pre>" + escaped(text.substr(line + 1)) + "</pre>\n");
}

}  // namespace millwright::report
