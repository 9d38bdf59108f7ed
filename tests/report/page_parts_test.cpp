// SPDX-License-Identifier: Apache-2.0
// What pages are made of: escaping, units, mathematics, texts.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "catch.h"
#include "evaluation/declared_constraints.h"
#include "machine/bill_of_materials.h"
#include "machine/requirement.h"
#include "report/html.h"
#include "report/mathml.h"
#include "report/page_texts.h"

namespace millwright::report::page_parts_test {
namespace {

using scalar::Traced;
using scalar::Unit;

Traced figure(const char* symbol, double si, const char* unit) { return Traced::leaf(symbol, si, Unit::of(unit)); }

/// Text without tags and without the blanks between number and unit.
std::string plain(const std::string& mathml) {
  std::string text;
  bool inside = false;
  for (const char c : mathml) {
    if (c == '<') inside = true;
    if (!inside) text += c;
    if (c == '>') inside = false;
  }
  return text;
}

TEST_CASE("Text is escaped for content and attributes, and what is no text is replaced") {
  CHECK(escaped("a<b>&\"'c") == "a&lt;b&gt;&amp;&quot;&#39;c");
  CHECK(escaped("µm ≤ 5 mm²") == "µm ≤ 5 mm²");
  CHECK(escaped("a\tb\nc") == "a\tb\nc");
  CHECK(escaped(std::string("a\0b", 3)) ==
        "a\xef\xbf\xbd"
        "b");
  CHECK(escaped("\x1b[31m") == "\xef\xbf\xbd[31m");
  CHECK(escaped("\xff<") == "\xef\xbf\xbd&lt;");
  // A byte that begins a character must not swallow the markup behind it.
  CHECK(escaped("\xe2<b>").find('<') == std::string::npos);
  CHECK(escaped("\xf0\x9f<b>").find('<') == std::string::npos);
  CHECK(escaped("\xc0\xbc").find('<') == std::string::npos);  // '<' in two bytes, which is not allowed
}

TEST_CASE("JSON in a script cannot end it") {
  CHECK(json_in_script("{\"a\":\"</script><!--\"}") == "{\"a\":\"\\u003c/script>\\u003c!--\"}");
  CHECK(json_in_script("\"\xe2\x80\xa8\"") == "\"\\u2028\"");
}

TEST_CASE("Identifiers are one word, and different names stay different") {
  CHECK(identifier("C-ST-80") == "C-ST-80");
  CHECK(identifier("a b") != identifier("a_b"));
  CHECK(identifier("\"><x").find_first_of("\"<> ") == std::string::npos);
}

TEST_CASE("Units are printed as engineers write them") {
  CHECK(shown_unit("1").empty());
  CHECK(shown_unit("kg.cm2") == "kg·cm²");
  CHECK(shown_unit("N/mm^2") == "N/mm²");
  CHECK(shown_unit("um") == "µm");
  CHECK(shown_unit("um/kN") == "µm/kN");
  CHECK(shown_unit("deg") == "°");
  CHECK(shown_unit("ohm") == "Ω");
  CHECK(shown_unit("rad/(N.m)") == "rad/(N·m)");
  CHECK(shown_unit("USD") == "USD");
  CHECK(shown_quantity(2.0, "mm") == "2\u202fmm");
  CHECK(shown_quantity(std::nan(""), "mm") == "–");
}

// 80 N on a rod of 10 mm: 4 · 80/(π · 0.01²) = 1.0186 MPa.
TEST_CASE("A formula stands in symbols, in numbers, and with its value") {
  const Traced force = figure("F", 80.0, "N");
  const Traced diameter = figure("d_1", 0.01, "mm");
  const Traced stress = 4.0 * force / (scalar::pi<Traced>() * square(diameter));
  MathPrinter printer;
  printer.add(stress, 1.0186, "MPa");
  const auto lines = printer.lines(0);
  REQUIRE(lines.size() == 1);
  CHECK(lines[0].expression.find("<mfrac>") != std::string::npos);
  CHECK(lines[0].expression.find("<msub><mi>d</mi>") != std::string::npos);
  CHECK(plain(lines[0].expression) == "4·Fπ·d12");
  CHECK(plain(lines[0].substituted) == "4·80Nπ·(10mm)2");
  CHECK(plain(lines[0].value) == "1.019MPa");
  CHECK(printer.uses("F"));
  CHECK(printer.uses("d_1"));
  CHECK_FALSE(printer.uses("E"));
}

TEST_CASE("A figure that is the result itself is not rounded once more") {
  MathPrinter printer;
  printer.add(figure("L_r", 1.2475, "mm"), 1247.5, "mm");
  const MathLine line = printer.lines(0).front();
  CHECK(plain(line.expression) == "Lr");
  CHECK(line.substituted.empty());
  CHECK(plain(line.value) == "1247.5mm");
}

TEST_CASE("What changes nothing is left out") {
  const Traced x = figure("x", 0.002, "mm");
  const Traced nothing = scalar::in_unit<Traced>(0.0, scalar::dimension::length);
  for (const Traced& same : {Traced(x + nothing),
                             Traced(nothing + x),
                             Traced(x - nothing),
                             Traced(x * 1.0),
                             Traced(1.0 * x),
                             Traced(x / 1.0)}) {
    MathPrinter printer;
    printer.add(same, 2.0, "mm");
    CHECK(plain(printer.lines(0).front().expression) == "x");
  }
  MathPrinter printer;
  printer.add(nothing - x, -2.0, "mm");
  CHECK(plain(printer.lines(0).front().expression) == "0mm−x");
  MathPrinter rounded;
  const Traced watt = scalar::in_unit<Traced>(1.0, scalar::dimension::power_output);
  rounded.add(scalar::up_to_whole(figure("P", 59.7, "W"), watt), 60.0, "W");
  CHECK(plain(rounded.lines(0).front().expression) == "(−⌊−P1W⌋)·1W");
}

TEST_CASE("What two results share is one line of both, what one needs stands with it") {
  const Traced a = figure("a", 3.0, "mm");
  const Traced shared = named("S", a + a);
  const Traced own = named("O", shared * 2.0);
  MathPrinter printer;
  printer.add(own + a, 15000.0, "mm");
  printer.add(shared - a, 3000.0, "mm");
  REQUIRE(printer.shared().size() == 1);
  CHECK(plain(printer.shared()[0].symbol) == "S");
  const auto first = printer.lines(0);
  REQUIRE(first.size() == 2);
  CHECK(plain(first[0].symbol) == "O");
  CHECK(plain(first[0].expression) == "S·2");
  CHECK(plain(first[1].expression) == "O+a");
  REQUIRE(printer.lines(1).size() == 1);
}

TEST_CASE("A result that its formula named is the last line, and two quantities of one name are told apart") {
  const Traced a = figure("a", 3.0, "m");
  const Traced b = figure("b", 4.0, "m");
  MathPrinter printer;
  printer.add(named("T", a * 2.0), 6.0, "m");
  printer.add(named("T", b * 2.0) + a, 11.0, "m");
  REQUIRE(printer.lines(0).size() == 1);
  CHECK(plain(printer.lines(0)[0].expression) == "a·2");
  const auto second = printer.lines(1);
  REQUIRE(second.size() == 2);
  CHECK(plain(second[0].symbol) == "T2");
  CHECK(plain(second[1].expression) == "T2+a");
}

TEST_CASE("An intermediate result called f counts per second") {
  MathPrinter printer;
  printer.add(named("f_n", figure("ω", 300.0, "rad/s") / 6.0) + figure("f_0", 1.0, "Hz"), 51.0, "Hz");
  CHECK(plain(printer.lines(0)[0].value) == "50Hz");
  MathPrinter turning;
  turning.add(named("ω_1", figure("ω", 300.0, "rad/s") / 6.0) + figure("ω_0", 1.0, "rad/s"), 51.0, "rad/s");
  CHECK(plain(turning.lines(0)[0].value) == "50rad/s");
}

TEST_CASE("Long formulas are broken into lines that fit the paper") {
  Traced sum = figure("x_0", 1.0, "m");
  for (int i = 1; i < 60; ++i) sum = sum + square(figure(("x_" + std::to_string(i)).c_str(), i, "m")) / sum;
  MathPrinter printer;
  printer.add(sum, 1.0, "m");
  for (const MathLine& line : printer.lines(0)) CHECK(plain(line.substituted).size() < 140);
}

TEST_CASE("Every text is there in each language, once, with the same gaps to fill") {
  std::set<std::string_view> keys;
  for (const PageText& text : page_texts()) {
    INFO(text.key);
    CHECK(keys.insert(text.key).second);
    CHECK_FALSE(text.english.empty());
    CHECK_FALSE(text.indonesian.empty());
    const auto gaps = [](std::string_view words) { return std::count(words.begin(), words.end(), '{'); };
    CHECK(gaps(text.english) == gaps(text.indonesian));
  }
  for (const std::string& each : language_codes()) CHECK(code(*language_of(each)) == each);
  CHECK_FALSE(language_of("xx"));
  CHECK_THROWS_AS(Texts(Language::english)("no such text"), std::logic_error);
}

TEST_CASE("Every title of a constraint is there in Indonesian, and every saying once") {
  std::set<std::string_view> known;
  for (const Saying& saying : sayings()) {
    INFO(saying.english);
    CHECK(known.insert(saying.english).second);
    CHECK_FALSE(saying.indonesian.empty());
    CHECK(saying.indonesian != saying.english);
    const auto gaps = [](std::string_view words) { return std::count(words.begin(), words.end(), '{'); };
    CHECK(gaps(saying.english) == gaps(saying.indonesian));
  }
  for (const DeclaringElement& element : declaring_elements())
    for (const machine::Declaration& declaration : element.constraints) {
      CAPTURE(element.name, declaration.id, declaration.title);
      CHECK(known.count(declaration.title) == 1);
    }
}

TEST_CASE("What requirements and given figures mean is there in Indonesian, once") {
  std::set<std::string> known;
  for (const Saying& meaning : meanings()) {
    INFO(meaning.english);
    CHECK(known.insert(std::string(meaning.english)).second);
    CHECK_FALSE(meaning.indonesian.empty());
    CHECK(meaning.indonesian != meaning.english);
  }
  std::set<std::string> used;
  for (const machine::RequirementDeclaration& requirement : machine::requirements())
    used.insert(std::string(requirement.meaning));
  // As they are written where figures get their names: {"d_3", "root diameter of the screw", "mm"}.
  const std::regex name("\\{[^{},]*,\\s*\"([^\"]+)\",\\s*\"[^\"]*\"\\}");
  std::size_t figures = 0;
  for (const auto& file : std::filesystem::directory_iterator(MILLWRIGHT_SOURCE_DIR "/src/evaluation")) {
    if (file.path().filename().string().rfind("traced_", 0) != 0) continue;
    std::ifstream stream(file.path());
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    for (std::sregex_iterator each(text.begin(), text.end(), name), end; each != end; ++each, ++figures)
      used.insert((*each)[1]);
  }
  CHECK(figures > 100);
  for (const std::string& each : used) {
    INFO(each);
    CHECK(known.count(each) == 1);
  }
  for (const std::string& each : known) {
    INFO(each << " is used nowhere");
    CHECK(used.count(each) == 1);
  }
}

TEST_CASE("Slots have a name in Indonesian, members keep theirs") {
  const Texts id(Language::indonesian), en(Language::english);
  CHECK(id.slot("support_fixed") == "tumpuan tetap");
  CHECK(en.slot("support_fixed") == "support_fixed");
  CHECK(id.slot("my portal") == "my portal");
  CHECK(id.axis("machine") == "Mesin");
  CHECK(id.axis("x") == "x");
  machine::Axis screw, belt, rack;
  belt.mechanism.kind = machine::MechanismKind::belt;
  rack.mechanism.kind = machine::MechanismKind::rack;
  std::set<std::string> keys;
  for (const PageText& text : page_texts()) keys.insert(std::string(text.key));
  for (const machine::Axis* axis : {&screw, &belt, &rack})
    for (const std::string& slot : machine::slot_names(*axis)) {
      INFO(slot);
      CHECK(keys.count("slot." + slot) == 1);
    }
}

TEST_CASE("Phases are there in Indonesian, the names of moves stay") {
  const Texts t(Language::indonesian);
  CHECK(t.worst("plunge up, accelerate at 79 %; nut farthest from the fixed bearing") ==
        "plunge naik, percepatan pada 79 %; mur terjauh dari bantalan tetap");
  CHECK(t.worst("lead, cruise") == "lead, laju tetap");  // a move that is called so
  CHECK(t.worst("move 2, from 1.5 s") == "gerak 2, mulai 1.5 s");
  CHECK(t.worst("standstill") == "diam");
  CHECK(Texts(Language::english).worst("plunge up, accelerate") == "plunge up, accelerate");
}

TEST_CASE("Sayings keep their numbers, and clauses their order") {
  const Texts id(Language::indonesian), en(Language::english);
  const std::string method =
      "stage by stage, with the designs of a stage found once for all labels; started from the "
      "objective found, 153.651433, Ipopt ends at 153.6 and NLopt SLSQP ends at 1.5e+02; unheard";
  CHECK(en.clauses(method) == method);
  CHECK(id.clauses(method) ==
        "tahap demi tahap, dengan rancangan tiap tahap dicari sekali untuk semua label; dimulai dari tujuan yang "
        "ditemukan, 153.651433, Ipopt berakhir pada 153.6 dan NLopt SLSQP berakhir pada 1.5e+02; unheard");
  CHECK(id.said("Load torque, 80 % rule") == "Torsi beban, aturan 80 %");
  CHECK(id.said("torque of the published curve at 852.3 rpm") == "torsi kurva terbitan pada 852.3 rpm");
}

}  // namespace
}  // namespace millwright::report::page_parts_test
