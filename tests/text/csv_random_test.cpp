// SPDX-License-Identifier: Apache-2.0
// The quick reader against a slow one that goes character by character, and against bytes nobody meant as a table.
#include <random>

#include "catch.h"
#include "text/csv.h"

namespace csv_random_test {

using namespace millwright::text;

namespace {

using Row = std::vector<std::string>;

struct Written {
  std::string text;
  std::vector<Row> rows;
};

std::string quote(const std::string& cell) {
  std::string result = "\"";
  for (const char c : cell) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

/// A random table in a random dress: the cells are known, the way they are written varies.
Written random_table(std::mt19937& generator) {
  const std::vector<std::string> pieces = {
      "a", "bc", "µ", "€", "1.5", "\"", ",", ";", "\n", "\r\n", "x y", "#", "\t", "longer piece of text"};
  const auto pick = [&](std::size_t n) { return static_cast<std::size_t>(generator() % n); };
  const char separator = pick(2) == 0 ? ',' : ';';
  const std::string end = pick(2) == 0 ? "\n" : "\r\n";
  const std::size_t columns = 2 + pick(12);
  Written written;
  if (pick(2) == 0) written.text += "\xEF\xBB\xBF";
  for (std::size_t c = 0; c < columns; ++c) {
    written.text += (c == 0 ? "" : std::string(1, separator)) + "column" + std::to_string(c);
  }
  written.text += end;
  const std::size_t rows = pick(30);
  for (std::size_t r = 0; r < rows; ++r) {
    Row row;
    for (std::size_t c = 0; c < columns; ++c) {
      std::string cell = c == 0 ? "row" : "";
      for (std::size_t n = pick(5); n > 0; --n) cell += pieces[pick(pieces.size())];
      const bool blank_end = !cell.empty() && (cell.front() == '\t' || cell.back() == '\t');
      const bool needs_quotes = blank_end || cell.find_first_of("\",;\r\n") != std::string::npos;
      const std::string padding(pick(8) == 0 ? 2 : 0, ' ');
      if (c > 0) written.text += separator;
      written.text += padding + (needs_quotes || pick(6) == 0 ? quote(cell) : cell) + padding;
      row.push_back(cell);
    }
    written.rows.push_back(row);
    const bool last = r + 1 == rows;
    if (!last || pick(2) == 0) written.text += end;
    if (pick(10) == 0 && !last) written.text += end;
    if (pick(10) == 0 && !last) written.text += "# a " + pieces[5] + std::string(pick(20), separator) + end;
  }
  return written;
}

/// Character by character, no cleverness; blanks around cells removed, quotes undone.
std::vector<Row> slow_rows(std::string text, char separator) {
  if (text.substr(0, 3) == "\xEF\xBB\xBF") text.erase(0, 3);
  if (text.empty() || text.back() != '\n') text += '\n';
  std::vector<Row> rows;
  Row row;
  std::string cell;
  bool in_quotes = false;
  bool was_quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_quotes) {
      if (c == '"' && text[i + 1] == '"') {
        cell += text[++i];
      } else if (c == '"') {
        in_quotes = false;
      } else {
        cell += c;
      }
      continue;
    }
    if (c == '"') {
      in_quotes = was_quoted = true;
      cell.clear();
    } else if (c == separator || c == '\n') {
      if (!was_quoted) {
        while (!cell.empty() && std::string(" \t\r").find(cell.back()) != std::string::npos) cell.pop_back();
        while (!cell.empty() && std::string(" \t").find(cell.front()) != std::string::npos) cell.erase(0, 1);
      }
      row.push_back(cell);
      cell.clear();
      was_quoted = false;
      if (c == '\n') {
        bool blank = true;
        for (const std::string& content : row) blank = blank && content.empty();
        if (!blank) rows.push_back(row);
        row.clear();
      }
    } else if (c == '#' && row.empty() && cell.find_first_not_of(" \t") == std::string::npos && !was_quoted) {
      while (text[i] != '\n') ++i;
      cell.clear();
    } else if (!was_quoted) {
      cell += c;
    }
  }
  return rows;
}

std::vector<Row> rows_of(const CsvTable& table) {
  std::vector<Row> rows;
  for (std::size_t r = 0; r < table.row_count(); ++r) {
    Row row;
    for (std::size_t c = 0; c < table.columns().size(); ++c) row.emplace_back(table.cell(r, c));
    rows.push_back(row);
  }
  return rows;
}

/// Whatever can be asked of a table, asked.
void exercise(const CsvTable& table, Diagnostics& diagnostics) {
  for (std::size_t c = 0; c < table.columns().size(); ++c) {
    table.number_column(c, diagnostics);
    table.text_column(c);
    for (std::size_t r = 0; r < table.row_count(); ++r) {
      const SourceSpan span = table.cell_span(r, c);
      CHECK((span.line >= 1 && span.column >= 1 && span.length >= 0));
      table.row_span(r);
    }
  }
  CHECK((diagnostics.count() == 0 || !format(diagnostics).empty()));
}

}  // namespace

TEST_CASE("random tables survive writing and reading") {
  std::mt19937 generator(20240601);
  for (int round = 0; round < 2000; ++round) {
    const Written written = random_table(generator);
    Diagnostics diagnostics;
    const CsvTable table = read_csv(SourceText::from_string("r.csv", written.text), diagnostics);
    INFO(written.text << format(diagnostics));
    REQUIRE(diagnostics.count() == 0);
    REQUIRE(rows_of(table) == written.rows);
  }
}

TEST_CASE("the quick reader agrees with a slow one wherever it has no complaint") {
  std::mt19937 generator(5);
  const std::string letters = "ab1,;\"\n\n\r \t#";
  int without_complaint = 0;
  for (int round = 0; round < 60000; ++round) {
    std::string body;
    for (auto n = generator() % 40; n > 0; --n) body += letters[generator() % letters.size()];
    Diagnostics diagnostics;
    const std::string text = "p,q\n" + body;
    const CsvTable table = read_csv(SourceText::from_string("r.csv", text), diagnostics);
    if (diagnostics.has_errors()) continue;
    ++without_complaint;
    std::vector<Row> expected = slow_rows(text, ',');
    expected.erase(expected.begin());
    for (Row& row : expected) row.resize(2);
    INFO(text);
    REQUIRE(rows_of(table) == expected);
  }
  CHECK(without_complaint > 1000);
}

TEST_CASE("random bytes and damaged tables never crash the reader") {
  std::mt19937 generator(77);
  for (int round = 0; round < 4000; ++round) {
    std::string text;
    if (round % 2 == 0) {
      for (auto n = generator() % 200; n > 0; --n) text += static_cast<char>(generator() & 0xFFU);
    } else {
      text = random_table(generator).text;
      for (int n = 0; n < 3 && !text.empty(); ++n) {
        const std::size_t at = generator() % text.size();
        if (generator() % 2 == 0) {
          text.erase(at, generator() % 4);
        } else {
          text[at] = "\",;\n\r\0#\xFF[]"[generator() % 10];
        }
      }
    }
    Diagnostics diagnostics;
    exercise(read_csv(SourceText::from_string("r.csv", text), diagnostics), diagnostics);
  }
}

}  // namespace csv_random_test
