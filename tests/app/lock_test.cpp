// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>
#include <sstream>

#include "catch.h"
#include "program.h"
#include "text/sha256.h"

namespace lock_test {

using namespace millwright::app;

namespace {

/// A machine with catalogues of its own, solved and locked.
class LockedShop : public Workshop {
 public:
  LockedShop() {
    std::filesystem::copy(MILLWRIGHT_SOURCE_DIR "/catalogues", path("parts"), std::filesystem::copy_options::recursive);
    setenv("MILLWRIGHT_CATALOGUES", path("parts").c_str(), 1);
    write("m.toml", one_slide);
    const Outcome outcome = run({"solve", "m.toml", "--write-lock", "m.lock", "--bom", "m.csv", "--json", "m.json"});
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    REQUIRE_FALSE(outcome.complains());
    const auto result = nlohmann::json::parse(read("m.json"));
    for (const auto& part : result.at("build").at("parts"))
      if (part.at("slot") == "motor") motor_ = part;
  }

  /// The file of the motor, and its row there.
  std::string motor_file() const {
    const std::string row = motor_.at("row");
    return "parts/" + row.substr(row.find('/') + 1, row.rfind(':') - row.find('/') - 1);
  }
  std::string motor_name() const {
    return motor_.at("manufacturer").get<std::string>() + " " + motor_.at("part_number").get<std::string>();
  }
  /// Adds 1 to the motor's price, which stands before its currency.
  void raise_motor_price() const {
    std::istringstream lines(read(motor_file()));
    std::string text;
    const std::string begin =
        motor_.at("manufacturer").get<std::string>() + "," + motor_.at("part_number").get<std::string>() + ",";
    for (std::string line; std::getline(lines, line);) {
      if (line.rfind(begin, 0) == 0) {
        const std::size_t currency = line.find(",USD,");
        REQUIRE(currency != std::string::npos);
        const std::size_t price = line.rfind(',', currency - 1) + 1;
        std::ostringstream raised;
        raised << std::stod(line.substr(price, currency - price)) + 1.0;
        line.replace(price, currency - price, raised.str());
      }
      text += line + "\n";
    }
    REQUIRE(text != read(motor_file()));
    write(motor_file(), text);
  }
  Outcome locked(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"solve", "m.toml", "--locked", "m.lock"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }

 private:
  nlohmann::json motor_;
};

}  // namespace

TEST_CASE("what is as it was when the lock was written passes, also for other verbs and from elsewhere") {
  const LockedShop shop;
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"solve", "m.toml"}, {"check", "m.toml", "m.csv"}, {"pareto", "m.toml"}}) {
    std::vector<std::string> with = words;
    with.insert(with.end(), {"--locked", "m.lock"});
    const Outcome outcome = shop.run(with);
    INFO(outcome.err);
    CHECK(outcome.exit_code == 0);
    CHECK_FALSE(outcome.complains());
  }
  shop.write("elsewhere/n.toml", one_slide);
  std::filesystem::rename(shop.path("parts"), shop.path("moved"));
  setenv("MILLWRIGHT_CATALOGUES", shop.path("moved").c_str(), 1);
  CHECK(shop.run({"solve", "elsewhere/n.toml", "--locked", "m.lock"}).exit_code == 0);
}

TEST_CASE("the lock is the same for the same result, and names the digests of its files") {
  const LockedShop shop;
  CHECK(shop.run({"solve", "m.toml", "--write-lock", "again.lock", "--bom", "m.csv", "--force"}).exit_code == 0);
  CHECK(shop.read("again.lock") == shop.read("m.lock"));
  CHECK(shop.read("m.lock").find("sha256 = \"" + millwright::text::sha256(one_slide) + "\"") != std::string::npos);
  CHECK(shop.read("m.lock").find(millwright::text::sha256(shop.read(shop.motor_file()))) != std::string::npos);
  const auto json = nlohmann::json::parse(shop.read("m.json"));
  REQUIRE(json.at("catalogues").size() == 1);
  CHECK(json.at("catalogues").at(0).at("place") == "catalogues");
  // The list that `sha256sum */*.csv` prints, ascending by name.
  std::map<std::string, std::string> files;
  for (const auto& each : std::filesystem::recursive_directory_iterator(shop.path("parts")))
    if (each.path().extension() == ".csv") {
      const std::string name = each.path().lexically_relative(shop.path("parts")).string();
      files[name] = millwright::text::sha256(shop.read("parts/" + name));
    }
  std::string list;
  for (const auto& [name, digest] : files) list += digest + "  " + name + "\n";
  CHECK(json.at("catalogues").at(0).at("files") == files.size());
  CHECK(json.at("catalogues").at(0).at("sha256") == millwright::text::sha256(list));
}

TEST_CASE("a changed price stops a locked run, which names part, old and new price and both places") {
  const LockedShop shop;
  shop.raise_motor_price();
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{{"solve", "m.toml"},
                                                                                     {"pareto", "m.toml"},
                                                                                     {"explain", "m.toml"},
                                                                                     {"check", "m.toml", "m.csv"},
                                                                                     {"compare", "m.csv", "m.json"}}) {
    std::vector<std::string> with = words;
    with.insert(with.end(), {"--locked", "m.lock"});
    const Outcome outcome = shop.run(with);
    INFO(outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.says("error: " + shop.motor_name() + " (x.motor): price was "));
    CHECK(outcome.says(shop.motor_file().substr(6) + " changed: SHA-256 "));
    CHECK_FALSE(outcome.says("no figure of a part of the locked build changed"));
    CHECK(outcome.says("2 errors"));
  }
  CHECK(shop.run({"solve", "m.toml", "--write-lock", "m.lock"}).exit_code == 0);  // accepts it
  CHECK(shop.locked().exit_code == 0);
}

TEST_CASE("a file that changed without a changed figure, a missing and a new one stop a locked run") {
  const LockedShop shop;
  shop.write(shop.motor_file(), "# looked at\n" + shop.read(shop.motor_file()));
  const Outcome changed = shop.locked();
  CHECK(changed.exit_code == 2);
  CHECK(changed.says("changed: SHA-256"));
  CHECK(changed.says("no figure of a part of the locked build changed"));
  CHECK(changed.says("1 error"));
  const LockedShop second;
  second.write("parts/couplings/more.csv", second.read("parts/couplings/ktr.csv"));
  std::filesystem::remove(second.path("parts/couplings/ktr.csv"));
  const Outcome moved = second.locked();
  CHECK(moved.exit_code == 2);
  CHECK(moved.says("catalogues/couplings/ktr.csv is missing"));
  CHECK(moved.says("catalogues/couplings/more.csv is new"));
  second.write("mine/couplings/x.csv", second.read("parts/couplings/ruland.csv"));
  const Outcome overlay = second.locked({"--catalogue", "mine"});
  CHECK(overlay.says("mine/couplings/x.csv is new"));
}

TEST_CASE("a catalogue that is a single file is told by its place alone") {
  const LockedShop shop;
  shop.write("my.csv", shop.read(shop.motor_file()));
  CHECK(shop.locked({"--catalogue", "my.csv"}).says(" my.csv is new"));
  const Outcome written = shop.run({"solve", "m.toml", "--catalogue", "my.csv", "--write-lock", "o.lock"});
  INFO(written.err);
  REQUIRE(written.exit_code == 0);
  CHECK(shop.read("o.lock").find("file = \"my.csv\"") != std::string::npos);
  shop.write("my.csv", "# looked at\n" + shop.read("my.csv"));
  const Outcome changed = shop.run({"solve", "m.toml", "--catalogue", "my.csv", "--locked", "o.lock"});
  CHECK(changed.exit_code == 2);
  CHECK(changed.says(" my.csv changed: SHA-256"));
}

TEST_CASE("another problem stops a locked run, and what is asked for otherwise is a warning") {
  const LockedShop shop;
  const Outcome asked = shop.locked({"--set", "axis.x.stroke='220 mm'"});
  INFO(asked.err);
  CHECK(asked.exit_code == 0);
  CHECK(asked.says("warning: --set asked for nothing when the lock was written, now for axis.x.stroke"));
  shop.write("m.toml", one_slide_with("5 kg", "4 kg"));
  const Outcome outcome = shop.locked();
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.says("the problem m.toml changed: SHA-256"));
}

TEST_CASE("another build than the locked one is told") {
  const LockedShop shop;
  const Outcome outcome = shop.locked({"--without", shop.motor_name()});
  INFO(outcome.err);
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.says("--without asked for nothing"));
  CHECK(outcome.says("the build is not the locked one: x.motor was " + shop.motor_name() + ", is "));
}

TEST_CASE("an edited lock is refused, and a lock goes over nothing but a lock") {
  const LockedShop shop;
  std::string text = shop.read("m.lock");
  text.replace(text.find("rows = "), 7, "rows = 1");
  shop.write("edited.lock", text);
  const Outcome edited = shop.run({"solve", "m.toml", "--locked", "edited.lock"});
  CHECK(edited.exit_code == 2);
  CHECK(edited.says("edited.lock:4:8: error: this lock was changed after it was written"));
  const Outcome over = shop.run({"solve", "m.toml", "--write-lock", "m.csv"});
  CHECK(over.exit_code == 2);
  CHECK(over.says("m.csv: there is such a file already that is no lock"));
  CHECK(shop.run({"solve", "m.toml", "--write-lock", "m.lock", "--locked", "m.lock"}).exit_code == 2);
  CHECK(shop.run({"solve", "m.toml", "--locked", "none.lock"}).says("none.lock: error"));
  CHECK(shop.run({"compare", "m.json", "m.json", "--locked", "m.lock"}).says("--locked: both are results"));
  CHECK(shop.run({"solve", "m.toml", "--set", "axis.x.moves[0].time=15:20:2 s", "--write-lock", "r.lock"})
            .says("--write-lock: of a range there is no single build"));
  CHECK_FALSE(shop.has("r.lock"));
}

}  // namespace lock_test
