// SPDX-License-Identifier: Apache-2.0
// `--report`: the page says what the JSON says, stands alone, and takes hostile names for what they are.
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>

#include "app/program.h"
#include "catch.h"

namespace millwright::app::report_page_test {
namespace {

using Json = nlohmann::json;

/// As a browser would read the text between tags.
std::string unescaped(std::string text) {
  const std::pair<const char*, const char*> entities[] = {
      {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&#39;", "'"}, {"&amp;", "&"}};
  for (const auto& [from, to] : entities)
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + 1))
      text.replace(at, std::string(from).size(), to);
  return text;
}

/// What stands between `from` and the next `to`, both left out; empty if there is none.
std::string between(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t begin = text.find(from);
  if (begin == std::string::npos) return {};
  const std::size_t end = text.find(to, begin + from.size());
  return text.substr(begin + from.size(), end - begin - from.size());
}

/// The page without style, scripts and data: what is read.
std::string visible(const std::string& page) {
  const std::string body = page.substr(page.find("<body>"));
  return body.substr(0, body.find("<script"));
}

std::string without_tags(const std::string& html) {
  std::string text;
  bool inside = false;
  for (const char c : html) {
    if (c == '<') inside = true;
    if (!inside) text += c;
    if (c == '>') inside = false;
  }
  return unescaped(text);
}

Json data_of(const std::string& page, const std::string& id) {
  return Json::parse(between(page, "<script type=\"application/json\" id=\"" + id + "\">", "</script>"));
}

bool is_near(double shown, double exact, double tolerance) {
  return std::abs(shown - exact) <= tolerance * std::max(std::abs(exact), 1e-300);
}

/// The first number in a text, as it is typeset: "1.2·10⁻⁷" with a raised exponent behind ten, "−" for minus.
double number_in(const std::string& mathml) {
  const bool negative = mathml.find("<mo>−</mo>") < mathml.find("<mn>");
  double value = std::stod(between(mathml, "<mn>", "</mn>"));
  const std::string exponent = between(mathml, "<msup><mn>10</mn>", "</msup>");
  if (!exponent.empty()) {
    const double power = std::stod(between(exponent, "<mn>", "</mn>"));
    const double ten = std::pow(10.0, exponent.find("−") == std::string::npos ? power : -power);
    value = mathml.find("<msup><mn>10</mn>") < mathml.find("<mn>") ? ten : value * ten;
  }
  return negative ? -value : value;
}

/// The article of a check's calculation.
std::string calculation(const std::string& page, const Json& check) {
  const auto word = [&](const char* key) { return check.at(key).get<std::string>(); };
  return between(
      page,
      "<article class=\"calculation\" id=\"calc-" + word("axis") + "-" + word("element") + "-" + word("id") + "\">",
      "</article>");
}

/// The values of the lines with results: both sides of a check.
std::vector<double> results(const std::string& article) {
  std::vector<double> values;
  const std::string mark = "<div class=\"line result\">";
  for (std::size_t at = article.find(mark); at != std::string::npos; at = article.find(mark, at + 1)) {
    const std::string value = between(article.substr(at), "<span class=\"value\">", "</span>");
    values.push_back(value.find("<mn>") == std::string::npos ? std::nan("") : number_in(value));
  }
  return values;
}

void expect_checks(const std::string& page, const Json& result) {
  const std::string text = without_tags(visible(page));
  CHECK_FALSE(result.at("checks").empty());
  for (const Json& check : result.at("checks")) {
    CAPTURE(check.dump());
    const std::string article = calculation(page, check);
    REQUIRE_FALSE(article.empty());
    const std::string words = without_tags(article);
    CHECK(words.find(check.at("title").get<std::string>()) != std::string::npos);
    CHECK(words.find(check.at("source").get<std::string>()) != std::string::npos);
    const std::vector<double> shown = results(article);
    REQUIRE(shown.size() == 2);
    constexpr double four_digits = 5.1e-4;
    for (const auto& [key, side] : {std::pair{"value", shown[0]}, {"limit", shown[1]}}) {
      if (check.at(key).is_number())
        CHECK(is_near(side, check.at(key).get<double>(), four_digits));
      else
        CHECK(std::isnan(side));
    }
    if (check.at("utilisation").is_number() && check.at("verdict") != "not evaluated") {
      char percent[32];
      std::snprintf(percent, sizeof percent, "%.1f %%", 100.0 * check.at("utilisation").get<double>());
      const bool far = check.at("utilisation").get<double>() > 9.99;
      const bool just_over = std::string(percent) == "100.0 %" && check.at("verdict") == "violated";
      CHECK(words.find(far ? "> 999 %" : just_over ? "> 100 %" : percent) != std::string::npos);
    }
  }
  for (const Json& line : result.at("requirements")) {
    CAPTURE(line.dump());
    CHECK(text.find(line.at("name").get<std::string>()) != std::string::npos);
  }
}

void expect_parts(const std::string& page, const Json& build) {
  const std::string table = between(page, "<table class=\"parts\">", "</table>");
  std::size_t from = 0;
  for (const Json& part : build.at("parts")) {
    CAPTURE(part.dump());
    char price[32];
    std::snprintf(price, sizeof price, "%.2f", part.at("price").get<double>());
    // A row of the table, after those before it within an axis.
    bool found = false;
    for (std::size_t at = table.find("<tr"); at != std::string::npos && !found; at = table.find("<tr", at + 1)) {
      const std::string row = without_tags(table.substr(at, table.find("</tr>", at) - at));
      found = row.find(part.at("part_number").get<std::string>()) != std::string::npos &&
              row.find(part.at("manufacturer").get<std::string>()) != std::string::npos &&
              row.find(part.at("slot").get<std::string>()) != std::string::npos && row.find(price) != std::string::npos;
    }
    CHECK(found);
    ++from;
  }
  CHECK(from > 0);
}

/// Nothing is loaded: no address stands where a browser would fetch it.
void expect_alone(const std::string& page) {
  CHECK(page.find("default-src 'none'") != std::string::npos);
  const std::string body = visible(page);
  for (const char* loads : {"<link", "<img", "<iframe", "<object", "<embed", "<script src", "@import", "url(http"})
    CHECK(page.substr(0, page.find("<script")).find(loads) == std::string::npos);
  for (const char* attribute : {"src", "href", "data", "action"})
    for (const char* address : {"=\"http:", "=\"https:", "=\"//", "='http", "='//"})
      CHECK(body.find(std::string(attribute) + address) == std::string::npos);
  CHECK(page.find("<script src") == std::string::npos);
}

}  // namespace

TEST_CASE("The page of solve has every check, part and requirement of the JSON, with its numbers") {
  const Workshop shop;
  shop.write("m.toml", one_slide);
  const Outcome outcome = shop.run({"solve", "m.toml", "--report", "r.html", "--json", "r.json"});
  CAPTURE(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.prints("Cheapest compliant build"));
  const std::string page = shop.read("r.html");
  const Json result = Json::parse(shop.read("r.json"));
  CHECK(page.rfind("<!DOCTYPE html>\n<html lang=\"en\">", 0) == 0);
  CHECK(data_of(page, "result") == result);
  expect_checks(page, result);
  expect_parts(page, result.at("build"));
  expect_alone(page);
  CHECK(shop.entries() == 3);  // no temporary file is left
}

TEST_CASE("The chart data of a drive are those of its checks") {
  const Workshop shop;
  shop.write("m.toml", one_slide);
  REQUIRE(shop.run({"solve", "m.toml", "--report", "r.html", "--json", "r.json"}).exit_code == 0);
  const Json drive = data_of(shop.read("r.html"), "charts").at("axes").at("drives").at(0);
  CHECK(drive.at("axis") == "x");
  CHECK(drive.at("phases").size() == 3);
  double worst = 0.0;
  for (const Json& phase : drive.at("phases")) worst = std::max(worst, phase.at("ratio").get<double>());
  const Json result = Json::parse(shop.read("r.json"));
  for (const Json& check : result.at("checks")) {
    if (check.at("id") != "C-ST-TORQUE") continue;
    CHECK(worst == Approx(check.at("value").get<double>()));
    CHECK(drive.at("margin").get<double>() == Approx(check.at("limit").get<double>()));
  }
  // 200 mm in 20 s, in millimetres.
  CHECK(drive.at("motion").back().at(0).get<double>() == Approx(20.0));
  CHECK(drive.at("motion").back().at(2).get<double>() == Approx(200.0));
}

TEST_CASE("The page of check tells what fails, and that of a front has every build") {
  const Workshop shop;
  shop.write("m.toml", one_slide);
  REQUIRE(shop.run({"solve", "m.toml", "--bom", "b.csv"}).exit_code == 0);
  const Outcome checked = shop.run(
      {"check", "m.toml", "b.csv", "--set", "axis.x.moves[0].force=400 N", "--report", "c.html", "--json", "c.json"});
  REQUIRE(checked.exit_code == 1);
  const std::string page = shop.read("c.html");
  const Json result = Json::parse(shop.read("c.json"));
  CHECK(data_of(page, "result") == result);
  expect_checks(page, result);
  const std::string summary = between(page, "<section id=\"summary\">", "</section>");
  std::size_t failures = 0;
  for (const Json& check : result.at("checks"))
    if (check.at("verdict") == "violated" && check.at("kind") != "soft") {
      ++failures;
      CHECK(summary.find(check.at("id").get<std::string>()) != std::string::npos);
    }
  CHECK(failures > 0);
  CHECK(summary.find("It fails " + std::to_string(failures) + " of " + std::to_string(result.at("checks").size())) !=
        std::string::npos);

  REQUIRE(shop.run({"pareto", "m.toml", "--report", "p.html", "--json", "p.json"}).exit_code == 0);
  const std::string front = shop.read("p.html");
  const Json builds = Json::parse(shop.read("p.json")).at("front");
  const Json drawn = data_of(front, "charts").at("front");
  CHECK(data_of(front, "result").at("front") == builds);
  REQUIRE(drawn.at("builds").size() == builds.size());
  for (std::size_t i = 0; i < builds.size(); ++i) {
    CHECK(front.find("<tr id=\"build-" + std::to_string(i + 1) + "\">") != std::string::npos);
    const Json& build = drawn.at("builds").at(i);
    CHECK(build.at("values").at(0) == builds.at(i).at("objectives").at("cost"));
    CHECK(build.at("values").at(1) == builds.at(i).at("objectives").at("mass"));
    std::size_t changed = 0;
    for (std::size_t k = 0; k < builds.at(i).at("build").at("parts").size(); ++k) {
      const Json& part = builds.at(i).at("build").at("parts").at(k);
      const Json& shown = drawn.at("parts").at(build.at("parts").at(k).get<std::size_t>());
      CHECK(shown.at(1) == part.at("slot"));
      CHECK(shown.at(2).get<std::string>().find(part.at("part_number").get<std::string>()) != std::string::npos);
      if (i > 0 && part.at("part_number") != builds.at(i - 1).at("build").at("parts").at(k).at("part_number")) {
        ++changed;
        bool named = false;
        for (const Json& change : build.at("changes"))
          named =
              named || change.get<std::string>().find(part.at("part_number").get<std::string>()) != std::string::npos;
        CHECK(named);
      }
    }
    CHECK(build.at("changes").size() >= changed);
  }
  expect_alone(front);
}

TEST_CASE("The page of an audit has every row with its derivation") {
  const Workshop shop;
  const std::string claims = std::string(MILLWRIGHT_SOURCE_DIR) + "/problems/papers/mini-mill.toml";
  REQUIRE(shop.run({"audit", claims, "--report", "a.html", "--json", "a.json"}).exit_code == 0);
  const std::string page = shop.read("a.html");
  const Json result = Json::parse(shop.read("a.json"));
  CHECK(data_of(page, "result") == result);
  expect_alone(page);
  for (const Json& row : result.at("rows")) {
    CAPTURE(row.dump());
    const std::string article = between(
        page, "<article class=\"calculation\" id=\"row-" + row.at("id").get<std::string>() + "\">", "</article>");
    CHECK(without_tags(article).find(row.at("verdict").get<std::string>()) != std::string::npos);
    if (row.at("computed").is_null()) continue;
    const std::vector<double> values = results(article);
    REQUIRE_FALSE(values.empty());
    CHECK(is_near(values.back(), row.at("computed").get<double>(), 5.1e-4));
  }
}

TEST_CASE("Names that would be markup are text on the page") {
  const Workshop shop;
  shop.write("m.toml",
             one_slide_with("\"One slide\"", R"('''</title></script><script>alert("1")</script> & 'so' <!--''')"));
  const Outcome solved = shop.run({"solve", "m.toml", "--report", "r.html", "--bom", "b.csv"});
  CAPTURE(solved.err);
  REQUIRE(solved.exit_code == 0);
  const std::string page = shop.read("r.html");
  // The only scripts are the page's own two data blocks and its program.
  std::size_t scripts = 0;
  for (std::size_t at = page.find("<script"); at != std::string::npos; at = page.find("<script", at + 1)) ++scripts;
  CHECK(scripts == 3);
  CHECK(page.find("alert(\"1\")</script>") == std::string::npos);
  CHECK(visible(page).find("&lt;/title&gt;&lt;/script&gt;&lt;script&gt;alert(&quot;1&quot;)&lt;/script&gt; &amp; "
                           "&#39;so&#39; &lt;!--") != std::string::npos);
  CHECK(data_of(page, "result").at("problem").at("title") ==
        "</title></script><script>alert(\"1\")</script> & 'so' <!--");
}

TEST_CASE("A part whose name would be markup is text on the page") {
  const Workshop shop;
  shop.write("m.toml", one_slide);
  const std::string name = "<img src=x onerror=alert(1)> \"A\" & 'B'";
  // The shipped supplies once more, one of them by another name.
  std::ifstream file(MILLWRIGHT_SOURCE_DIR "/catalogues/power_supplies/mean_well.csv", std::ios::binary);
  std::string supplies(std::istreambuf_iterator<char>(file), {});
  const std::size_t at = supplies.find("LRS-50-24");
  REQUIRE(at != std::string::npos);
  const std::string quoted = "\"<img src=x onerror=alert(1)> \"\"A\"\" & 'B'\"";
  supplies.replace(at, std::string("LRS-50-24").size(), quoted);
  shop.write("mine/power_supplies/mine.csv", supplies);
  const Outcome solved =
      shop.run({"solve", "m.toml", "--catalogue", "mine", "--fix", "machine.supply=" + name, "--report", "r.html"});
  CAPTURE(solved.err);
  REQUIRE(solved.exit_code == 0);
  const std::string page = visible(shop.read("r.html"));
  CHECK(page.find("<img") == std::string::npos);
  CHECK(page.find("&lt;img src=x onerror=alert(1)&gt; &quot;A&quot; &amp; &#39;B&#39;") != std::string::npos);
}

TEST_CASE("The page can be had in Indonesian, with the same numbers") {
  const Workshop shop;
  shop.write("m.toml", one_slide);
  REQUIRE(shop.run({"solve", "m.toml", "--report", "r.html", "--json", "r.json", "--language", "id"}).exit_code == 0);
  const std::string page = shop.read("r.html");
  CHECK(page.find("<html lang=\"id\">") != std::string::npos);
  CHECK(page.find("Daftar komponen") != std::string::npos);
  CHECK(page.find("Bill of materials") == std::string::npos);
  const Json json = Json::parse(shop.read("r.json"));
  // Nothing of what the certificate and the constraints say in English is left for people to read.
  const std::string seen = visible(page);
  for (const Json& check : json.at("checks")) {
    CAPTURE(check.at("title"));
    CHECK(seen.find(">" + check.at("title").get<std::string>() + "<") == std::string::npos);
    CHECK(seen.find("</b> " + check.at("title").get<std::string>()) == std::string::npos);
  }
  CHECK(seen.find("Terbukti: tidak ada rancangan yang memenuhi syarat") != std::string::npos);
  for (const char* english : {"Proved", "combinations", "branch and bound", "computed again", "evaluations"}) {
    CAPTURE(english);
    CHECK(seen.find(english) == std::string::npos);
  }
  Json without_titles = json;  // the numbers are the same
  for (Json& check : without_titles.at("checks")) check["title"] = "";
  expect_checks(page, without_titles);
  const Outcome of_nothing = shop.run({"solve", "m.toml", "--language", "id"});
  CHECK(of_nothing.exit_code == 2);
  CHECK(of_nothing.says("--language requires --report"));
  const Outcome unknown = shop.run({"solve", "m.toml", "--report", "r.html", "--language", "xx"});
  CHECK(unknown.exit_code == 2);
}

TEST_CASE("A page that explains why nothing is compliant is written too") {
  const Workshop shop;
  shop.write("m.toml", one_slide_with("force = \"20 N\"", "force = \"200 kN\""));
  const Outcome outcome = shop.run({"solve", "m.toml", "--report", "r.html"});
  CHECK(outcome.exit_code == 1);
  const std::string page = shop.read("r.html");
  CHECK(page.find("No compliant build exists") != std::string::npos);
  expect_alone(page);
}

}  // namespace millwright::app::report_page_test
