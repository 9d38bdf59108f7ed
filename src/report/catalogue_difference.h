// SPDX-License-Identifier: Apache-2.0
// What changed between two catalogues, in 80 columns and as JSON.
#pragma once

#include <string>
#include <vector>

#include "catalogue/difference.h"
#include "catalogue/overlay_difference.h"
#include "report/text_table.h"

namespace millwright::report {

/// One of both catalogues with the name that it is known by ("old", "catalogues + my-parts").
struct ComparedCatalogue {
  std::string name;
  const catalogue::Catalogue* catalogue = nullptr;
};

/// "A" and "B" are the catalogues. A brief style gives the counts of each family only.
std::string catalogue_difference_text(const ComparedCatalogue& a,
                                      const ComparedCatalogue& b,
                                      const std::vector<catalogue::FamilyDifference>& families,
                                      const std::vector<catalogue::FileDifference>& files,
                                      const Style& style);

std::string catalogue_difference_json(const ComparedCatalogue& a,
                                      const ComparedCatalogue& b,
                                      const std::vector<catalogue::FamilyDifference>& families,
                                      const std::vector<catalogue::FileDifference>& files);

}  // namespace millwright::report
