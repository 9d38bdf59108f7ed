// SPDX-License-Identifier: Apache-2.0
// Text that may stand in a page: everything that people wrote goes through here.
#pragma once

#include <string>
#include <string_view>

namespace millwright::report {

/// For content and quoted attributes: & < > " ' replaced; control characters and bytes that are no UTF-8 become U+FFFD.
std::string escaped(std::string_view text);

/// A word for an id or a link's end: letters, digits and '-' stay, all else becomes '_' and its code.
std::string identifier(std::string_view text);

/// JSON inside a <script> element: what could end the element or begin a comment is written as \u003c.
std::string json_in_script(std::string json);

/// A unit as it is printed: "kg.cm2" as "kg·cm²", "um" as "µm", "deg" as "°"; "1" is empty.
std::string shown_unit(std::string_view unit);

/// A value in its unit, "12.3 kg·cm²"; "-" where it is not a number.
std::string shown_quantity(double value, std::string_view unit, int significant = 4);
/// A length in millimetres with its tenths (millimetres_text).
std::string shown_millimetres(double metres);

}  // namespace millwright::report
