// SPDX-License-Identifier: Apache-2.0
// The growth benchmark in a small size: longer catalogues are catalogues, and its stacks are those of the family.
#include <unistd.h>

#include <cstdlib>

#include "benchmark/growing_stack.h"
#include "benchmark/multiplied_catalogues.h"
#include "benchmark/stack_instance.h"
#include "catch.h"

namespace growth_test {

namespace {

using namespace millwright::solver;

struct Folder {
  Folder()
      : path(std::filesystem::temp_directory_path() /
             fmt::format("millwright_growth_test_{}", static_cast<long>(getpid()))) {
    std::filesystem::create_directories(path);
  }
  ~Folder() { std::filesystem::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::filesystem::path path;
};

std::string contents(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

double least_cost(const Problem& problem) {
  const Summary found = solve(problem, {});
  REQUIRE(found.status != Status::limit);
  return found.builds.empty() ? -1.0 : found.builds[0].resources[0];
}

}  // namespace

TEST_CASE("A file made longer keeps its rows and what decides fits, and copies differ a little in the rest") {
  const Folder folder;
  std::ofstream(folder.path / "some.csv")
      << "# a comment\nmanufacturer,part_number,bore [mm],mass [kg],price,price_basis,note\n"
         "\"A, B\",one,5,2.5,10,guess,\nC,two,8,,20,guess,\"said \"\"so\"\"\"\n";
  std::mt19937_64 random(1);
  CHECK(growth::multiply_file(folder.path / "some.csv", folder.path / "more.csv", 3, random) == 6);
  millwright::text::Diagnostics diagnostics;
  const auto source = millwright::text::SourceText::load((folder.path / "more.csv").string(), diagnostics);
  const auto table = millwright::text::read_csv(source, diagnostics);
  REQUIRE(diagnostics.count() == 0);
  REQUIRE(table.row_count() == 6);
  const auto column = [&](std::size_t i) {
    const auto cells = table.text_column(i);
    return std::vector<std::string>(cells.begin(), cells.end());
  };
  CHECK(column(0) == std::vector<std::string>{"A, B", "C", "A, B", "C", "A, B", "C"});
  CHECK(column(1) == std::vector<std::string>{"one", "two", "one~1", "two~1", "one~2", "two~2"});
  CHECK(column(2) == std::vector<std::string>{"5", "8", "5", "8", "5", "8"});
  CHECK(column(5) == std::vector<std::string>(6, "guess"));
  CHECK(column(6)[3] == "said \"so\"");
  CHECK(column(3)[0] == "2.5");
  CHECK(column(3)[3].empty());
  for (const std::size_t copy : {2U, 4U}) {
    CHECK(column(3)[copy] != "2.5");
    CHECK(std::strtod(column(3)[copy].c_str(), nullptr) == Approx(2.5).epsilon(0.084));
    CHECK(std::strtod(column(4)[copy].c_str(), nullptr) == Approx(10.0).epsilon(0.084));
  }
  CHECK(column(4)[2] != column(4)[4]);
}

TEST_CASE("Catalogues of twice the rows are read without a complaint") {
  const Folder folder;
  const std::filesystem::path shipped = std::string(MILLWRIGHT_SOURCE_DIR) + "/catalogues";
  const std::size_t once = growth::multiply_catalogues(shipped, folder.path / "once", 1);
  const std::size_t twice = growth::multiply_catalogues(shipped, folder.path / "twice", 2);
  CHECK(once > 1000);
  CHECK(twice > 19 * once / 10);
  const auto said = folder.path / "said";
  const std::string list = fmt::format("MILLWRIGHT_CATALOGUES='{}' '{}' catalogue list >'{}' 2>&1",
                                       (folder.path / "twice").string(),
                                       MILLWRIGHT_PROGRAM,
                                       said.string());
  CHECK(std::system(list.c_str()) == 0);
  CHECK(contents(said).find("error") == std::string::npos);
  CHECK(contents(said).find("warning") == std::string::npos);
}

TEST_CASE("Stacks with one ramp and the catalogue's diameters are the family, and dimensions only help or only bind") {
  for (const std::uint64_t seed : {2U, 3U, 5U, 6U}) {
    CAPTURE(seed);
    const stack::Instance instance = stack::random_instance(2, 12, 12, seed);
    const double plain = least_cost(stack::Machine(instance).problem);
    const double one = least_cost(growth::Machine(instance, 1, false).problem);
    CHECK(one == Approx(plain).epsilon(1e-9));
    // A fixed ramp is one of those that may be chosen.
    const double fixed = least_cost(growth::Machine(instance, 0, false).problem);
    CHECK((fixed < 0.0 || (one > 0.0 && fixed >= one * (1.0 - 1e-9))));
    // A second move binds, a free diameter may be the catalogue's.
    const double two = least_cost(growth::Machine(instance, 2, false).problem);
    CHECK((two < 0.0 || (one > 0.0 && two >= one * (1.0 - 1e-9))));
    const double free = least_cost(growth::Machine(instance, 1, true).problem);
    CHECK((one < 0.0 || (free > 0.0 && free <= one * (1.0 + 1e-6))));
  }
}

TEST_CASE("The exponent of a power law is found") {
  CHECK(growth::exponent({1.0, 10.0, 100.0}, {3.0, 30.0, 300.0}) == Approx(1.0));
  CHECK(growth::exponent({2.0, 4.0, 8.0, 16.0}, {5.0, 20.0, 80.0, 320.0}) == Approx(2.0));
}

}  // namespace growth_test
