// SPDX-License-Identifier: Apache-2.0
// XML from anybody, element by element. Built on Expat: liborcus, whose parser is made for workbooks, ends the whole
// program (an assertion) on some damaged files.
#pragma once

#include <cstddef>
#include <string_view>

namespace millwright::text {

/// A name `ns:name` as it is written; `ns` is empty without a colon.
struct XmlElement {
  std::string_view ns;
  std::string_view name;
};

struct XmlAttribute {
  std::string_view ns;
  std::string_view name;
  std::string_view value;
};

/// Hears the attributes of an element, then its beginning, its content and its end. May throw; that ends the reading.
class XmlListener {
 public:
  XmlListener() = default;
  virtual ~XmlListener() = default;
  XmlListener(const XmlListener&) = delete;
  XmlListener& operator=(const XmlListener&) = delete;

  virtual void attribute(const XmlAttribute& attribute) = 0;
  virtual void start_element(const XmlElement& element) = 0;
  virtual void end_element(const XmlElement&) {}
  virtual void characters(std::string_view) {}
};

/// Elements within elements; deeper ones, which cost memory and mean nothing, are refused.
inline constexpr std::size_t deepest_xml = 256;

/// Throws std::runtime_error, with line and column, where the XML is not well-formed, is nested deeper than that or
/// declares a document type (of which harmful files are made). What the listener throws is passed on.
void read_xml(std::string_view xml, XmlListener& listener);

}  // namespace millwright::text
