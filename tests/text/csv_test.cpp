// SPDX-License-Identifier: Apache-2.0
#include "text/csv.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <random>

#include "catch.h"
#include "sanitized.h"
#include "text/csv_reader.h"
#include "text/table_size.h"

namespace csv_test {

using namespace millwright::text;

namespace {

CsvTable read(const std::string& contents, Diagnostics& diagnostics) {
  return read_csv(SourceText::from_string("c.csv", contents), diagnostics);
}

CsvTable read_clean(const std::string& contents) {
  Diagnostics diagnostics;
  CsvTable table = read(contents, diagnostics);
  INFO(format(diagnostics));
  CHECK(diagnostics.count() == 0);
  return table;
}

std::vector<std::string> row(const CsvTable& table, std::size_t number) {
  std::vector<std::string> cells;
  for (std::size_t i = 0; i < table.columns().size(); ++i) cells.emplace_back(table.cell(number, i));
  return cells;
}

/// Place and message of each error, "2:5 message".
std::vector<std::string> errors(const std::string& contents) {
  Diagnostics diagnostics;
  const CsvTable table = read(contents, diagnostics);
  for (std::size_t i = 0; i < table.columns().size(); ++i) {
    if (table.columns()[i].name[0] == 'n') table.number_column(i, diagnostics);
  }
  std::vector<std::string> result;
  for (const Diagnostic& d : diagnostics.all()) {
    result.push_back(std::to_string(d.where.line) + ":" + std::to_string(d.where.column) + " " + d.message);
  }
  return result;
}

/// What was said and where, one below the other, in alphabetical order.
std::vector<std::string> said(const Diagnostics& diagnostics) {
  std::vector<std::string> all;
  for (const Diagnostic& each : diagnostics.all()) all.push_back(format(each));
  std::sort(all.begin(), all.end());
  return all;
}

using Words = std::vector<std::string>;
using Sizes = std::vector<std::size_t>;

}  // namespace

TEST_CASE("a catalogue file is read") {
  const CsvTable table = read_clean(
      "# Steppers, as sold in 2024\n#   prices without tax\n\n"
      "manufacturer,part_number,holding_torque [N.cm],price\n"
      "StepperOnline,23HS22,126,24.33\n"
      "\"Maker, Sons\",\"5\"\" rotor\", 12.5 ,\n");
  REQUIRE(table.comments().size() == 2);
  CHECK(table.comments()[0].text == "Steppers, as sold in 2024");
  CHECK(table.comments()[1].text == "prices without tax");
  CHECK(table.comments()[1].span.line == 2);
  REQUIRE(table.columns().size() == 4);
  const CsvColumn& torque = table.columns()[2];
  CHECK(torque.name == "holding_torque");
  CHECK(torque.unit == "N.cm");
  CHECK(torque.name_span.line == 4);
  CHECK(torque.name_span.column == 26);
  CHECK(torque.name_span.length == 14);
  CHECK(torque.unit_span.column == 42);
  CHECK(torque.unit_span.length == 4);
  CHECK_FALSE(table.columns()[3].unit);
  CHECK(table.find_column("price") == 3);
  CHECK_FALSE(table.find_column("colour"));
  CHECK(table.header_span().line == 4);
  REQUIRE(table.row_count() == 2);
  CHECK(row(table, 1) == Words{"Maker, Sons", "5\" rotor", "12.5", ""});
  CHECK(table.cell_span(1, 0).column == 2);
  CHECK(table.cell_span(1, 2).line == 6);
  CHECK(table.cell_span(1, 2).column == 28);
  CHECK(table.cell_span(1, 2).length == 4);
  CHECK(table.row_span(1).line == 6);
  CHECK(table.text_column(1) == std::vector<std::string_view>{"23HS22", "5\" rotor"});
  Diagnostics diagnostics;
  const auto prices = table.number_column(3, diagnostics);
  CHECK(prices[0] == 24.33);
  CHECK(std::isnan(prices[1]));
  CHECK(table.number(0, 2, diagnostics) == 126.0);
  CHECK_FALSE(table.number(1, 3, diagnostics));
  CHECK(diagnostics.count() == 0);
}

TEST_CASE("line ends, byte order mark, last line without end") {
  for (const std::string& end : {std::string("\n"), std::string("\r\n")}) {
    for (const std::string& last : {std::string(), end}) {
      const CsvTable table = read_clean(
          "\xEF\xBB\xBF"
          "a,b" +
          end + "1,x" + end + end + "2,y" + last);
      CHECK(table.columns()[0].name == "a");
      REQUIRE(table.row_count() == 2);
      CHECK(row(table, 0) == Words{"1", "x"});
      CHECK(row(table, 1) == Words{"2", "y"});
      CHECK(table.cell_span(1, 1).line == 4);
      CHECK(table.cell_span(1, 1).column == 3);
      CHECK(table.cell_span(1, 1).length == 1);
    }
  }
}

TEST_CASE("quoted cells may hold separators, quotes and line ends") {
  const CsvTable table = read_clean("a,b\n\"two\nlines, \"\"x\"\"\",2\r\n \"\" , \" y \" \n");
  REQUIRE(table.row_count() == 2);
  CHECK(row(table, 0) == Words{"two\nlines, \"x\"", "2"});
  CHECK(table.cell_span(0, 1).line == 3);
  CHECK(table.cell_span(0, 1).column == 15);
  CHECK(row(table, 1) == Words{"", " y "});
  CHECK(table.cell_span(1, 1).line == 4);
}

TEST_CASE("positions count characters behind tabs and µ") {
  CHECK(errors("a,n\nµ°\t,x\n") == Words{"2:5 n: not a number: 'x'"});
  CHECK(errors("a;n\r\n\"€,;\";x\r\n") == Words{"2:7 n: not a number: 'x'"});
}

TEST_CASE("the separator is told from the header") {
  CHECK(read_clean("a;b;c\n1,5;2;3\n").separator() == ';');
  CHECK(read_clean("a,b;c,d\n1,2,3\n").separator() == ',');
  CHECK(read_clean("\"a;b;c\",d\n1,2\n").separator() == ',');
  CHECK(read_clean("a [N;m;s],b\n1,2\n").columns()[0].unit == "N;m;s");
  CHECK(read_clean("one\n1\n").separator() == ',');
  CHECK(read_clean("# a;b;c;d\nx,y\n1,2\n").separator() == ',');
  const CsvTable named = read_clean("sep=;\r\na;b\r\n1;2\r\n");
  CHECK(named.separator() == ';');
  CHECK(named.columns().size() == 2);
}

TEST_CASE("decimal commas count where semicolons separate") {
  const CsvTable table = read_clean("n;m\n1,5;2.5\n\"-2,25\";3\n4;\n");
  Diagnostics diagnostics;
  CHECK(table.number_column(0, diagnostics) == std::vector<double>{1.5, -2.25, 4});
  CHECK(table.number_column(1, diagnostics)[1] == 3);
  CHECK(diagnostics.count() == 0);
  CHECK(errors("n;a\n1,5;\n2.5;\n3.5;\n4,5;\n") == Words{"3:1 n: decimal commas and decimal points in one column"});
  CHECK(errors("n;a\n1.234,5;\n") == Words{"2:1 n: not a number: '1.234,5'"});
}

TEST_CASE("a comma in a comma-separated number is refused, with a hint") {
  Diagnostics diagnostics;
  const CsvTable table = read("name,torque [N.m]\nA,\"1,5\"\n", diagnostics);
  CHECK(std::isnan(table.number_column(1, diagnostics)[0]));
  CHECK(format(diagnostics) ==
        "c.csv:2:4: error: torque: not a number: '1,5'\n"
        "    2 | A,\"1,5\"\n"
        "      |    ^~~ hint: decimal comma: write 1.5, or separate the cells of this file by ;\n"
        "1 error\n");
}

TEST_CASE("the letter O is pointed at") {
  Diagnostics diagnostics;
  const CsvTable table = read("part,torque [N.cm]\r\nA,126\r\nB,\t1O.5\r\n", diagnostics);
  const auto column = table.number_column(1, diagnostics);
  CHECK(column[0] == 126);
  CHECK(std::isnan(column[1]));
  CHECK(format(diagnostics) ==
        "c.csv:3:4: error: torque: not a number: '1O.5'\n"
        "    3 | B,    1O.5\n"
        "      |       ^~~~ hint: letter O where a zero was meant: 10.5\n"
        "1 error\n");
}

TEST_CASE("rows that do not fit the header") {
  CHECK(errors("a,b,c\n1,2\n1,2,3,4\n1,2,3\n") ==
        Words{"2:4 row of 2 cells, but the header has 3", "3:7 row of 4 cells, but the header has 3"});
  CHECK(errors("a,b,c\n1,2\r\n# later\n") == Words{"2:4 row of 2 cells, but the header has 3"});
  Diagnostics diagnostics;
  const CsvTable table = read("a,b\n1\n2,3\n", diagnostics);
  CHECK(table.row_count() == 1);
  CHECK(table.cell(0, 1) == "3");
  CHECK(diagnostics.all()[0].hint == "the cell of 'b' and what follows is missing");
}

TEST_CASE("comments stand between the rows and behind them too") {
  const CsvTable table = read_clean(
      "# top\na,b\n1,2\n# a 3\" screw, and more, cells\n  # indented\n\t#x,y\n3,4\n#taken,out\n# 5 pieces, in all\n");
  REQUIRE(table.row_count() == 2);
  CHECK(row(table, 1) == Words{"3", "4"});
  CHECK(table.cell_span(1, 0).line == 7);
  CHECK(table.comments().size() == 1);  // what the file says of itself
  CHECK(read_clean("a,b\n1,2\n#").row_count() == 1);
  CHECK(read_clean("a,b\r\n1,2\r\n# end\r\n").row_count() == 1);
  CHECK(read_clean("a,b\n\"#1\",2\n\"x\n# in a cell\",3\n").row_count() == 2);
  // A row that may be meant as one is not lost.
  CHECK(errors("a,b\n#10-24,2\n#8 alone\n1,2\n") == Words{"2:1 comment or row? '#10-24' with 2 cells"});
}

TEST_CASE("empty rows and empty surplus cells of spreadsheets are ignored") {
  const CsvTable table = read_clean("a,b,,\n1,2,,\n,,,\n\"\",\"\"\n   \n3,4\n5,6,,,,,\n,7,,\n");
  CHECK(table.columns().size() == 2);
  REQUIRE(table.row_count() == 4);
  CHECK(row(table, 1) == Words{"3", "4"});
  CHECK(row(table, 2) == Words{"5", "6"});
  CHECK(row(table, 3) == Words{"", "7"});
  CHECK(read_clean("a\n1\n\n2\n").row_count() == 2);
}

TEST_CASE("bad quotes are reported and the rows after them are read") {
  CHECK(errors("a,b\n5\" pipe,1\n2,3\n") == Words{"2:2 quote inside a cell that is not quoted"});
  CHECK(errors("a,b\n\"x\"y,1\n2,3\n") == Words{"2:4 text after the closing quote of a cell"});
  CHECK(errors("a,b\n\"x,1\n2,3\n") == Words{"2:1 quote is never closed"});
  Diagnostics diagnostics;
  const CsvTable table = read("a,b\n1,\"x\n2,3\n", diagnostics);
  REQUIRE(table.row_count() == 1);
  CHECK(table.cell(0, 0) == "2");
}

TEST_CASE("headers that are wrong") {
  CHECK(errors("a,b,a\n") == Words{"1:5 two columns of the name 'a'"});
  CHECK(errors("a,,c\n") == Words{"1:3 a column without a name"});
  CHECK(errors("a,[mm]\n") == Words{"1:3 a column without a name"});
  CHECK(errors("a,b [mm\n") == Words{"1:5 the unit of a column must end with ']', and nothing may follow it"});
  CHECK(errors("a,b [mm] x\n") == Words{"1:5 the unit of a column must end with ']', and nothing may follow it"});
  CHECK(errors("a,b mm]\n") == Words{"1:3 ']' without '['"});
  CHECK(errors("a\tb\tc\n1\t2\t3\n") == Words{"1:1 cells separated by tabs"});
  CHECK(errors("") == Words{"0:0 is empty: a header was expected"});
  CHECK(errors("\xEF\xBB\xBF") == Words{"0:0 is empty: a header was expected"});
  CHECK(errors("# only\n\n# comments\n") == Words{"0:0 has no header"});
  CHECK(errors("a,\"b\n1,2\n") == Words{"1:3 quote is never closed"});
  CHECK(read_clean("a []\n").columns()[0].unit == "");
  const CsvColumn quoted_name = read_clean("x,\"torque, \"\"peak\"\" [N.m]\"\n").columns()[1];
  CHECK(quoted_name.name == "torque, \"peak\"");
  CHECK(quoted_name.unit == "N.m");
  CHECK(quoted_name.unit_span.column == 3);
}

TEST_CASE("old Macintosh line ends are named") {
  CHECK(errors("a,b\r1,2\r") == Words{"1:4 carriage return inside a line"});
}

TEST_CASE("bytes that are not text are reported at their place") {
  CHECK(errors(std::string("a,b\n1,\0002\n", 9)) == Words{"2:3 NUL byte"});
  CHECK(errors("a,b\n1,\xE9\n") == Words{"2:3 byte \\xE9 is not UTF-8"});
  CHECK(errors(std::string(100000, '\x01')) ==
        Words{"0:0 not a text file: control character \\x01 in line 1, column 1"});
}

TEST_CASE("hostile tables end quickly in one clear error") {
  std::string wide;
  for (int i = 0; i < 1000000; ++i) wide += "c" + std::to_string(i) + ",";
  const auto found = errors(wide + "\n" + wide + "\n");
  REQUIRE(found.size() == 1);
  CHECK(found[0].substr(0, 32) == "1:1 a header of 1000000 columns ");
  CHECK(errors("a,n\n1," + std::string(10000000, '9') + "\n") ==
        Words{"2:3 n: not a number: '" + std::string(40, '9') + "...'"});
  CHECK(errors("a,b\n" + std::string(1000000, ',') + "x\n") ==
        Words{"2:3 " + std::string("row of 1000001 cells, but the header has 2")});
  // More cells in a line are not even kept to be counted.
  CHECK(errors("a,b\n1,2\n" + std::string(10000000, ',') + "\n3,4,5\n") ==
        Words{"3:1 more than 1048576 cells in a line: this is no table of parts",
              "4:5 row of 3 cells, but the header has 2"});
  CHECK(errors("a,b\n" + std::string(3000000, '"')).size() == 1);
}

TEST_CASE("a table of nothing but separators costs no more memory than its cells are allowed") {
  if (millwright::sanitized) return;  // half a gigabyte, and several times that there
  // 1024 columns, of which each row has the first: a byte a cell, a row more than there may be.
  std::string header;
  for (int i = 0; i < 1024; ++i) header += (i == 0 ? "c" : ",c") + std::to_string(i);
  const std::string line = "1" + std::string(1023, ',') + "\n";
  const std::size_t most = table_cell_limit / 1025 + 1;
  std::string contents = header + "\n";
  contents.reserve(contents.size() + (most + 1) * line.size());
  for (std::size_t i = 0; i < most; ++i) contents += line;
  Diagnostics diagnostics;
  CHECK(read(contents, diagnostics).row_count() == most);
  CHECK(diagnostics.count() == 0);
  contents += line;
  const CsvTable table = read(contents, diagnostics);
  CHECK(table.row_count() == most);
  REQUIRE(diagnostics.count() == 1);
  CHECK(diagnostics.all()[0].where.line == static_cast<int>(most) + 2);
  CHECK(diagnostics.all()[0].message.find("134217728 cells") != std::string::npos);
  // Read some rows at a time it is allowed as many.
  Diagnostics again;
  CsvReader reader(SourceText::from_string("c.csv", contents), again, CsvReader::few);
  CHECK(reader.most_rows() <= most + 2);
  std::size_t rows = 0;
  do {
    rows += reader.table().row_count();
  } while (reader.next());
  CHECK(rows == most);
  REQUIRE(again.count() == 1);
  CHECK(again.all()[0].where.line == static_cast<int>(most) + 2);
}

TEST_CASE("read some rows at a time a table is the same, and so is what is said of it") {
  const std::string contents =
      "# top\n \"a\"\"b\" ;n [mm];n2\n"
      "x;1,5;1\n# between\n  y "
      ";2,5;2\n\n\"q\"\"r\";x;3\nshort;1\n;;\nlong;1;2;3\n\"two\nlines\";4.5;6\n\"bad\"x;1;1\nz;7,5;7.5;;\n\n";
  Diagnostics told;
  const CsvTable whole = read(contents, told);
  (void)whole.number_columns(Sizes{1, 2}, told);
  REQUIRE(whole.row_count() == 5);
  REQUIRE(told.count() == 5);  // not a number, too short, too long, text after a quote, decimal point after comma
  for (std::size_t few = 1; few <= 6; ++few) {
    Diagnostics again;
    CsvReader reader(SourceText::from_string("c.csv", contents), again, few);
    CHECK(reader.most_rows() >= 5);
    CHECK(reader.most_rows() < 20);
    std::vector<NumberColumn> numbers{{1, {}, {}, {}}, {2, {}, {}, {}}};
    std::size_t seen = 0;
    do {
      const CsvTable& some = reader.table();
      CHECK(some.row_count() <= few);
      some.read_numbers(numbers, again);
      for (std::size_t i = 0; i < some.row_count(); ++i, ++seen) {
        REQUIRE(seen < whole.row_count());
        CHECK(row(some, i) == row(whole, seen));
        CHECK(some.record_offset(i) == whole.record_offset(seen));
        for (std::size_t column = 0; column < 3; ++column)
          CHECK(some.cell_span(i, column).line == whole.cell_span(seen, column).line);
      }
    } while (reader.next());
    CHECK(seen == whole.row_count());
    CHECK_FALSE(reader.next());
    CHECK(numbers[0].values.size() == 5);
    CHECK(numbers[0].values[3] == 4.5);
    CHECK(numbers[1].values == std::vector<double>{1, 2, 3, 6, 7.5});
    CHECK(said(again) == said(told));
    for (const Diagnostic& each : again.all()) {
      if (!each.related) continue;
      const bool marks = each.message.find("decimal") != std::string::npos;
      CHECK(each.related->line == (marks ? 3 : 13));
      CHECK(each.related->column == (marks ? 3 : 1));
    }
  }
}

TEST_CASE("blank lines make no room for rows") {
  Diagnostics told;
  const CsvReader reader(
      SourceText::from_string("c.csv", "a;b;c;d\n" + std::string(100000, '\n')), told, CsvReader::few);
  CHECK(reader.table().row_count() == 0);
  CHECK(reader.most_rows() == 25001);
}

TEST_CASE("a million wrong cells are counted, not printed") {
  std::string contents = "n,a\n";
  for (int i = 0; i < 1000000; ++i) contents += i % 2 == 0 ? "x,y\n" : "1\n";
  Diagnostics diagnostics;
  const CsvTable table = read(contents, diagnostics);
  table.number_column(0, diagnostics);
  CHECK(diagnostics.error_count() == 1000000);
  CHECK(diagnostics.all().size() == 51);
  // All on one line: the places must not be worked out for each.
  std::string header;
  std::string values;
  for (int i = 0; i < 1000; ++i) {
    header += "n" + std::to_string(i) + ",";
    values += "bad" + std::string(5000, 'x') + ",";
  }
  const CsvTable one = read(header + "\n" + values + "\n", diagnostics);
  for (std::size_t i = 0; i < 1000; ++i) one.number_column(i, diagnostics);
  CHECK(diagnostics.error_count() == 1001000);
}

// strtod() rounds correctly; every digit of what is read must be the same.
TEST_CASE("figures of any length are read to the last bit") {
  std::mt19937_64 random(17);
  std::vector<std::string> written = {"0",
                                      "0.0",
                                      "1",
                                      "9007199254740993",
                                      "999999999999999",
                                      "0.000000000000001",
                                      "123456789012345.6",
                                      "12345678901234.5",
                                      "1e3",
                                      "5.",
                                      ".5",
                                      "-2.5",
                                      "00012.50",
                                      "0.1",
                                      "2.675",
                                      "1.005",
                                      "179769313486231570000",
                                      "1.7976931348623157e308"};
  for (int i = 0; i < 20000; ++i) {
    const std::size_t whole = random() % 10, part = random() % 10;
    std::string text;
    for (std::size_t digit = 0; digit <= whole; ++digit) text += static_cast<char>('0' + random() % 10);
    if (part > 0) text += '.';
    for (std::size_t digit = 0; digit < part; ++digit) text += static_cast<char>('0' + random() % 10);
    written.push_back(text);
  }
  std::string contents = "name,number\n";
  for (const std::string& text : written) contents += "x," + text + "\n";
  const CsvTable table = read_clean(contents);
  Diagnostics diagnostics;
  const std::vector<double> values = table.number_column(1, diagnostics);
  REQUIRE(values.size() == written.size());
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < written.size(); ++i) {
    if (std::isnan(values[i])) continue;  // not what the reader takes for a number
    wrong += std::bit_cast<std::uint64_t>(values[i]) !=
             std::bit_cast<std::uint64_t>(std::strtod(written[i].c_str(), nullptr));
  }
  CHECK(wrong == 0);
  CHECK(std::count_if(values.begin(), values.end(), [](double value) { return std::isnan(value); }) <= 2);
  for (const char* bad : {"1.2.3", "1 2", "12a", "1,2"}) {
    Diagnostics told;
    const CsvTable one = read("name,number\nx," + std::string(bad) + "\n", told);
    (void)one.number_column(1, told);
    CHECK(told.error_count() == 1);
  }
}

}  // namespace csv_test
