// SPDX-License-Identifier: Apache-2.0
// Units and quantities. The first line is the unit that is expected, the second the text that is read.
#include <cmath>

#include "fuzz.h"
#include "machine/quantity_reader.h"
#include "scalar/unit.h"

using namespace millwright;

namespace {

void check_quantity(const std::string& text, const scalar::Unit& expected) {
  std::string reason;
  const auto quantity = scalar::parse_quantity(text, expected, reason);
  fuzz::require(quantity || !reason.empty(), "what is refused is complained about", text);
  if (!quantity) return;
  fuzz::require(std::isfinite(quantity->si), "a quantity is finite", text);
  fuzz::require(quantity->unit.dimension() == expected.dimension(), "a quantity has the dimension that is asked", text);
  const std::string shown = scalar::format(quantity->si, quantity->unit, 17);
  const auto again = scalar::parse_quantity(shown, quantity->unit, reason);
  // Very large and very small ones may leave the range on their way into the unit.
  if (!again || !std::isfinite(quantity->unit.from_si(quantity->si))) return;
  const double error = std::abs(again->si - quantity->si);
  const double shift = std::abs(quantity->unit.to_si(0.0));  // of temperatures
  fuzz::require(error <= 1e-12 * std::max(std::abs(quantity->si), shift) || std::abs(quantity->si) < 1e-300,
                "a quantity that was printed is read as the same",
                text + "\n" + shown);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  std::string_view input = fuzz::view(bytes, size);
  const std::string name(fuzz::first_line(input));
  const std::string text(input);
  std::string reason;
  const auto unit = scalar::Unit::parse(name, reason);
  fuzz::require(unit || !reason.empty(), "what is refused is complained about", name);
  if (unit) {
    const auto again = scalar::Unit::parse(unit->name(), reason);
    fuzz::require(again && *again == *unit, "a unit that was printed is read as the same", name);
    fuzz::require(std::isfinite(unit->to_si(1.0)), "a unit is finite", name);
    check_quantity(text, *unit);
  }
  for (const char* usual : {"mm", "N", "kg.m2", "rpm", "1"}) {
    machine::QuantityFault fault;
    const auto value = machine::read_quantity(text, usual, machine::Sign::any, fault);
    fuzz::require(value || !fault.message.empty(), "what is refused is complained about", text);
    fuzz::require(!value || std::isfinite(*value), "a quantity is finite", text);
    fuzz::require(value || fault.offset + fault.length <= text.size() + 1, "the fault is in the text", text);
  }
  std::string number_reason;
  const auto number = scalar::parse_number(text, number_reason);
  fuzz::require(number ? std::isfinite(*number) : !number_reason.empty(), "a number is finite", text);
  return 0;
}
