// SPDX-License-Identifier: Apache-2.0
#include "text/xml.h"

#include <expat.h>
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <new>
#include <stdexcept>
#include <type_traits>

namespace millwright::text {

namespace {

/// Between Expat, which is C, and a listener that may throw.
struct Reading {
  XML_Parser parser;
  XmlListener& listener;
  std::exception_ptr thrown;
  bool document_type = false;
  std::size_t depth = 0;

  template <class Call>
  void guard(const Call& call) {
    if (thrown) return;
    try {
      call();
    } catch (...) {
      thrown = std::current_exception();
      XML_StopParser(parser, XML_FALSE);
    }
  }
};

XmlElement split(std::string_view name) {
  const std::size_t colon = name.find(':');
  if (colon == std::string_view::npos) return {{}, name};
  return {name.substr(0, colon), name.substr(colon + 1)};
}

void XMLCALL on_start(void* data, const XML_Char* name, const XML_Char** attributes) {
  auto& reading = *static_cast<Reading*>(data);
  reading.guard([&] {
    if (++reading.depth > deepest_xml)
      throw std::runtime_error(fmt::format("elements nested deeper than {} in line {}, column {} of its XML",
                                           deepest_xml,
                                           XML_GetCurrentLineNumber(reading.parser),
                                           XML_GetCurrentColumnNumber(reading.parser) + 1));
    for (; attributes[0] != nullptr; attributes += 2) {
      const XmlElement parts = split(attributes[0]);
      reading.listener.attribute({parts.ns, parts.name, attributes[1]});
    }
    reading.listener.start_element(split(name));
  });
}

void XMLCALL on_end(void* data, const XML_Char* name) {
  auto& reading = *static_cast<Reading*>(data);
  --reading.depth;
  reading.guard([&] { reading.listener.end_element(split(name)); });
}

void XMLCALL on_characters(void* data, const XML_Char* text, int length) {
  auto& reading = *static_cast<Reading*>(data);
  reading.guard([&] { reading.listener.characters({text, static_cast<std::size_t>(length)}); });
}

void XMLCALL on_document_type(void* data, const XML_Char*, const XML_Char*, const XML_Char*, int) {
  auto& reading = *static_cast<Reading*>(data);
  reading.document_type = true;
  XML_StopParser(reading.parser, XML_FALSE);
}

}  // namespace

void read_xml(std::string_view xml, XmlListener& listener) {
  const std::unique_ptr<std::remove_pointer_t<XML_Parser>, decltype(&XML_ParserFree)> parser(XML_ParserCreate(nullptr),
                                                                                             &XML_ParserFree);
  if (!parser) throw std::bad_alloc();
  Reading reading{parser.get(), listener, nullptr, false, 0};
  XML_SetUserData(parser.get(), &reading);
  XML_SetElementHandler(parser.get(), on_start, on_end);
  XML_SetCharacterDataHandler(parser.get(), on_characters);
  XML_SetStartDoctypeDeclHandler(parser.get(), on_document_type);
  constexpr std::size_t step = std::size_t{1} << 20U;  // Expat counts in int, and copies what it is given
  XML_Status status = XML_STATUS_OK;
  for (std::size_t at = 0; status == XML_STATUS_OK && at <= xml.size(); at += step) {
    const std::string_view piece = xml.substr(at, step);
    status = XML_Parse(parser.get(), piece.data(), static_cast<int>(piece.size()), at + step > xml.size() ? 1 : 0);
  }
  if (reading.thrown) std::rethrow_exception(reading.thrown);
  if (status == XML_STATUS_OK) return;
  throw std::runtime_error(
      fmt::format("{} in line {}, column {} of its XML",
                  reading.document_type ? "a document type" : XML_ErrorString(XML_GetErrorCode(parser.get())),
                  XML_GetCurrentLineNumber(parser.get()),
                  XML_GetCurrentColumnNumber(parser.get()) + 1));
}

}  // namespace millwright::text
