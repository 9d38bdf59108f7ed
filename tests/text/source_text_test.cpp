// SPDX-License-Identifier: Apache-2.0
#include "text/source_text.h"

#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <random>

#include "catch.h"
#include "text/diagnostic.h"
#include "text/text_check.h"
#include "text/utf8.h"

namespace source_text_test {

using namespace millwright::text;
namespace fs = std::filesystem;

namespace {

/// A directory of its own for each test, gone afterwards.
class Scratch {
 public:
  Scratch() {
    std::string name = (fs::temp_directory_path() / "millwright_text_XXXXXX").string();
    REQUIRE(::mkdtemp(name.data()) != nullptr);
    root_ = name;
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(root_, ignored);
  }
  std::string path(const std::string& name) const { return (root_ / name).string(); }
  std::string write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }

 private:
  fs::path root_;
};

std::string only_message(const Diagnostics& diagnostics) {
  REQUIRE(diagnostics.count() == 1);
  return diagnostics.all().front().message;
}

std::string random_bytes(std::size_t size, unsigned seed) {
  std::mt19937 generator(seed);
  std::string bytes(size, '\0');
  for (char& byte : bytes) byte = static_cast<char>(generator() & 0xFFU);
  return bytes;
}

}  // namespace

TEST_CASE("positions count characters, not bytes") {
  const auto text = SourceText::from_string("f", "ab\n\tµ°x\r\n\nend");
  CHECK(text->line_count() == 4);
  CHECK(text->line(1) == "ab");
  CHECK(text->line(2) == "\tµ°x");
  CHECK(text->line(3).empty());
  CHECK(text->line(4) == "end");
  CHECK(text->line(0).empty());
  CHECK(text->line(5).empty());
  CHECK(text->line(-1).empty());
  const std::size_t x = text->contents().find('x');
  CHECK(text->position(x).line == 2);
  CHECK(text->position(x).column == 4);
  CHECK(text->position(0).column == 1);
  CHECK(text->position(1000000).line == 4);
  CHECK(text->position(1000000).column == 4);
}

TEST_CASE("the byte order mark is not part of the text") {
  const auto text = SourceText::from_string("f", "\xEF\xBB\xBFname,mass\n");
  CHECK(text->contents() == "name,mass\n");
  CHECK(text->position(5).column == 6);
  CHECK(SourceText::from_string("f", "\xEF\xBB\xBF")->contents().empty());
}

TEST_CASE("positions agree with counting from the start, on random text") {
  std::mt19937 generator(7);
  const std::vector<std::string> pieces = {"a", "\n", "\r\n", "\t", "é", "€", "😀", ",", "\n\n"};
  for (int round = 0; round < 50; ++round) {
    std::string bytes;
    for (int i = 0; i < 60; ++i) bytes += pieces[generator() % pieces.size()];
    const auto text = SourceText::from_string("f", bytes);
    int line = 1;
    int column = 1;
    for (std::size_t offset = 0; offset < bytes.size();) {
      const Position place = text->position(offset);
      REQUIRE(place.line == line);
      REQUIRE(place.column == column);
      const bool newline = bytes[offset] == '\n';
      line += newline ? 1 : 0;
      column = newline ? 1 : column + 1;
      ++offset;
      while (offset < bytes.size() && (static_cast<unsigned char>(bytes[offset]) & 0xC0U) == 0x80U) ++offset;
    }
  }
}

TEST_CASE("positions are the same near the beginning, where lines are counted, and behind it") {
  std::mt19937 random(5);
  for (const std::size_t line_length : {std::size_t{1}, std::size_t{60}, std::size_t{5000}}) {
    std::string bytes;
    while (bytes.size() < 12000) {
      for (std::size_t i = 0; i < line_length; ++i) bytes += random() % 7 == 0 ? "\xC2\xB5" : "a";
      bytes += "\n";
    }
    const auto text = SourceText::from_string("t", bytes);
    int line = 1, column = 1;
    for (std::size_t at = 0; at < bytes.size(); ++at) {
      const bool inside = (static_cast<unsigned char>(bytes[at]) & 0xC0U) == 0x80U;
      if (!inside) {
        const Position place = text->position(at);
        if (place.line != line || place.column != column) FAIL("at " << at);
        ++column;
      }
      if (bytes[at] == '\n') {
        ++line;
        column = 1;
      }
    }
  }
}

TEST_CASE("UTF-8 is decoded as RFC 3629 says") {
  CHECK(decode("A", 0).value == U'A');
  CHECK(decode("\xC2\xB5", 0).value == 0xB5);
  CHECK(decode("\xE2\x82\xAC", 0).value == 0x20AC);
  CHECK(decode("\xF0\x9F\x98\x80", 0).value == 0x1F600);
  // Overlong, surrogate, above U+10FFFF, lone continuation, truncated, never used lead bytes.
  for (const std::string bad : {"\xC0\xAF",
                                "\xE0\x80\xAF",
                                "\xED\xA0\x80",
                                "\xF4\x90\x80\x80",
                                "\x80",
                                "\xE2\x82",
                                "\xF8",
                                "\xFF",
                                "\xC1\x81",
                                "\xF0\x80\x80\x80"}) {
    CHECK_FALSE(decode(bad, 0).valid);
    CHECK(decode(bad, 0).bytes == 1);
  }
  for (const char32_t value : {U'A', U'µ', U'€', U'😀'}) {
    std::string bytes;
    append_utf8(bytes, value);
    CHECK(decode(bytes, 0).value == value);
    CHECK(decode(bytes, 0).bytes == static_cast<int>(bytes.size()));
  }
}

TEST_CASE("the quick search for bad bytes finds what a slow one finds") {
  std::mt19937 generator(11);
  for (int round = 0; round < 3000; ++round) {
    std::string bytes(generator() % 40, 'x');
    for (char& byte : bytes) {
      if (generator() % 8 == 0) byte = static_cast<char>(generator() & 0xFFU);
    }
    std::optional<std::size_t> slow;
    for (std::size_t at = 0; at < bytes.size() && !slow;) {
      const Character c = decode(bytes, at);
      const bool control = (c.value < 0x20 && c.value != '\t' && c.value != '\n' && c.value != '\r') || c.value == 0x7F;
      if (!c.valid || control) slow = at;
      at += static_cast<std::size_t>(c.bytes);
    }
    REQUIRE(find_bad_byte(bytes) == slow);
  }
}

TEST_CASE("a good file is loaded whole") {
  const Scratch scratch;
  Diagnostics diagnostics;
  std::string long_text;
  while (long_text.size() < 300000) long_text += "a line of text with a µ in it\n";
  for (const std::string& bytes : {std::string(), std::string("x"), long_text, long_text.substr(0, 65536)}) {
    const auto text = SourceText::load(scratch.write("t.csv", bytes), diagnostics);
    REQUIRE(text);
    CHECK(text->contents() == bytes);
  }
  CHECK(diagnostics.count() == 0);
}

TEST_CASE("what cannot be loaded gives one error that says why") {
  const Scratch scratch;
  Diagnostics diagnostics;
  SECTION("not there") {
    CHECK_FALSE(SourceText::load(scratch.path("none.csv"), diagnostics));
    CHECK(only_message(diagnostics) == "cannot be opened: No such file or directory");
    CHECK(format(diagnostics.all()[0]) ==
          scratch.path("none.csv") + ": error: cannot be opened: No such file or directory\n");
    (void)scratch.write("sander.toml", "");
    CHECK_FALSE(SourceText::load(scratch.path("sandr.toml"), diagnostics));
    CHECK(diagnostics.all()[1].hint == "did you mean '" + scratch.path("sander.toml") + "'?");
    CHECK_FALSE(SourceText::load(scratch.path("no folder/deep/sander.toml"), diagnostics));
    CHECK(diagnostics.all()[2].hint == "there is no folder '" + scratch.path("no folder") + "'");
    std::filesystem::create_symlink("gone.csv", scratch.path("link.csv"));
    CHECK_FALSE(SourceText::load(scratch.path("link.csv"), diagnostics));
    CHECK(diagnostics.all()[3].hint == "it is a symbolic link to 'gone.csv', which leads to nothing");
    fs::create_directory(scratch.path("problems"));
    CHECK_FALSE(SourceText::load(scratch.path("problms/sander.toml"), diagnostics));
    CHECK(diagnostics.all()[4].hint ==
          "there is no folder '" + scratch.path("problms") + "'; did you mean '" + scratch.path("problems") + "'?");
  }
  SECTION("directory") {
    fs::create_directory(scratch.path("folder"));
    CHECK_FALSE(SourceText::load(scratch.path("folder"), diagnostics));
    CHECK(only_message(diagnostics) == "is a directory, not a file");
    CHECK(diagnostics.all()[0].hint == "name a file in it");
  }
  SECTION("named pipe without a writer") {
    REQUIRE(::mkfifo(scratch.path("pipe").c_str(), 0600) == 0);
    CHECK_FALSE(SourceText::load(scratch.path("pipe"), diagnostics));
    CHECK(only_message(diagnostics) == "is a pipe, not a file");
  }
  SECTION("device") {
    CHECK_FALSE(SourceText::load("/dev/zero", diagnostics));
    CHECK(only_message(diagnostics) == "is a device, not a file");
  }
  SECTION("no permission") {
    const std::string path = scratch.write("secret", "x");
    fs::permissions(path, fs::perms::none);
    if (::geteuid() != 0) {
      CHECK_FALSE(SourceText::load(path, diagnostics));
      CHECK(only_message(diagnostics) == "cannot be opened: Permission denied");
    }
  }
  SECTION("empty and impossible names") {
    CHECK_FALSE(SourceText::load("", diagnostics));
    CHECK_FALSE(SourceText::load(std::string("a\0b", 3), diagnostics));
    CHECK_FALSE(SourceText::load(std::string(100000, 'x'), diagnostics));
    CHECK(diagnostics.error_count() == 3);
  }
  SECTION("too large") {
    CHECK_FALSE(SourceText::load(scratch.write("big", std::string(1001, 'x')), diagnostics, 1000));
    CHECK(only_message(diagnostics) == "is too large: 1001 bytes or more, the limit is 1000");
  }
  SECTION("UTF-16") {
    CHECK_FALSE(SourceText::load(scratch.write("wide",
                                               std::string("\xFF\xFE"
                                                           "a\0b\0",
                                                           6)),
                                 diagnostics));
    CHECK(only_message(diagnostics) == "this is UTF-16, not UTF-8");
  }
  SECTION("Latin-1") {
    std::string latin;
    for (int i = 0; i < 20; ++i) latin += "motor,5 \xB5m\n";
    CHECK_FALSE(SourceText::load(scratch.write("latin", latin), diagnostics));
    REQUIRE(diagnostics.count() == 1);
    CHECK(diagnostics.all()[0].where.line == 1);
    CHECK(diagnostics.all()[0].where.column == 9);
    CHECK(only_message(diagnostics) == "not UTF-8: byte \\xB5 is not UTF-8, and it is not the only one");
  }
}

TEST_CASE("a gigabyte of noise is one error and is not read") {
  const Scratch scratch;
  const std::string path = scratch.write("noise.csv", random_bytes(100000, 3));
  // Sparse: the file claims a gigabyte and more, and takes no room.
  fs::resize_file(path, (std::uintmax_t{1} << 30U) + 12345);
  Diagnostics diagnostics;
  CHECK_FALSE(SourceText::load(path, diagnostics));
  CHECK(only_message(diagnostics).substr(0, 16) == "not a text file:");
  fs::resize_file(scratch.write("text.csv", std::string(100000, 'x')), std::uintmax_t{1} << 40U);
  Diagnostics second;
  CHECK_FALSE(SourceText::load(scratch.path("text.csv"), second));
  CHECK(only_message(second).substr(0, 13) == "is too large:");
}

TEST_CASE("single bad bytes are reported where they are") {
  Diagnostics diagnostics;
  const auto text = SourceText::from_string("c.csv", std::string("a,b\n1,\0\nµ,\xE9x\n", 14));
  CHECK_FALSE(check_text(text, diagnostics));
  const auto all = diagnostics.all();
  REQUIRE(all.size() == 2);
  CHECK(format(all[0]) == "c.csv:2:3: error: NUL byte\n    2 | 1,\\x00\n      |   ^~~~ hint: remove it\n");
  CHECK(
      format(all[1]) ==
      "c.csv:3:3: error: byte \\xE9 is not UTF-8\n    3 | µ,\\xE9x\n      |   ^~~~ hint: save the file in the encoding "
      "UTF-8\n");
}

TEST_CASE("random bytes never break the loader") {
  const Scratch scratch;
  for (unsigned seed = 0; seed < 60; ++seed) {
    Diagnostics diagnostics;
    const auto text = SourceText::load(scratch.write("n", random_bytes(seed * 7, seed)), diagnostics);
    if (text) check_text(text, diagnostics);
    CHECK(format(diagnostics).find('\0') == std::string::npos);
  }
}

}  // namespace source_text_test
