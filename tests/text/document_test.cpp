// SPDX-License-Identifier: Apache-2.0
#include "text/document.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "catch.h"

namespace document_test {

using namespace millwright::text;

namespace {

using Words = std::vector<std::string>;
using Reader = std::optional<Document> (*)(const std::shared_ptr<const SourceText>&, Diagnostics&);

Document read_clean(Reader reader, const std::string& contents) {
  Diagnostics diagnostics;
  auto document = reader(SourceText::from_string("d", contents), diagnostics);
  INFO(contents << format(diagnostics));
  REQUIRE(document);
  CHECK(diagnostics.count() == 0);
  return *document;
}

/// "line:column message | hint" of each diagnostic.
Words errors(Reader reader, const std::string& contents) {
  Diagnostics diagnostics;
  reader(SourceText::from_string("d", contents), diagnostics);
  Words result;
  for (const Diagnostic& d : diagnostics.all()) {
    result.push_back(std::to_string(d.where.line) + ":" + std::to_string(d.where.column) + " " + d.message +
                     (d.hint.empty() ? "" : " | " + d.hint));
  }
  return result;
}

std::string place(const SourceSpan& span) {
  return std::to_string(span.line) + ":" + std::to_string(span.column) + "+" + std::to_string(span.length);
}

std::string first(Reader reader, const std::string& contents) {
  const Words found = errors(reader, contents);
  REQUIRE(found.size() == 1);
  return found[0];
}

/// The tree as JSON, for comparison with another reader.
nlohmann::json as_json(const Node& node) {
  switch (node.kind()) {
    case NodeKind::table: {
      nlohmann::json object = nlohmann::json::object();
      for (const TableEntry& entry : node.entries()) object[entry.key] = as_json(entry.value);
      return object;
    }
    case NodeKind::array: {
      nlohmann::json array = nlohmann::json::array();
      for (const Node& item : node.items()) array.push_back(as_json(item));
      return array;
    }
    case NodeKind::integer:
      return *node.as_integer();
    case NodeKind::number:
      return *node.as_number();
    case NodeKind::boolean:
      return *node.as_boolean();
    case NodeKind::string:
      return *node.as_string();
    case NodeKind::date:
      return *node.as_date();
  }
  return nullptr;
}

}  // namespace

TEST_CASE("every TOML value and key knows its place") {
  const Document document = read_clean(read_toml,
                                       "title = \"Sander µ\"   # comment\r\n"
                                       "date = 2026-01-15\r\n"
                                       "[[axis]]\r\n"
                                       "name = 'x'\r\n"
                                       "  mass = 16.5\r\n"
                                       "[[axis.moves]]\r\n"
                                       "time = [\"0.1 s\", \"0.5 s\"]\r\n"
                                       "[axis.require]\r\n"
                                       "life.hours = 20_000\r\n"
                                       "hold = true\r\n");
  const Node& root = document.root();
  REQUIRE(root.is_table());
  Words keys;
  for (const TableEntry& entry : root.entries()) keys.push_back(entry.key);
  CHECK(keys == Words{"title", "date", "axis"});
  CHECK(root.find("title")->as_string() == "Sander µ");
  CHECK(place(root.find("title")->span()) == "1:9+10");
  CHECK(place(root.find("title")->part_span(7, 2)) == "1:17+1");
  CHECK(root.find("date")->as_date() == "2026-01-15");
  CHECK(place(root.find("date")->span()) == "2:8+10");
  REQUIRE(root.find("axis")->is_array());
  const Node& axis = root.find("axis")->at(0);
  CHECK(axis.span().line == 3);
  CHECK(axis.find("name")->as_string() == "x");
  CHECK(axis.find("mass")->as_number() == 16.5);
  CHECK_FALSE(axis.find("mass")->as_integer());
  CHECK(place(axis.key_span("mass")) == "5:3+4");
  CHECK(place(axis.find("moves")->at(0).find("time")->at(1).span()) == "7:18+7");
  const Node& require = *axis.find("require");
  CHECK(require.find("life")->find("hours")->as_integer() == 20000);
  CHECK(require.find("life")->find("hours")->as_number() == 20000.0);
  CHECK(place(require.find("life")->key_span("hours")) == "9:6+5");
  CHECK(require.find("hold")->as_boolean() == true);
  CHECK(axis.find("colour") == nullptr);
  CHECK(axis.find("name")->find("x") == nullptr);
  CHECK_THROWS_AS(root.find("axis")->at(1), std::out_of_range);
}

TEST_CASE("TOML errors stand at their place, with a hint") {
  CHECK(first(read_toml, "a = 1\nlonger = 3\nlonger = 2\n") ==
        "3:1 TOML: key-value pair: cannot redefine existing integer 'longer' | a key or table stands once; lists of "
        "tables are "
        "written [[name]]");
  CHECK(
      first(read_toml, "v = 20 mm/s\n") ==
      "1:8 TOML: key-value pair: expected a comment or whitespace, saw 'm' | text and quantities with a unit stand in "
      "quotes: \"20 mm/s\"");
  CHECK(first(read_toml, "v = 1,5\n").find("decimals are written with a point") != std::string::npos);
  CHECK(first(read_toml, "v = \"20 mm\nw = 1\n").find("is a closing quote missing in this line?") != std::string::npos);
  for (const char* text : {"fast", "tight", "infinite", "0.05s", "20 %", "-x", "0O5", "NEMA23", "1 000"}) {
    const std::string value = text;
    INFO(value);
    CHECK(first(read_toml, "v = " + value + " # why\n").find("stand in quotes: \"" + value + "\"") !=
          std::string::npos);
  }
  CHECK(first(read_toml, "v = .5\n").find("a digit before and behind it") != std::string::npos);
  CHECK(first(read_toml, "x = 1\nv = \n").substr(0, 4) == "2:5 ");
  CHECK(first(read_toml, "x = 1\n\nµ = 1\n").substr(0, 4) == "3:1 ");
  CHECK(first(read_toml, "[axis\n").substr(0, 4) == "1:6 ");
  CHECK(first(read_toml, "x = [1,\n 2").substr(0, 2) == "2:");
  CHECK(first(read_toml, "[ =").substr(0, 2) == "1:");
  CHECK(first(read_toml, "x = nan\n") ==
        "1:5 not a finite number | leave the key out where a value is missing or without limit");
  CHECK(first(read_toml, "x = {y = [-inf]}\n").substr(0, 5) == "1:11 ");
  CHECK(first(read_toml, std::string("x = \"\0\"\n", 8)) == "1:6 NUL byte | remove it");
  CHECK(first(read_toml, "x = \"\xE9\"\n").substr(0, 5) == "1:6 b");
  CHECK(errors(read_toml, std::string(100000, '[')).size() == 1);
  CHECK(errors(read_toml, "a = " + std::string(100000, '[')).size() == 1);
  CHECK(errors(read_toml, "a = " + std::string(1000000, '9')).size() == 1);
}

TEST_CASE("a complaint about the end of a TOML text stands in its last line") {
  for (const char* contents : {"a = [[\n", "a = [[", "a = [\r\n", "x = [\n\n", "x = \"\"\"\n", "a = {\n"}) {
    Diagnostics diagnostics;
    const auto text = SourceText::from_string("d", contents);
    CHECK_FALSE(read_toml(text, diagnostics));
    REQUIRE(diagnostics.error_count() == 1);
    const SourceSpan where = diagnostics.all()[0].where;
    INFO(contents << where.line << ":" << where.column);
    CHECK(where.line <= text->line_count() + 1);
    CHECK(where.column <= static_cast<int>(text->line(where.line).size()) + 1);
  }
}

TEST_CASE("a TOML key with thousands of parts is refused, not fatal") {
  const auto key = [](std::size_t parts) {
    std::string all = "a";
    for (std::size_t i = 1; i < parts; ++i) all += i % 3 == 0 ? " . \"b.c\"" : i % 3 == 1 ? ".'d'" : ".e-1";
    return all;
  };
  const std::string many = " TOML: a key of more than 8 parts";
  CHECK(first(read_toml, key(9) + " = 1\n") == "1:1" + many);
  CHECK(first(read_toml, key(100000) + " = 1\n") == "1:1" + many);
  CHECK(first(read_toml, "[x]\n[" + key(50000) + "]\n") == "2:2" + many);
  CHECK(first(read_toml, "[[" + key(50000) + "]]\n") == "1:3" + many);
  CHECK(first(read_toml, "x = [1, { " + key(50000) + " = 1 }]\n") == "1:11" + many);
  CHECK(first(read_toml, "x = '''\n''' # \"\n" + key(50000) + " = 1\n") == "3:1" + many);
  CHECK(first(read_toml, "x = \"\\\"\"\n" + key(50000) + " = 1\n") == "2:1" + many);
  // As deep as it goes.
  std::string deep = "x = ";
  for (int i = 0; i < 250; ++i) deep += "{" + key(8) + " = ";
  read_clean(read_toml, deep + "1" + std::string(250, '}') + "\n");
  // What is no key.
  std::string dots = "1";
  for (int i = 0; i < 100; ++i) dots += ".1";
  std::string numbers = "1.5";
  for (int i = 0; i < 100; ++i) numbers += ", 2.5";
  read_clean(read_toml,
             "# " + dots + "\nx = '" + dots + "'\ny = \"\\\"" + dots + "\"\nz = '''\n'" + dots + "'''\nw = [" +
                 numbers + "]\n");
  std::string lines;
  for (int i = 0; i < 40; ++i) lines += "k" + std::to_string(i) + ".a = 1\n";
  read_clean(read_toml, lines);
}

TEST_CASE("every JSON value and key knows its place") {
  const Document document = read_clean(read_json,
                                       "\xEF\xBB\xBF{\n"
                                       "\t\"title\": \"µ \\u20AC\\ud83d\\ude00\\n\", \"n\": -12,\r\n"
                                       "  \"axis\": [{\"x\": 1.5e3}, [], {}, true, false]\n"
                                       "}\n");
  const Node& root = document.root();
  CHECK(place(root.span()) == "1:1+1");
  CHECK(root.find("title")->as_string() == "µ €😀\n");
  CHECK(place(root.key_span("title")) == "2:2+7");
  CHECK(place(root.find("title")->span()) == "2:11+24");
  CHECK(root.find("n")->as_integer() == -12);
  CHECK(place(root.find("n")->span()) == "2:42+3");
  const Node& axis = *root.find("axis");
  REQUIRE(axis.size() == 5);
  CHECK(place(axis.span()) == "3:11+35");
  CHECK(axis.at(0).find("x")->as_number() == 1500);
  CHECK(place(axis.at(0).find("x")->span()) == "3:18+5");
  CHECK(axis.at(4).as_boolean() == false);
  CHECK(place(axis.at(4).span()) == "3:40+5");
}

TEST_CASE("JSON errors stand at their place, with a hint") {
  CHECK(first(read_json, "{\"a\": 1,\n \"b\": 2,\n \"a\": 3}") == "3:2 JSON: the key 'a' stands twice in this object");
  CHECK(first(read_json, "{\"a\": 1,}") == "1:9 JSON: a key is expected | no comma before the closing bracket");
  CHECK(first(read_json, "{\"a\": [1,]}") == "1:10 JSON: a value is expected | no comma before the closing bracket");
  CHECK(first(read_json, "{a: 1}") == "1:2 JSON: a key is expected | keys stand in double quotes");
  CHECK(first(read_json, "{\"a\": 'x'}") == "1:7 JSON: a value is expected | strings stand in double quotes");
  CHECK(first(read_json, "{\"a\": True}") ==
        "1:7 JSON: 'True' is no value | true and false are written in small letters");
  CHECK(first(read_json, "{\"a\": NaN}") == "1:7 JSON: 'NaN' is no value | text stands in double quotes");
  CHECK(first(read_json, "{\"µ\": null}") == "1:7 null has no meaning here | leave the key out");
  CHECK(first(read_json, "{\"a\": 20 mm}") == "1:10 JSON: ',' or '}' is expected");
  CHECK(first(read_json, "{\"a\": 20mm}") == "1:9 JSON: a number ends here | quantities stand in quotes");
  CHECK(first(read_json, "// x\n{}") == "1:1 JSON: a value is expected | JSON has no comments; TOML has");
  CHECK(first(read_json, "{\n\"a\": [1, 2\n") == "2:6 JSON: '[' is never closed");
  CHECK(first(read_json, "{\"a\": \"x\n\"}") == "1:7 JSON: the string is not closed in its line");
  CHECK(first(read_json, "{\"a\": \"\\ud800\"}") == "1:8 JSON: half of a surrogate pair");
  CHECK(first(read_json, "{\"a\": \"\\x\"}").substr(0, 4) == "1:8 ");
  CHECK(first(read_json, "{\"a\": 01}") == "1:7 JSON: a number with a leading zero");
  CHECK(first(read_json, "{\"a\": 1e999}") == "1:7 JSON: too large or too small for a number");
  CHECK(first(read_json, "{} x") == "1:4 JSON: text after the end of the value | a file holds one object");
  CHECK(first(read_json, "[1]") == "1:1 JSON: an object in braces is expected outermost");
  CHECK(first(read_json, "") == "1:1 JSON: the text ends where a value is expected");
  // A carriage return that ends a line or the text has no column of its own; one within a line has.
  CHECK(first(read_json, "{\"\":\r") == "1:5 JSON: the text ends where a value is expected");
  CHECK(first(read_json, "[\r\n,]") == "2:1 JSON: a value is expected | one comma too many");
  CHECK(first(read_json, "[\r,]") == "1:3 JSON: a value is expected | one comma too many");
  CHECK(first(read_json, "{\"a\": " + std::string(1000000, '[')) == "1:262 JSON: nested more than 256 levels deep");
  Diagnostics deep;
  CHECK(read_json(SourceText::from_string("d", "{\"a\":" + std::string(255, '[') + std::string(255, ']') + "}"), deep));
}

TEST_CASE("a wide JSON line is read in linear time") {
  std::string text = "{\"a\": [";
  for (int i = 0; i < 300000; ++i) text += "1,";
  const Document document = read_clean(read_json, text + "2]}");
  CHECK(document.root().find("a")->size() == 300001);
  CHECK(document.root().find("a")->at(300000).span().column == 7 + 600000 + 1);
}

TEST_CASE("JSON is accepted and understood as another reader does") {
  std::mt19937 generator(3);
  const Words pieces = {"{",
                        "}",
                        "[",
                        "]",
                        ",",
                        ":",
                        "\"a\"",
                        "\"b\\n\"",
                        "1",
                        "-0.5e2",
                        "true",
                        "false",
                        " ",
                        "\n",
                        "\"\\u00b5\"",
                        "0",
                        "."};
  int accepted = 0;
  for (int round = 0; round < 60000; ++round) {
    std::string text = "{\"k\":";
    for (auto n = 1 + generator() % 7; n > 0; --n) text += pieces[generator() % pieces.size()];
    text += "}";
    Diagnostics diagnostics;
    const auto document = read_json(SourceText::from_string("d", text), diagnostics);
    const nlohmann::json other = nlohmann::json::parse(text, nullptr, false);
    const bool duplicates = document && diagnostics.has_errors();
    if (duplicates) continue;
    INFO(text << format(diagnostics));
    REQUIRE(document.has_value() == (!other.is_discarded() && other.is_object()));
    if (!document) continue;
    ++accepted;
    REQUIRE(as_json(document->root()) == other);
  }
  CHECK(accepted > 1000);
}

TEST_CASE("TOML and JSON of the same content give the same tree") {
  const Document toml = read_clean(read_toml, "a = 1\nb = [1.5, \"x\", {c = true}]\n[d.e]\nf = \"g\"\n");
  const Document json = read_clean(read_json, R"({"a":1,"b":[1.5,"x",{"c":true}],"d":{"e":{"f":"g"}}})");
  CHECK(as_json(toml.root()) == as_json(json.root()));
}

TEST_CASE("random bytes never crash a reader, and each failure says where") {
  std::mt19937 generator(13);
  const std::string letters = "[]{}=\"'.,#\n\r\t -_aexntf019:\\u\xC2\xB5\xE2\x82\xAC\xFF\0+TZ";
  for (int round = 0; round < 20000; ++round) {
    std::string text;
    for (auto n = generator() % 30; n > 0; --n) text += letters[generator() % letters.size()];
    for (const Reader reader : {read_toml, read_json}) {
      Diagnostics diagnostics;
      const auto document = reader(SourceText::from_string("d", text), diagnostics);
      REQUIRE((document.has_value() || diagnostics.has_errors()));
      if (document) CHECK(document->root().is_table());
      CHECK((diagnostics.count() == 0 || !format(diagnostics).empty()));
    }
  }
}

TEST_CASE("files are read by their ending") {
  std::string name = (std::filesystem::temp_directory_path() / "millwright_document_XXXXXX").string();
  REQUIRE(::mkdtemp(name.data()) != nullptr);
  const auto write = [&](const std::string& file, const std::string& contents) {
    std::ofstream(name + "/" + file) << contents;
    return name + "/" + file;
  };
  Diagnostics diagnostics;
  CHECK(read_document(write("p.toml", "a = 1\n"), diagnostics)->root().find("a")->as_integer() == 1);
  CHECK(read_document(write("p.json", "{\"a\": 2}"), diagnostics)->root().find("a")->as_integer() == 2);
  CHECK(read_document(write("empty.toml", ""), diagnostics)->root().size() == 0);
  CHECK(diagnostics.count() == 0);
  const auto controls = [&](const std::string& contents) {
    Diagnostics found;
    read_document(write("c.toml", contents), found);
    Words words;
    for (const Diagnostic& each : found.all())
      words.push_back(std::to_string(each.where.line) + ":" + std::to_string(each.where.column) + " " + each.message);
    return words;
  };
  CHECK(controls("a = \"one\\u001B[31m\"\n\"b\\u0007\" = [\"\\t\", \"\\u007F\"]\n") ==
        Words{"1:5 a control character (\\x1B) in a text",
              "2:1 a control character (\\x07) in a text",
              "2:20 a control character (\\x7F) in a text"});
  CHECK(controls("a = \"\\u009B31m\"\nb = \"over\\rwritten\"\n").size() == 2);
  CHECK(controls("c = \"\\u00A0 \\u00e9 \\n\\r\\n\"\n").empty());
  CHECK_FALSE(read_document(name + "/none.toml", diagnostics));
  CHECK_FALSE(read_document(name, diagnostics));
  CHECK(diagnostics.error_count() == 2);
  std::filesystem::remove_all(name);
}

}  // namespace document_test
