// SPDX-License-Identifier: Apache-2.0
// The search asks about one row of those with the same fit key: it must stand for all of them.
#include <map>

#include "catch.h"
#include "evaluation/machine_model.h"
#include "evaluation/machines.h"
#include "shipped_machines.h"

namespace fit_keys_test {

using namespace millwright;

namespace {

/// Pairs of slots of a stage in which something misfits; every row is compared with the first of its key.
int misfitting_pairs(const solver::Stage& stage, const std::vector<solver::Row>& shared) {
  int misfitting = 0;
  for (std::size_t a = 0; a < stage.slots().size(); ++a)
    for (std::size_t b = 0; b < stage.slots().size(); ++b) {
      if (a == b) continue;
      std::map<std::pair<double, double>, solver::Row> first;
      bool misfits = false, same = true;
      for (solver::Row i = 0; i < stage.slots()[a].rows; ++i) {
        const solver::FitKey key = stage.fit_key(shared, a, i, b);
        const solver::Row other = first.try_emplace({key.first, key.second}, i).first->second;
        for (solver::Row j = 0; j < stage.slots()[b].rows; ++j) {
          const bool fits = stage.fits(shared, a, i, b, j);
          misfits = misfits || !fits;
          same = same && fits == stage.fits(shared, a, other, b, j);
        }
      }
      INFO("stage " << stage.name() << ", slots " << stage.slots()[a].name << " and " << stage.slots()[b].name);
      CHECK(same);
      misfitting += misfits ? 1 : 0;
    }
  return misfitting;
}

}  // namespace

TEST_CASE("Rows with the same fit key fit the same rows of every other slot") {
  int misfitting = 0;
  for (const char* name : shipped_machines) {
    INFO(name);
    const std::string folder = std::string(MILLWRIGHT_SOURCE_DIR) + "/problems/";
    const machine::Problem problem = shipped_problem(name);
    std::vector<std::filesystem::path> places{std::string(MILLWRIGHT_SOURCE_DIR) + "/catalogues"};
    for (const std::string& overlay : problem.catalogues) places.emplace_back(folder + overlay);
    const catalogue::Catalogue catalogue = catalogue_of(places);
    const evaluation::MachineModel model(problem, catalogue);
    const std::vector<solver::Row> shared(model.problem().shared.size(), 0);
    for (const solver::Stage* stage : model.problem().stages) misfitting += misfitting_pairs(*stage, shared);
  }
  CHECK(misfitting > 20);  // else nothing was tried
}

}  // namespace fit_keys_test
