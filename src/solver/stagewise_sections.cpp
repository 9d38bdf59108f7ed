// SPDX-License-Identifier: Apache-2.0
//
// Parts of what is looked for, one after the other.
//
// A front is done section by section. What the whole front needs is too much at once: bounds that leave one end little
// leave the other much. For a part of it prices and mixes of the objectives are found that fit there, and most rows are
// left out.
#include <algorithm>
#include <cmath>

#include "solver/stagewise_search.h"

namespace millwright::solver {
/// A single objective: its least. What decides between equals is not compared on the way, or far more would be left
/// wherever stages add nothing to the objective; and where the least is greater than another one nobody asks for it.
bool StagewiseSearch::find_least() {
  undecided_ = false;
  bool found = aim();
  if (!found && !control_.time_is_up()) {
    undecided_ = false;
    found = pass({.compared = Compared::without_ties});
  }
  if (!found || undecided_) return false;
  least_known_ = !incumbents_.builds().empty();
  return true;
}

bool StagewiseSearch::decide_equals() {
  find_rest();
  least_known_ = true;
  improve_equals();
  mixes_ = {Mix::only(0)};
  const bool prepared = control_.while_there_is_time([&] {
    planes_ = std::make_unique<RestPlanes>(problem_, plans_, forms_, control_.desk(0));
    settled_ = find_planes() && !restrict_stages();
  });
  if (!prepared) return false;
  undecided_ = false;
  return settled_ || (pass({}) && !undecided_);
}

/// Looks for builds that come to no more than a little above what every build comes to at least. There is little to
/// look at below that, and the best of what is found is the best of all. Where it is too much, less is looked at. True
/// when one is found.
bool StagewiseSearch::aim() {
  constexpr double first_share = 0.1, largest_share = 0.4, least_share = 0.01;
  least_total_ = std::max(least_total_, rest_.front().front().first);
  double too_much = infinity;  // the least that has been
  bool found = false;
  for (double share = first_share; !found && share > least_share && share <= largest_share;) {
    const double known = incumbents_.best();
    if (!std::isfinite(known) || !(known > least_total_)) break;
    section_.to = least_total_ + share * (known - least_total_);
    if (!(section_.to < too_much)) break;
    undecided_ = false;  // what a pass that was given up left undecided may be beyond this section
    const bool done = pass({.compared = Compared::without_ties, .patience = 10 * control_.options().stage_patience});
    if (control_.time_is_up() || (done && undecided_)) break;
    found = done && incumbents_.best() <= section_.to;
    (done ? least_total_ : too_much) = section_.to;
    share *= done ? 2.0 : 0.25;
  }
  section_ = Section{};
  return found;
}

/// Every design on the front is in the section of its first score. False: time is up, or something undecided.
bool StagewiseSearch::by_sections() {
  constexpr std::size_t most_known = 16;  // builds of the front in a section that is tried as a whole
  // What is refined once for the whole front serves all sections.
  settled_ = false;
  if (!control_.while_there_is_time([&] { settled_ = !find_vectors(); })) return false;
  if (settled_) return true;
  planes_->keep_regions();
  // It was too much before; unless far less is left now, it is done section by section.
  if (pass({.patience = section_patience(0) / 4})) return !undecided_;
  if (control_.time_is_up()) return false;
  undecided_ = false;
  least_total_ = std::max(least_total_, rest_.front().front().first);
  const std::vector<StagePlan> plans = plans_;
  const std::vector<StateForm> forms = forms_;
  std::vector<Section> open{Section{}};
  while (!open.empty()) {
    const Section section = open.back();
    open.pop_back();
    const std::vector<double> inside = known_inside(section);
    const bool tried = inside.size() <= most_known && !is_wide(section);
    if (tried && settle(section, plans, forms)) continue;
    if (control_.time_is_up() || undecided_) {
      open.push_back(section);
      break;
    }
    // Cut in the middle of what is known of it, or of its scores.
    const std::vector<double> now = known_inside(section);
    const double middle = now.empty()                  ? middle_of(section)
                          : !std::isfinite(section.to) ? now.back()
                                                       : central(now[now.size() / 2], section);
    const unsigned given_up = section.given_up + (tried ? 1 : 0);
    open.push_back({middle, section.to, given_up});
    open.push_back({section.from, middle, given_up});
  }
  section_ = Section{};
  std::copy(plans.begin(), plans.end(), plans_.begin());  // whoever goes on needs to know of all sections
  return open.empty() && !undecided_;
}

/// What is too much is cut. What cutting did not make less is tried longer each time, or it would be begun again and
/// again down to the narrowest section.
std::size_t StagewiseSearch::section_patience(unsigned given_up) const {
  constexpr unsigned longer = 2, most = 20;  // binary digits
  return control_.options().stage_patience << std::min(longer * given_up, most);
}

/// First scores of known builds in it.
std::vector<double> StagewiseSearch::known_inside(const Section& section) const {
  std::vector<double> inside;
  for (const RankedBuild& build : incumbents_.builds())
    if (build.score[0] > section.from && build.score[0] < section.to) inside.push_back(build.score[0]);
  return inside;
}

double StagewiseSearch::middle_of(const Section& section) const {
  constexpr double more = 0.25;
  const double from = std::max(section.from, least_total_);
  return std::isfinite(section.to) ? 0.5 * (from + section.to) : from + more * std::fabs(from);
}

/// How far the first scores on the known front lie apart: where they are about zero, no share of them is narrow.
double StagewiseSearch::known_range() const {
  const std::vector<RankedBuild>& builds = incumbents_.builds();
  return builds.empty() ? 0.0 : builds.back().score[0] - least_total_;
}

/// Away from the ends of a wide section: builds that crowd at one end say little about the rest of it. A narrow one is
/// cut at builds, so that in the end there is none inside.
double StagewiseSearch::central(double score, const Section& section) const {
  constexpr double least_share = 0.25, narrow = 0.05;
  const double from = std::max(section.from, least_total_);
  const double width = section.to - from;
  if (!(from > 0.0) || !(width > narrow * section.to)) return score;
  return std::clamp(score, from + least_share * width, section.to - least_share * width);
}

/// Whether its scores are too different for bounds that fit all of it.
bool StagewiseSearch::is_wide(const Section& section) const {
  constexpr double wide = 0.3, wide_of_all = 0.01;
  const double from = std::max(section.from, least_total_);
  if (!std::isfinite(section.to)) return !known_inside(section).empty();
  return section.to - from > std::max(wide * std::fabs(section.to), wide_of_all * known_range());
}

/// Whether there is no use in cutting it.
bool StagewiseSearch::is_narrow(const Section& section) const {
  constexpr double narrow = 0.02, narrow_of_all = 0.001;
  constexpr double far = 9.0;
  if (!known_inside(section).empty()) return false;
  if (!std::isfinite(section.to)) return !(section.from < least_total_ + far * std::fabs(least_total_));
  return !(section.to - middle_of(section) > std::max(narrow * std::fabs(section.to), narrow_of_all * known_range()));
}

/// Vectors below the known front, as far as it is looked at. False: nothing that is left can change it.
bool StagewiseSearch::find_vectors() {
  update_useful();
  return planes_->find_vectors(useful_.back());
}

/// False: it is too much, time is up, or something is undecided.
bool StagewiseSearch::settle(const Section& section,
                             const std::vector<StagePlan>& plans,
                             const std::vector<StateForm>& forms) {
  section_ = section;
  const std::vector<Pair> corners = this->corners();
  std::copy(plans.begin(), plans.end(), plans_.begin());
  std::copy(forms.begin(), forms.end(), forms_.begin());
  mixes_ = {Mix::only(0), Mix::only(1)};
  const auto has_end = [](const Pair& corner) { return std::isfinite(corner.first) && std::isfinite(corner.second); };
  const auto first = std::find_if(corners.begin(), corners.end(), has_end);
  const auto last = std::find_if(corners.rbegin(), corners.rend(), has_end);
  if (last != corners.rend() && first->first < last->first)
    mixes_.push_back({(first->second - last->second) / (last->first - first->first), 1.0});
  const auto prepare = [&] {
    settled_ = false;  // it is left so when time is up
    return control_.while_there_is_time([&] {
      settled_ = find_planes() && !(restrict_stages() && find_vectors() && restrict_stages() && find_vectors());
    });
  };
  planes_ = std::make_unique<RestPlanes>(problem_, plans_, forms_, control_.desk(0));
  if (!prepare()) return false;
  if (settled_) return true;
  const bool narrow = is_narrow(section);
  for (const Haste& haste : {Haste{.nodes = 1000}, {.nodes = 2000, .labels = 100, .digits = 14}}) {
    if (!control_.options().look_first) break;
    Haste here = haste;
    here.mix = mixes_.back();
    if (!pass({.haste = here})) return false;
    if (!prepare()) return false;
    if (!settled_) continue;
    undecided_ = false;  // by bounds, whatever the quick pass met
    return true;
  }
  undecided_ = false;
  return pass({.patience = narrow ? endless : section_patience(section.given_up)}) && !undecided_;
}

}  // namespace millwright::solver
