// SPDX-License-Identifier: BSD-3-Clause
#include "opening_kind.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {
namespace {

/** @brief Weights of the measures of an opening, nats: of each kind over a door. Fitted
 * by logistic regression, see doc/opening_detection.md; that of a filled passage was
 * set, as closed double doors were missing. */
struct KindWeights {
  OpeningFeatures window;
  OpeningFeatures passage;
};

const KindWeights kind_weights{
    // one raised sill room narrow wide tall low_lintel thin filled around leaf
    {{-1.6, 7.0, 4.7, -5.8, -2.8, 3.5, 0.9, 3.8, -0.1, -0.5, -2.7, -4}},
    {{2.9, 2.6, 1.3, -1.0, 8.9, 4.6, 1.7, 1.2, -0.3, -2.0, -6.7, -4}}};

double
product(const OpeningFeatures& a, const OpeningFeatures& b)
{
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    sum += a[k] * b[k];
  return sum;
}

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
  return {
      1,
      sill > sizes.on_floor ? 1.0 : 0.0,
      std::clamp(sill, 0.0, 1.2),
      o.rooms[1] != 0 ? 1.0 : 0.0,
      std::clamp(opening_numbers.narrow_door - o.width(), 0.0, 0.5),
      std::clamp(o.width() - opening_numbers.narrow_door, 0.0, 1.5),
      std::clamp(head - opening_numbers.high_door, 0.0, 1.0),
      std::clamp(sizes.usual_lintel - (ceiling - o.top), 0.0, sizes.usual_lintel),
      std::clamp(opening_numbers.usual_wall - o.depth, 0.0, opening_numbers.usual_wall),
      found.filled,
      found.around,
      o.hinge != OpeningHinge::Unknown ? 1.0 : 0.0};
}

} // namespace

void
nameOpenings(const Floorplan& plan, OpeningSearch& search, const OpeningSizes& sizes)
{
  for (FoundOpening& found : search.found) {
    const OpeningFeatures features = featuresOf(plan, search, found, sizes);
    const double window = std::exp(product(kind_weights.window, features));
    const double passage = std::exp(product(kind_weights.passage, features));
    const std::pair<double, OpeningKind> likeliest = std::max(
        {std::pair(1.0, OpeningKind::Door), std::pair(window, OpeningKind::Window),
         std::pair(passage, OpeningKind::Passage)});
    const bool is_low = likeliest.second != OpeningKind::Window &&
                        found.opening.height() < sizes.min_head;
    found.opening.confidence = likeliest.first / (1 + window + passage);
    found.opening.kind =
        is_low || found.opening.confidence < opening_numbers.min_confidence
            ? OpeningKind::Unknown
            : likeliest.second;
    if (found.opening.kind != OpeningKind::Door) {
      found.opening.hinge = OpeningHinge::Unknown;
      found.opening.swing = 0;
      found.opening.state = OpeningState::Unknown;
    }
    else if (found.filled > sizes.min_leaf_share)
      found.opening.state = OpeningState::Closed;
  }
}

} // namespace pcl::sedr
