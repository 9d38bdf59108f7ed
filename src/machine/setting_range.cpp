// SPDX-License-Identifier: Apache-2.0
#include "machine/setting_range.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>

#include "machine/option_word.h"

namespace millwright::machine {

namespace {

constexpr const char* example = "--set axis.x.moves[0].time='0.2:0.5:7 s' (from 0.2 s to 0.5 s, 7 values)";

/// Text between two colons: a number with perhaps a unit, and where it begins in the value.
struct Piece {
  std::optional<double> number;
  std::string unit;
  std::size_t at = 0, size = 0;
};

Piece piece_of(std::string_view value, std::size_t begin, std::size_t end) {
  while (begin < end && value[begin] == ' ') ++begin;
  while (end > begin && value[end - 1] == ' ') --end;
  Piece piece{{}, {}, begin, end - begin};
  const std::string_view text = value.substr(begin, end - begin);
  double number = 0.0;
  const auto [rest, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (failure != std::errc{} || !std::isfinite(number)) return piece;
  std::string_view unit = text.substr(static_cast<std::size_t>(rest - text.data()));
  if (!unit.empty() && unit.front() != ' ') return piece;  // "0.2s" is no number with a unit anywhere
  unit.remove_prefix(std::min(unit.find_first_not_of(' '), unit.size()));
  piece.number = number;
  piece.unit = unit;
  return piece;
}

std::vector<Piece> pieces_of(std::string_view value) {
  std::vector<Piece> pieces;
  std::size_t begin = 0;
  for (std::size_t colon = value.find(':'); colon != std::string_view::npos; colon = value.find(':', begin)) {
    pieces.push_back(piece_of(value, begin, colon));
    begin = colon + 1;
  }
  pieces.push_back(piece_of(value, begin, value.size()));
  return pieces;
}

/// The unit of all pieces; nothing if two differ.
std::optional<std::string> common_unit(const std::vector<Piece>& pieces) {
  std::string unit;
  for (const Piece& piece : pieces) {
    if (piece.unit.empty()) continue;
    if (!unit.empty() && unit != piece.unit) return std::nullopt;
    unit = piece.unit;
  }
  return unit;
}

}  // namespace

bool is_setting_range(const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos) return false;
  const std::vector<Piece> pieces = pieces_of(std::string_view(assignment).substr(equals + 1));
  return pieces.size() > 1 && pieces.front().number.has_value();
}

std::optional<SettingRange> read_setting_range(const std::string& assignment, text::Diagnostics& diagnostics) {
  const auto word = read_option_word("--set", assignment, example, diagnostics);
  if (!word) return std::nullopt;
  const auto refuse = [&](const Piece& at, const std::string& message, const std::string& hint) {
    diagnostics.error(word->value_span(at.at, at.size), fmt::format("{}: {}", word->name, message), hint);
    return std::nullopt;
  };
  const std::vector<Piece> pieces = pieces_of(word->value);
  const Piece all{{}, {}, 0, word->value.size()};
  if (pieces.size() != 3) return refuse(all, "a range is FROM:TO:COUNT", fmt::format("write for example {}", example));
  for (const Piece& piece : pieces)
    if (!piece.number)
      return refuse(piece, "this is no number with perhaps a unit", fmt::format("write for example {}", example));
  const double from = *pieces[0].number;
  const double to = *pieces[1].number;
  const double count = *pieces[2].number;
  if (count != std::floor(count) || count < 2.0 || count > static_cast<double>(most_range_values))
    return refuse(pieces[2],
                  fmt::format("a range has 2 to {} values", most_range_values),
                  "the count stands behind the second ':'");
  if (from == to) return refuse(all, "both ends of the range are the same", "write one value, without ':'");
  const auto unit = common_unit(pieces);
  if (!unit) return refuse(all, "the ends of the range have different units", "write one unit, at the end");
  SettingRange range;
  range.path = word->name;
  range.unit = *unit;
  const auto last = static_cast<std::size_t>(count) - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(last);
    const std::string number = fmt::format("{:.12g}", i == last ? to : from + (to - from) * share);
    range.values.push_back(std::strtod(number.c_str(), nullptr));
    range.texts.push_back(unit->empty() ? number : number + " " + *unit);
  }
  return range;
}

}  // namespace millwright::machine
