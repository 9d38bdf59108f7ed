// SPDX-License-Identifier: Apache-2.0
//
// The names of units: our own table first, then UDUNITS-2 for single names (with its prefixes). UDUNITS-2 never sees an
// expression: it reads `oz.in` as a volume times a length, `m^0.5` as the number 5, and accepts "20 mm" as a unit.
#include <fmt/format.h>
#include <udunits2.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "scalar/unit_definition.h"

namespace millwright::scalar {
namespace {

/// A name of ours: numerator/denominator times a unit expression. Names without expression are base units of ours.
struct Name {
  const char* name;
  double numerator;
  double denominator;
  const char* expression;
  bool prefixes;
};

constexpr double pi_value = std::numbers::pi;
// Exact by definition: inch 25.4 mm, pound 0.45359237 kg, standard gravity 9.80665 m/s² (BIPM SI brochure, NIST SP
// 811).
constexpr Name names[] = {
    {"g", 1, 1000, "kg", true},
    {"rev", 2 * pi_value, 1, "rad", true},
    {"r", 2 * pi_value, 1, "rad", false},
    {"turn", 2 * pi_value, 1, "rad", false},
    {"turns", 2 * pi_value, 1, "rad", false},
    {"deg", pi_value, 180, "rad", true},
    {"degree", pi_value, 180, "rad", false},
    {"degrees", pi_value, 180, "rad", false},
    {"arcmin", pi_value, 10800, "rad", false},
    {"arcsec", pi_value, 648000, "rad", true},
    {"rpm", 2 * pi_value, 60, "rad/s", true},
    {"RPM", 2 * pi_value, 60, "rad/s", false},
    {"rps", 2 * pi_value, 1, "rad/s", false},
    {"steps", 1, 1, "step", false},
    {"pulse", 1, 1, "step", false},
    {"pulses", 1, 1, "step", false},
    {"pps", 1, 1, "step/s", true},
    {"Hz", 1, 1, "s^-1", true},
    {"in", 254, 10000, "m", false},
    {"inch", 254, 10000, "m", false},
    {"inches", 254, 10000, "m", false},
    {"ft", 3048, 10000, "m", false},
    {"mil", 254, 10000000, "m", false},
    {"lb", 45359237, 100000000, "kg", false},
    {"lbs", 45359237, 100000000, "kg", false},
    {"lbm", 45359237, 100000000, "kg", false},
    {"oz", 45359237, 1600000000, "kg", false},
    {"lbf", 44482216152605, 10000000000000, "N", false},
    {"ozf", 44482216152605, 160000000000000, "N", false},
    {"kgf", 980665, 100000, "N", false},
    {"kp", 980665, 100000, "N", false},
    {"gf", 980665, 100000000, "N", false},
    {"tf", 980665, 100, "N", false},
    {"psi", 1, 1, "lbf/in^2", false},
    {"ksi", 1000, 1, "lbf/in^2", false},
    {"bar", 100000, 1, "Pa", true},
    {"Nm", 1, 1, "N*m", true},
    {"Ncm", 1, 100, "N*m", false},
    {"Nmm", 1, 1000, "N*m", false},
    {"Wh", 3600, 1, "J", true},
    {"Ws", 1, 1, "J", true},
    {"hp", 550, 1, "ft*lbf/s", false},
    {"PS", 75, 1, "kgf*m/s", false},
    {"ohm", 1, 1, "V/A", true},
    {"L", 1, 1000, "m^3", true},
    {"l", 1, 1000, "m^3", true},
    {"cc", 1, 1000000, "m^3", false},
    {"percent", 1, 100, "", false},
    {"permille", 1, 1000, "", false},
    {"ppm", 1, 1000000, "", false},
};

constexpr const char* currencies[] = {"USD", "EUR", "GBP", "CHF", "JPY", "CNY", "INR", "CAD", "AUD", "SEK", "NOK",
                                      "DKK", "PLN", "CZK", "HUF", "KRW", "TWD", "BRL", "MXN", "TRY", "ZAR", "SGD",
                                      "HKD", "NZD", "THB", "IDR", "MYR", "VND", "RUB", "UAH", "ILS", "AED", "COP"};

/// Names UDUNITS-2 knows but an engineer would be misled by, with what to write instead.
constexpr std::pair<const char*, const char*> refused[] = {
    {"ton", "write t for the tonne of 1000 kg or short_ton for 2000 lb"},
    {"tons", "write t for the tonne of 1000 kg or short_ton for 2000 lb"},
    {"cps", "write Hz for a frequency or rps for revolutions per second"},
    {"cycle", "write rev for a revolution, and Hz for cycles per second"},
    {"cycles", "write rev for a revolution, and Hz for cycles per second"},
    {"circle", "write rev for a revolution"},
    {"pi", "a unit is a name, not a number"},
    {"count", "a count has no unit"},
    {"bit", "it is not a unit of mechanics"},
    {"byte", "it is not a unit of mechanics"},
    {"octet", "it is not a unit of mechanics"},
    {"u", "write um for the micrometre"},
};

constexpr std::pair<const char*, double> prefixes[] = {{"da", 1e1},
                                                       {"G", 1e9},
                                                       {"M", 1e6},
                                                       {"k", 1e3},
                                                       {"h", 1e2},
                                                       {"d", -1e1},
                                                       {"c", -1e2},
                                                       {"m", -1e3},
                                                       {"u", -1e6},
                                                       {"n", -1e9}};

/// Candidates for "did you mean" besides the names above.
constexpr const char* common_names[] = {
    "m",   "mm",   "cm",  "km",  "um",   "nm",   "s",    "ms",   "us",  "min", "h",    "kg",          "mg", "N",
    "kN",  "mN",   "MN",  "Pa",  "kPa",  "MPa",  "GPa",  "J",    "kJ",  "Wh",  "kWh",  "W",           "kW", "mW",
    "MW",  "V",    "mV",  "kV",  "A",    "mA",   "H",    "mH",   "uH",  "K",   "C",    "F",           "uF", "T",
    "rad", "mrad", "kHz", "MHz", "degC", "degF", "krpm", "kpps", "mNm", "kNm", "mbar", "ounce_force", "t",  "%"};

UnitDefinition scaled(UnitDefinition unit, double numerator, double denominator) {
  unit.numerator *= numerator;
  unit.denominator *= denominator;
  return unit;
}

std::optional<UnitDefinition> own_unit(std::string_view name, bool prefixed, std::string& reason) {
  for (const char* code : currencies) {
    if (prefixed || name != code) continue;
    UnitDefinition unit;
    unit.currency = code;
    unit.currency_exponent = 1.0;
    return unit;
  }
  UnitDefinition unit;
  if (name == "rad") unit.angle = 1.0;
  if (name == "step") unit.step = 1.0;
  if (name == "rad" || (name == "step" && !prefixed)) return unit;
  if (name == "kg" && !prefixed) {
    unit.dimension = dimension::mass;
    return unit;
  }
  if (!prefixed && (name == "degC" || name == "celsius" || name == "degF")) {
    unit.dimension = dimension::temperature;
    if (name == "degF") unit.numerator = 5.0;
    if (name == "degF") unit.denominator = 9.0;
    unit.offset = name == "degF" ? 459.67 * 5.0 / 9.0 : 273.15;
    return unit;
  }
  for (const Name& own : names) {
    if (own.name != name || (prefixed && !own.prefixes)) continue;
    const auto meaning = unit_expression(own.expression, reason);
    if (!meaning) throw std::logic_error(fmt::format("unit table, {}: {}", own.name, reason));
    return scaled(*meaning, own.numerator, own.denominator);
  }
  return std::nullopt;
}

/// Walks a UDUNITS-2 unit down to its base units.
struct Bases {
  UnitDefinition unit;
  bool mechanical = true;
  const ut_unit* product = nullptr;
};

ut_status add_base(const ut_unit* base, int power_of, Bases& bases) {
  const char* symbol = ut_get_symbol(base, UT_ASCII);
  const std::string_view name = symbol == nullptr ? "" : symbol;
  Dimension& d = bases.unit.dimension;
  double* const exponent = name == "kg"    ? &d.kilogram
                           : name == "m"   ? &d.metre
                           : name == "s"   ? &d.second
                           : name == "A"   ? &d.ampere
                           : name == "K"   ? &d.kelvin
                           : name == "rad" ? &bases.unit.angle
                                           : nullptr;
  if (exponent == nullptr) {
    bases.mechanical = false;
  } else {
    *exponent += power_of;
  }
  return UT_SUCCESS;
}
ut_status visit_basic(const ut_unit* unit, void* bases) {
  static_cast<Bases*>(bases)->product = unit;
  return add_base(unit, 1, *static_cast<Bases*>(bases));
}
ut_status visit_product(const ut_unit* unit, int count, const ut_unit* const* basic, const int* powers, void* bases) {
  static_cast<Bases*>(bases)->product = unit;
  for (int i = 0; i < count; ++i) add_base(basic[i], powers[i], *static_cast<Bases*>(bases));
  return UT_SUCCESS;
}
ut_status visit_logarithmic(const ut_unit*, double, const ut_unit*, void* bases) {
  static_cast<Bases*>(bases)->mechanical = false;
  return UT_SUCCESS;
}
ut_status visit_timestamp(const ut_unit*, const ut_unit*, double, void* bases) {
  static_cast<Bases*>(bases)->mechanical = false;
  return UT_SUCCESS;
}
const ut_visitor& visitor();
ut_status visit_galilean(const ut_unit*, double, const ut_unit* underlying, double, void* bases) {
  return ut_accept_visitor(underlying, &visitor(), bases);
}
const ut_visitor& visitor() {
  static const ut_visitor instance = {visit_basic, visit_product, visit_galilean, visit_timestamp, visit_logarithmic};
  return instance;
}

ut_system* unit_system() {
  static ut_system* const system = [] {
    ut_set_error_message_handler(ut_ignore);
    return ut_read_xml(nullptr);
  }();
  if (system == nullptr)
    throw std::runtime_error("the unit database of UDUNITS-2 cannot be read (package libudunits2-data)");
  return system;
}

/// 0.001 as 1/1000, so that conversions round once.
void take_scale(UnitDefinition& unit, double scale) {
  const double inverse = std::round(1.0 / scale);
  if (scale < 1.0 && inverse < 1e15 && std::fabs(scale * inverse - 1.0) < 1e-15) {
    unit.denominator = inverse;
  } else {
    unit.numerator = scale;
  }
}

std::optional<UnitDefinition> library_unit(const std::string& name, std::string& reason) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  if (!std::all_of(name.begin(), name.end(), is_letter)) return std::nullopt;
  ut_unit* const parsed = ut_parse(unit_system(), name.c_str(), UT_UTF8);
  if (parsed == nullptr) return std::nullopt;
  Bases bases;
  ut_accept_visitor(parsed, &visitor(), &bases);
  if (bases.mechanical && bases.product != nullptr) {
    if (cv_converter* const converter = ut_get_converter(parsed, const_cast<ut_unit*>(bases.product))) {
      bases.unit.offset = cv_convert_double(converter, 0.0);
      take_scale(bases.unit, cv_convert_double(converter, 1.0) - bases.unit.offset);
      cv_free(converter);
    } else {
      bases.mechanical = false;
    }
  }
  ut_free(parsed);
  if (bases.mechanical) return bases.unit;
  reason = fmt::format("'{}' is not a unit that mechanics uses", name);
  return std::nullopt;
}

/// Distance between two names in half edits: a difference of case counts 1, however many letters if it is the only
/// difference; any other edit (or swap) counts 2.
int distance(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  if (std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](char x, char y) { return lower(x) == lower(y); }))
    return 1;
  std::vector<std::vector<int>> cost(a.size() + 1, std::vector<int>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        cost[i][j] = static_cast<int>(2 * (i + j));
        continue;
      }
      const int change = a[i - 1] == b[j - 1] ? 0 : lower(a[i - 1]) == lower(b[j - 1]) ? 1 : 2;
      cost[i][j] = std::min({cost[i - 1][j] + 2, cost[i][j - 1] + 2, cost[i - 1][j - 1] + change});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 2);
      }
    }
  }
  return cost[a.size()][b.size()];
}

std::string nearest_name(std::string_view name) {
  std::string best;
  int least = name.size() <= 1 ? 2 : name.size() <= 2 ? 3 : name.size() <= 5 ? 4 : 5;  // exclusive
  const auto consider = [&](std::string_view candidate) {
    const std::size_t longer = std::max(name.size(), candidate.size()) - std::min(name.size(), candidate.size());
    if (2 * longer >= static_cast<std::size_t>(least)) return;  // so many edits at least
    const int d = distance(name, candidate);
    if (d >= least) return;
    least = d;
    best = candidate;
  };
  for (const char* candidate : common_names) consider(candidate);
  for (const Name& own : names) consider(own.name);
  for (const char* code : currencies) consider(code);
  return best;
}

}  // namespace

std::optional<UnitDefinition> named_unit(std::string_view name, std::string& reason) {
  if (auto unit = own_unit(name, false, reason)) return unit;
  for (const auto& [prefix, factor] : prefixes) {
    if (!name.starts_with(prefix) || name.size() == std::string_view(prefix).size()) continue;
    if (auto unit = own_unit(name.substr(std::string_view(prefix).size()), true, reason)) {
      return factor > 0.0 ? scaled(*unit, factor, 1.0) : scaled(*unit, 1.0, -factor);
    }
  }
  for (const auto& [word, hint] : refused) {
    if (name != word) continue;
    reason = fmt::format("the unit '{}' is ambiguous or no unit here: {}", name, hint);
    return std::nullopt;
  }
  reason.clear();
  if (auto unit = library_unit(std::string(name), reason)) return unit;
  if (reason.empty()) {
    const std::string nearest = nearest_name(name);
    reason = fmt::format("unknown unit '{}'", name);
    if (!nearest.empty()) reason += fmt::format(", did you mean '{}'?", nearest);
  }
  return std::nullopt;
}

}  // namespace millwright::scalar
