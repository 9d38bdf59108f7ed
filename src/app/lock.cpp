// SPDX-License-Identifier: Apache-2.0
#include "app/lock.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "app/help.h"
#include "app/output.h"
#include "app/output_target.h"
#include "catalogue/difference.h"
#include "catalogue/figures.h"
#include "catalogue/file_names.h"
#include "scalar/unit.h"
#include "text/sha256.h"

namespace millwright::app {

namespace {

using catalogue::Catalogue;
using catalogue::Table;
using report::LockedPart;

const Catalogue& whole(const MachineInput& input) {
  return input.whole_catalogue ? *input.whole_catalogue : input.catalogue;
}

report::LockedInput locked(const std::string& kind, const std::string& name, const text::SourceText& text) {
  return {kind, report::lock_text(name), text::sha256(text.bytes())};
}

std::vector<std::string> lock_texts(const std::vector<std::string>& texts) {
  std::vector<std::string> out;
  for (const std::string& text : texts) out.push_back(report::lock_text(text));
  return out;
}

/// Gathers parts; those of several slots once.
class PartList {
 public:
  explicit PartList(const Catalogue& parts) : catalogue_(parts) {}

  void add(const evaluation::PartLine& line) {
    const auto family = catalogue::find_family(line.family);
    if (!family) return;  // made to the problem's figures
    const std::string slot = line.axis + "." + line.slot;
    add(catalogue_.table(*family), line.manufacturer, line.part_number, slot);
    if (*family == catalogue::Family::steppers)
      add(catalogue_.table(catalogue::Family::stepper_curves), line.manufacturer, line.part_number, slot);
  }

  std::vector<LockedPart> take() { return std::move(parts_); }

 private:
  void add(const Table& table, const std::string& maker, const std::string& number, const std::string& slot) {
    std::map<std::string, int> titles;
    for (const int row : table.find(number, maker).rows) titles.emplace(catalogue::part_title(table, row), row);
    for (const auto& [title, row] : titles) {
      const std::string key = std::string(catalogue::declaration(table.family()).name) + "\n" + title;
      const auto [place, is_new] = places_.emplace(key, parts_.size());
      if (is_new) parts_.push_back(part(table, row, title));
      std::vector<std::string>& slots = parts_[place->second].slots;
      if (std::find(slots.begin(), slots.end(), report::lock_text(slot)) == slots.end())
        slots.push_back(report::lock_text(slot));
    }
  }

  LockedPart part(const Table& table, int row, const std::string& title) const {
    LockedPart part;
    part.family = catalogue::declaration(table.family()).name;
    part.manufacturer = report::lock_text(table.manufacturer(row));
    part.part_number = report::lock_text(table.part_number(row));
    part.title = report::lock_text(title);
    const std::string& place = catalogue_.layers()[static_cast<std::size_t>(table.layer(row))].string();
    part.file =
        report::lock_text(file_in_place(table.layer(row) == 0 ? std::string("catalogues") : place,
                                        catalogue::name_in_place(table.files()[table.file(row)].text->path(), place)));
    const auto rows = catalogue::rows_of_part(table, table.manufacturer(row), table.part_number(row), title);
    for (const catalogue::NamedFigure& figure : catalogue::figures_of(table, rows))
      part.figures.push_back({figure.name, report::lock_text(figure.value)});
    return part;
  }

  const Catalogue& catalogue_;
  std::vector<LockedPart> parts_;
  std::map<std::string, std::size_t> places_;
};

}  // namespace

catalogue::Inventory inventory_of(const MachineInput& input) {
  catalogue::Inventory inventory = catalogue::inventory(whole(input));
  if (!inventory.layers.empty()) inventory.layers.front().place = "catalogues";
  return inventory;
}

std::string file_in_place(const std::string& place, const std::string& name) {
  // Within a folder a name begins with that of its family's folder.
  return std::filesystem::path(place).filename() == name ? place : place + "/" + name;
}

bool wants_inventory(const Options& options) { return !options.json.empty() || !options.report.empty(); }

report::LockedQuestion question_of(const Options& options) {
  static const std::map<Verb, const char*> names = {{Verb::solve, "solve"},
                                                    {Verb::pareto, "pareto"},
                                                    {Verb::check, "check"},
                                                    {Verb::compare, "compare"},
                                                    {Verb::explain, "explain"}};
  const auto name = names.find(options.verb);
  return {name == names.end() ? "" : name->second,
          lock_texts(options.settings),
          lock_texts(options.limits),
          lock_texts(options.without),
          lock_texts(options.fixed),
          lock_texts(options.objectives)};
}

std::vector<report::LockedInput> locked_inputs(const MachineInput& input, const BomTexts& boms) {
  std::vector<report::LockedInput> inputs;
  const std::string& problem = input.document->text()->path();
  inputs.push_back(locked("problem", problem, *input.document->text()));
  text::Diagnostics unused;  // they have been read already
  for (const std::string& name : profile_names(*input.document))
    if (const auto text =
            text::SourceText::load((std::filesystem::path(problem).parent_path() / name).string(), unused))
      inputs.push_back(locked("profile", name, *text));
  for (const std::filesystem::path& place : input.catalogue.layers())
    if (const auto stock = catalogue::stock_file(place))
      if (const auto text = text::SourceText::load(stock->string(), unused))
        inputs.push_back(locked("stock", stock->string(), *text));
  for (const std::filesystem::path& place : input.catalogue.layers())
    for (const std::filesystem::path& file : catalogue::supplier_files(place))
      if (const auto text = text::SourceText::load(file.string(), unused))
        inputs.push_back(
            locked(catalogue::is_named(file, "offers.csv") ? "offers" : "suppliers", file.string(), *text));
  for (const auto& bom : boms) inputs.push_back(locked("bill of materials", bom->path(), *bom));
  return inputs;
}

std::vector<LockedPart> locked_parts(const MachineInput& input, const std::vector<const evaluation::Design*>& designs) {
  PartList list(whole(input));
  for (const evaluation::Design* design : designs)
    for (const evaluation::PartLine& line : design->parts) list.add(line);
  return list.take();
}

bool write_lock(const Options& options,
                const MachineInput& input,
                const std::vector<const evaluation::Design*>& designs,
                const BomTexts& boms) {
  if (options.write_lock.empty()) return true;
  constexpr int digits = 15;
  report::Lock lock;
  lock.version = version;
  lock.question = question_of(options);
  if (designs.size() == 1) {
    lock.cost = scalar::format_number(designs.front()->cost, digits) + " " + designs.front()->currency;
    lock.mass = scalar::format_number(designs.front()->mass, digits) + " kg";
  }
  lock.inputs = locked_inputs(input, boms);
  const catalogue::Inventory inventory = inventory_of(input);
  for (const catalogue::LayerRecord& layer : inventory.layers) lock.places.push_back(report::lock_text(layer.place));
  for (const catalogue::FileRecord& file : inventory.files)
    lock.files.push_back({file.layer,
                          std::string(catalogue::declaration(file.family).name),
                          report::lock_text(file.name),
                          file.rows,
                          file.sha256});
  lock.parts = locked_parts(input, designs);
  text::Diagnostics failures;
  const bool written =
      write_target({options.write_lock, OutputKind::lock, options.force}, report::lock_toml(lock), failures);
  print(failures);
  return written;
}

}  // namespace millwright::app
