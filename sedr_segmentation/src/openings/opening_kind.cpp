// SPDX-License-Identifier: BSD-3-Clause
#include "opening_search.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

namespace pcl::sedr {
namespace {

/** @brief Weights of the measures of an opening, nats: of none, window, passage and
 * niche over a door. Fitted by logistic regression, see doc/opening_detection.md. */
const std::array<OpeningFeatures, 4> kind_weights{
    {// one raised sill room narrow wide_in tall low_lintel filled around leaf closed
     // low back beyond deep low_head split lower upper solid wide_out hole
     {3.5, 1.4,  1.9, -1.4, 10.4, 3.3, 0.0, 7.5, -0.8, -7.1, -1.1, 2.3,
      6.3, -0.1, 1.8, 4.8,  3.9,  3.1, 0.5, 0.1, 9.3,  2.8,  -2.0},
     {-1.7, 3.3,  4.2,  -6.6, 7.3,  2.4, 0.1, 6.7,  1.1,  1.0, -2.4, -1.6,
      -2.5, -1.5, -9.8, -0.2, -0.4, 4.7, 0.5, -3.1, -2.7, 3.2, 0.0},
     {-4.4, -0.4, -0.6, -1.5, 7.1,  5.2,  3.7,  -1.4, -2.9, 0.2, -3.3, -1.6,
      -0.4, 1.5,  -1.1, -1.3, -1.0, -0.9, -1.0, -0.2, -2.0, 2.5, 0.0},
     {-3.8, 1.4, 2.0, -3.0, 4.9, 2.2, -1.6, -4.4, 1.3,  -1.2, -1.0, 1.2,
      2.2,  1.7, 5.6, 14.4, 5.9, 2.9, 1.6,  -3.2, 24.3, 1.2,  0.0}}};

OpeningFeatures
featuresOf(const Floorplan& plan,
           const OpeningSearch& search,
           const FoundOpening& found,
           const OpeningSizes& sizes)
{
  const PlanOpening& o = found.opening;
  const PlanRoom& room = plan.rooms[search.sides[found.side].room];
  const double ceiling = room.ceilingAt(search.sides[found.side].line.pointAt(
      (found.rectangle.from + found.rectangle.to) / 2));
  const double floor = highestFloor(plan, o);
  const double sill = o.bottom - floor;
  const double head = o.top - floor;
  const double room_behind = o.rooms[1] != 0 ? 1.0 : 0.0;
  const double wide = std::clamp(o.width() - opening_numbers.narrow_door, 0.0, 1.5);
  const double raised = std::clamp(sill / opening_numbers.raised, 0.0, 1.0);
  const bool is_hole = // one looks through
      o.walls.size() > 1 &&
      std::max({found.closed, found.solid, found.filled, found.back.closed}) <=
          Priors::share_little &&
      std::all_of(o.edges.begin(), o.edges.end(), [](const OpeningEdge& edge) {
        return edge.seen == EdgeSeen::Reveal;
      });
  return {1,
          raised,
          std::clamp(sill, 0.0, 1.2),
          room_behind,
          std::clamp(opening_numbers.narrow_door - o.width(), 0.0, 0.5),
          wide * room_behind,
          std::clamp(head - opening_numbers.high_door, 0.0, 1.0),
          std::clamp(sizes.usual_lintel - (ceiling - o.top), 0.0, sizes.usual_lintel),
          found.filled,
          found.around,
          o.hinge != OpeningHinge::Unknown ? 1.0 : 0.0,
          std::max(found.closed, found.solid),
          std::clamp(opening_numbers.low_window - o.height(), 0.0, 0.6),
          found.back.closed,
          std::min(found.back.beyond, 0.5),
          std::min(found.back.depth, 0.4) * found.back.closed,
          (1 - raised) * std::clamp(sizes.min_head - head, 0.0, 1.0),
          found.split,
          found.part == 1 ? 1.0 : 0.0,
          found.part == 2 ? 1.0 : 0.0,
          found.solid * found.back.closed *
              std::clamp(o.depth - found.back.depth - 2 * sizes.leaf_strip, 0.0, 0.2),
          wide * (1 - room_behind),
          is_hole ? raised : 0.0};
}

/** @brief Sets what a candidate most likely is, and how much likelier than nothing.
 */
void
nameOpening(const OpeningFeatures& features,
            const OpeningSizes& sizes,
            FoundOpening& found)
{
  std::array<double, 4> odds{};
  for (std::size_t k = 0; k < odds.size(); ++k)
    odds[k] = std::exp(std::inner_product(features.begin(), features.end(),
                                          kind_weights[k].begin(), 0.0));
  const auto [none, window, passage, recess] = odds;
  // A back deeper than the wall is thick, as far as that is known, is no pane or leaf.
  const bool is_deep = found.part == 0 && found.opening.walls.size() < 2 &&
                       found.back.closed >= Priors::share_closed &&
                       found.filled <= 1 - Priors::share_closed &&
                       found.back.depth <= sizes.max_niche;
  const double niche = !found.isNiche() ? 0
                       : is_deep        ? std::numeric_limits<double>::infinity()
                                        : recess;
  const double any = 1 + window + passage;
  const std::pair<double, OpeningKind> likeliest = std::max(
      {std::pair(1.0, OpeningKind::Door), std::pair(window, OpeningKind::Window),
       std::pair(passage, OpeningKind::Passage)});
  PlanOpening& o = found.opening;
  if (niche < any)
    found.niche = {};
  found.odds = std::log(std::max(any, niche) / none);
  const bool is_low =
      likeliest.second != OpeningKind::Window && o.height() < sizes.min_head;
  // A recess with nothing beyond it that is no niche, such as a bay of the room, is
  // next to no opening.
  o.confidence = is_deep && found.back.beyond <= Priors::share_little / 2
                     ? 0.01
                     : likeliest.first / (any + none + niche);
  o.kind = is_low || likeliest.first < opening_numbers.min_confidence * any
               ? OpeningKind::Unknown
               : likeliest.second;
  if (o.kind != OpeningKind::Door) {
    o.hinge = OpeningHinge::Unknown;
    o.swing = 0;
    o.state = OpeningState::Unknown;
  }
  else if (found.filled > sizes.min_leaf_share)
    o.state = OpeningState::Closed;
}

} // namespace

void
nameOpenings(const Floorplan& plan, OpeningSearch& search, const OpeningSizes& sizes)
{
  for (FoundOpening& each : search.found) {
    each.niche = nicheOf(plan, search, each, sizes);
    nameOpening(featuresOf(plan, search, each, sizes), sizes, each);
  }
  std::vector<FoundOpening> named; // each whole one or its parts
  for (auto whole = search.found.begin(); whole != search.found.end();) {
    double of_parts = 0;
    auto end = whole + 1;
    for (; end != search.found.end() && end->part != 0; ++end)
      of_parts += std::max(0.0, end->odds);
    const bool is_whole = whole->odds >= of_parts;
    std::copy_if(whole + (is_whole ? 0 : 1), is_whole ? whole + 1 : end,
                 std::back_inserter(named),
                 [](const FoundOpening& each) { return each.odds >= 0; });
    whole = end;
  }
  search.found = std::move(named);
  search.keepEachOnce(sizes.max_depth);
}

} // namespace pcl::sedr
