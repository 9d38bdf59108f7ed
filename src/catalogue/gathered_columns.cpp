// SPDX-License-Identifier: Apache-2.0
#include "catalogue/gathered_columns.h"

#include <algorithm>
#include <string_view>

#include "text/large_pages.h"

namespace millwright::catalogue {

GatheredColumns::GatheredColumns(std::size_t columns, std::size_t room) : room_(room) {
  all_.numbers.resize(columns);
  all_.texts.resize(columns);
  all_.tolerances.resize(columns);
  all_.sources.resize(columns);
  all_.confidences.resize(columns);
}

void GatheredColumns::add(const TableColumns& rows) {
  all_.file = rows.file;
  const auto add_to = [&](auto& to, const auto& more) {
    if (to.empty() && !more.empty()) text::reserve_large(to, room_);
    to.insert(to.end(), more.begin(), more.end());
  };
  for (std::size_t index = 0; index < all_.numbers.size(); ++index) {
    add_to(all_.numbers[index], rows.numbers[index]);
    add_to(all_.tolerances[index], rows.tolerances[index]);
    add_texts(all_.texts[index], rows.texts[index]);
    add_texts(all_.sources[index], rows.sources[index]);
    add_texts(all_.confidences[index], rows.confidences[index]);
  }
  add_to(all_.offsets, rows.offsets);
}

/// One text for all rows as long as it is the same: many a maker, currency or source is.
void GatheredColumns::add_texts(std::vector<TextCell>& to, const std::vector<TextCell>& rows) const {
  if (rows.empty()) return;
  const std::size_t before = all_.offsets.size();
  if (before == 0) to.push_back(rows.front());
  if (to.size() == 1) {
    const TextCell shared = to.front();
    const std::string_view first = content_of(shared, all_.file);
    if (std::all_of(rows.begin(), rows.end(), [&](TextCell each) { return content_of(each, all_.file) == first; }))
      return;
    to.clear();
    text::reserve_large(to, room_);
    to.assign(before, shared);
  }
  to.insert(to.end(), rows.begin(), rows.end());
}

}  // namespace millwright::catalogue
