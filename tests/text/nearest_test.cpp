// SPDX-License-Identifier: Apache-2.0
#include "text/nearest.h"

#include <random>
#include <set>

#include "catch.h"

namespace nearest_test {

using namespace millwright::text;

namespace {
/// Distances from `word` to everything within two edits, by trying all edits: independent of the table method.
std::set<std::string> edits(const std::string& word, const std::string& letters) {
  std::set<std::string> result;
  for (std::size_t i = 0; i <= word.size(); ++i) {
    for (const char letter : letters) {
      result.insert(word.substr(0, i) + letter + word.substr(i));
      if (i < word.size()) result.insert(word.substr(0, i) + letter + word.substr(i + 1));
    }
    if (i < word.size()) result.insert(word.substr(0, i) + word.substr(i + 1));
    if (i + 1 < word.size()) result.insert(word.substr(0, i) + word[i + 1] + word[i] + word.substr(i + 2));
  }
  return result;
}
}  // namespace

TEST_CASE("edit distance of known pairs") {
  CHECK(edit_distance("", "") == 0);
  CHECK(edit_distance("", "abc") == 3);
  CHECK(edit_distance("kitten", "sitting") == 3);
  CHECK(edit_distance("stroke", "storke") == 1);
  CHECK(edit_distance("ca", "abc") == 3);  // optimal string alignment, not the unrestricted distance 2
}

TEST_CASE("edit distance one is exactly what one edit reaches") {
  std::mt19937 generator(2);
  for (int round = 0; round < 200; ++round) {
    std::string word;
    std::string other;
    for (auto i = generator() % 5; i > 0; --i) word += "abc"[generator() % 3];
    for (auto i = generator() % 5; i > 0; --i) other += "abc"[generator() % 3];
    const bool one_edit = edits(word, "abc").count(other) > 0 || word == other;
    CHECK((edit_distance(word, other) <= 1) == one_edit);
    CHECK(edit_distance(word, other) == edit_distance(other, word));
  }
}

TEST_CASE("the word that was meant is found") {
  const std::vector<std::string> keys = {
      "stroke", "structure_mass", "guide_friction", "name", "holding_torque", "mass"};
  CHECK(nearest("storke", keys) == "stroke");
  CHECK(nearest("Stroke", keys) == "stroke");
  CHECK(nearest("structure-mass", keys) == "structure_mass");
  CHECK(nearest("guide_fricton", keys) == "guide_friction");
  CHECK(nearest("mas", keys) == "mass");
  CHECK(nearest("holding", keys) == "holding_torque");
  CHECK_FALSE(nearest("colour", keys));
  CHECK_FALSE(nearest("", keys));
  CHECK_FALSE(nearest("x", {"y", "z"}));
  CHECK_FALSE(nearest(std::string(10000000, 'x'), keys));
  CHECK_FALSE(nearest("word", std::vector<std::string>{}));
  CHECK(nearest("str", {"stroke", "structure"}) == std::nullopt);
  CHECK(did_you_mean("nmae", keys) == "did you mean 'name'?");
  CHECK(did_you_mean("zzzzz", keys, "see the list") == "see the list");
}

}  // namespace nearest_test
