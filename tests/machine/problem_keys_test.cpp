// SPDX-License-Identifier: Apache-2.0
// The keys of problem files, as found by asking the readers, against the readers' source, the shipped files, and the
// readers' own complaint about unknown keys.
#include "machine/problem_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "catch.h"
#include "machine/problem_file.h"
#include "text/document.h"

namespace millwright::machine::problem_keys_test {
namespace {

const std::vector<ProblemTable>& tables() {
  static const std::vector<ProblemTable> all = problem_tables();
  return all;
}

std::string content_of(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// path.key of every key; of any kind of its table.
std::set<std::string> known_paths() {
  std::set<std::string> paths;
  for (const ProblemTable& table : tables())
    for (const ProblemTableKind& kind : table.kinds)
      for (const ProblemKey& key : kind.keys) paths.insert((table.path.empty() ? "" : table.path + ".") + key.name);
  return paths;
}

void collect(const text::Node& node, const std::string& path, std::set<std::string>& paths) {
  for (const text::Node& item : node.items()) collect(item, path, paths);
  for (const text::TableEntry& entry : node.entries()) {
    const bool any_name = path == "currency" || path == "moves.axes" || path == "moves.forces";
    const std::string inner = (path.empty() ? "" : path + ".") + (any_name ? std::string("*") : entry.key);
    paths.insert(inner);
    collect(entry.value, inner, paths);
  }
}

const ProblemKey* find_key(const std::string& path, const std::string& kind, const std::string& name) {
  for (const ProblemTable& table : tables())
    for (const ProblemTableKind& each : table.kinds)
      for (const ProblemKey& key : each.keys)
        if (table.path == path && each.name == kind && key.name == name) return &key;
  return nullptr;
}

/// The head of a file in which the table `path` of that kind stands open.
std::string head_of(const std::string& path, const std::string& kind) {
  const std::string axis =
      fmt::format("[[axis]]\nmechanism.kind = \"{}\"\n", kind == axis_that_turns ? axis_that_turns : "screw");
  if (path.empty()) return "";
  if (path == "axis") return axis;
  if (path == "axis.mechanism") return fmt::format("[[axis]]\n[axis.mechanism]\nkind = \"{}\"\n", kind);
  if (path == "axis.mechanism.reduction")
    return "[[axis]]\n[axis.mechanism]\nkind = \"rack\"\n[axis.mechanism.reduction]\n";
  if (path == "axis.members") return axis + fmt::format("[[axis.members]]\nkind = \"{}\"\n", kind);
  if (path == "axis.moves") return axis + "[[axis.moves]]\n";
  if (path == "axis.moves.cutting") return axis + "[[axis.moves]]\n[axis.moves.cutting]\n";
  if (path.starts_with("axis.")) return axis + "[" + path + "]\n";
  if (path == "moves") return "[[moves]]\n";
  if (path == "moves.axes" || path == "moves.forces") return "[[moves]]\n[" + path + "]\n";
  if (path == "currency.*") return "[currency.EUR]\n";
  return "[" + path + "]\n";
}

// One case, as to ask the readers for all keys takes long where it is sanitised.
TEST_CASE("Keys of problem files are those of their readers") {
  SECTION("Every key says what it means and what may stand there") {
    std::size_t keys = 0;
    for (const ProblemTable& table : tables())
      for (const ProblemTableKind& kind : table.kinds)
        for (const ProblemKey& key : kind.keys) {
          CAPTURE(table.path, kind.name, key.name);
          CHECK_FALSE(key.meaning.empty());
          CHECK_FALSE(key.forms.empty());
          ++keys;
        }
    CHECK(keys > 400);
  }

  SECTION("Every key of the shipped problem files is listed") {
    const std::set<std::string> known = known_paths();
    std::set<std::string> used;
    for (const auto& entry : std::filesystem::directory_iterator(MILLWRIGHT_SOURCE_DIR "/problems")) {
      if (entry.path().extension() != ".toml") continue;
      text::Diagnostics diagnostics;
      const auto document = text::read_document(entry.path().string(), diagnostics);
      REQUIRE(document);
      collect(document->root(), "", used);
    }
    CHECK(used.size() > 100);
    for (const std::string& path : used) {
      CAPTURE(path);
      CHECK(known.count(path) == 1);
    }
  }

  // Every literal that the readers' source hands to a reader as a key, wherever it is asked for.
  SECTION("Every key in the source of the readers is listed") {
    std::set<std::string> names;
    for (const std::string& path : known_paths()) names.insert(path.substr(path.rfind('.') + 1));
    const std::regex asked(
        R"re(\b(?:q|table|inner|reader|components)\.(?!describe)\w+\(\s*\{?"(\w+)"|\b(?:size|range|spacing)\(\{"(\w+)")re");
    std::set<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(MILLWRIGHT_SOURCE_DIR "/src/machine")) {
      const std::string name = entry.path().filename().string();
      const bool reads = name == "cutting_process.cpp" || (name.ends_with("_file.cpp") && !name.starts_with("claims"));
      if (!reads) continue;
      const std::string source = content_of(entry.path());
      for (auto at = std::sregex_iterator(source.begin(), source.end(), asked); at != std::sregex_iterator(); ++at)
        found.insert((*at)[1].matched ? (*at)[1].str() : (*at)[2].str());
    }
    CHECK(found.size() > 120);
    for (const std::string& name : found) {
      CAPTURE(name);
      CHECK(names.count(name) == 1);
    }
  }

  SECTION("No key that is listed is unknown to its reader, and a misspelt one is") {
    for (const ProblemTable& table : tables())
      for (const ProblemTableKind& kind : table.kinds)
        for (const ProblemKey& key : kind.keys) {
          if (key.name == "*" || key.name == "kind") continue;
          if (table.path == "axis" && key.name == "mechanism") continue;
          for (const std::string& name : {key.name, key.name + "x"}) {
            const std::string text = head_of(table.path, kind.name) + "\"" + name + "\" = 1\n";
            text::Diagnostics diagnostics;
            const auto document = text::read_toml(text::SourceText::from_string("a.toml", text), diagnostics);
            CAPTURE(text);
            REQUIRE(document);
            (void)problem_of(*document, diagnostics);
            const bool unknown =
                text::format(diagnostics).find(fmt::format("unknown key '{}'", name)) != std::string::npos;
            CHECK(unknown == (name != key.name));
          }
        }
  }

  // By hand, from the readers.
  SECTION("What is told of some keys") {
    const ProblemKey* stroke = find_key("axis", axis_that_goes, "stroke");
    REQUIRE(stroke != nullptr);
    CHECK(stroke->required);
    CHECK(stroke->forms.at(0).unit == "mm");
    CHECK(stroke->forms.at(0).above_least);
    CHECK(find_key("axis", axis_that_turns, "stroke")->forms.at(0).unit == "rad");
    CHECK(find_key("axis", axis_that_turns, "guide") == nullptr);
    CHECK_FALSE(find_key("axis", axis_that_goes, "moves")->required);  // [[moves]] may do for it
    CHECK(find_key("axis.mechanism", "belt", "ends") == nullptr);
    CHECK(find_key("axis.mechanism", "screw", "ends")->forms.at(0).fallback == "fixed-supported");
    CHECK(find_key("axis.mechanism", "rotary", "drives") == nullptr);
    CHECK(find_key("axis.mechanism", "belt", "efficiency")->forms.at(0).fallback == "0.95");
    CHECK(find_key("axis.mechanism", "screw", "nut_inertia") != nullptr);
    CHECK(find_key("axis.members", "bolts", "material") == nullptr);
    CHECK(find_key("axis.members", "shaft", "notch_factor") != nullptr);
    CHECK(find_key("axis.members", "beam", "notch_factor") == nullptr);
    CHECK(find_key("axis.require", axis_that_turns, "position_error") == nullptr);
    CHECK(find_key("axis.require", axis_that_goes, "angle_error") == nullptr);
    // Defaults that hang on other keys are none; nor is what stands for a missing value that must be there.
    CHECK(find_key("axis.mechanism", "screw", "load_share")->forms.at(0).fallback.empty());
    CHECK(find_key("axis.guide", "", "rails")->forms.at(0).fallback.empty());
    CHECK(find_key("axis.mechanism", "screw", "nut_inertia")->forms.at(0).fallback.empty());
    CHECK(find_key("axis.mechanism", "screw", "preload")->forms.at(0).fallback == "0");
    const ProblemKey* life = find_key("require", "", "life");
    REQUIRE(life != nullptr);
    CHECK(life->forms.at(0).fallback == "\"10000 h\"");
    CHECK(life->forms.at(0).source == "iso3408_5");
    CHECK(find_key("axis.motor", "", "microsteps")->forms.at(0).most == 256.0);
  }
}

}  // namespace
}  // namespace millwright::machine::problem_keys_test
