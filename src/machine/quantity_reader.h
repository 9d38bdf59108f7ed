// SPDX-License-Identifier: Apache-2.0
//
// Quantities with units from tables of a problem file: one door, so that a bare number, an unknown unit, a wrong
// dimension or a magnitude that no machine has is reported in the same words everywhere, at the wrong word itself.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "machine/problem.h"
#include "text/diagnostic.h"
#include "text/table_reader.h"

namespace millwright::machine {

/// What values make sense.
enum class Sign { any, not_negative, positive };

/// What is usual in a unit of this program: an example to show, and the magnitudes (SI) between which a value is taken
/// seriously. What lies outside has a wrong unit or a slip in its exponent.
struct UsualValues {
  std::string_view unit;
  std::string_view example;  ///< as it is written in a problem file, without quotes
  double smallest;           ///< of a value that must be greater than zero
  double largest;
};

/// Usual values of a unit that a reader asks for; any finite number where the unit is not in the list.
UsualValues usual_values(std::string_view unit);

/// An SI value as it would be written in a problem file ("50 mm" in quotes, 0.5); empty if it is not finite.
std::string as_written(double value, std::string_view unit);

/// Why a quantity cannot be read, taken apart: what is wrong, what to do, and which bytes of the text it is about.
struct QuantityFault {
  std::string message, hint;
  std::size_t offset = 0, length = 0;
};

/// Reads `text` as a quantity of the unit's dimension, in SI. On failure nothing, and why in `fault`. Also refuses what
/// has the wrong sign or is no magnitude of a machine.
std::optional<double> read_quantity(std::string_view text, std::string_view unit, Sign sign, QuantityFault& fault);

/// Checks sign and magnitude of an SI value that is already there.
bool check_magnitude(double value, std::string_view unit, Sign sign, QuantityFault& fault);

class QuantityReader {
 public:
  QuantityReader(text::TableReader& table, text::Diagnostics& diagnostics) : table_(table), diagnostics_(diagnostics) {}

  /// A quantity of the unit's dimension, in SI; dimensionless ones may be bare numbers.
  std::optional<double> quantity(const text::Key& key,
                                 std::string_view unit,
                                 Sign sign = Sign::not_negative,
                                 text::Presence presence = text::Presence::optional);
  /// The same with a default.
  double quantity_or(const text::Key& key, std::string_view unit, double fallback, Sign sign = Sign::not_negative);
  /// A plain number from 0 to 1; without 0 unless `zero` says so.
  double share_or(const text::Key& key, double fallback, bool zero = false);
  /// A whole number from `least` to `most`.
  double count_or(const text::Key& key, double fallback, int least, int most);
  /// One quantity, or two in a list: ["0.05 s", "0.5 s"].
  std::optional<Range> range(const text::Key& key,
                             std::string_view unit,
                             text::Presence presence = text::Presence::optional);
  /// The quantities of a list (or a single one) to choose from, none of them there twice.
  std::vector<double> choices(const text::Key& key, std::string_view unit);
  /// A quantity from a node, reported at the node. `example`: what a hint advises, where that of the unit would
  /// mislead.
  std::optional<double> of_node(
      const text::Node& node, std::string_view what, std::string_view unit, Sign sign, std::string_view example = {});

  /// Any value that must be there; if it is not, says at the table what to add.
  const text::Node* required(const text::Key& key, std::string_view example);
  /// The same for text, which must not be empty. Empty if it is missing or wrong.
  std::string required_text(const text::Key& key, std::string_view example);
  /// Words of a list (or a single one), none of them empty or there twice. `allowed`: those that the caller takes, for
  /// the reference of the file; it complains of others itself.
  std::vector<std::string> words(const text::Key& key, const std::vector<std::string>& allowed = {});
  /// Says that the value of the key is a quantity that the reader takes with of_node().
  void describe(const text::Key& key, text::Expected expected, std::string_view unit, Sign sign) const;

  /// Reports each of these keys that is there, because it does not belong to this kind of table, and asks no more.
  void refuse(std::initializer_list<std::string_view> keys, const std::string& because, const std::string& hint);

 private:
  [[nodiscard]] text::Question question(const text::Key& key,
                                        text::Expected expected,
                                        std::string_view unit,
                                        Sign sign) const;

  void describe_with(double fallback, text::Question asked) const;

  text::TableReader& table_;
  text::Diagnostics& diagnostics_;
};

}  // namespace millwright::machine
