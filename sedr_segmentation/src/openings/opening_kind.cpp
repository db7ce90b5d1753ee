// SPDX-License-Identifier: BSD-3-Clause
#include "opening_kind.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {
namespace {

/** @brief Weights of the measures of an opening, nats: of each kind over a door. Fitted
 * by logistic regression, see doc/opening_detection.md; that
 * of a filled passage was set, as closed double doors were missing. */
struct KindWeights {
  OpeningFeatures none;
  OpeningFeatures window;
  OpeningFeatures passage;
};

const KindWeights kind_weights{
    // one raised sill room narrow wide tall low_lintel filled around leaf closed low
    {2.8, 0.3, 1.4, -1.3, 3.7, 1.1, 1.5, 0.8, 0.4, -4.3, -1.5, 1.7, 3.5},
    {-2.0, 3.9, 2.0, -3.3, -0.6, 1.7, 0.6, 0.8, 0.2, 0.5, -1.2, -1.1, -2.7},
    {-3.8, -0.3, -0.4, -0.2, -0.1, 3.9, 1.4, 0.0, -6.7, 0.1, -2.3, 0.1, -0.3}};

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
  const double raised = std::clamp(sill / opening_numbers.raised, 0.0, 1.0);
  return {1,
          raised,
          std::clamp(sill, 0.0, 1.2),
          o.rooms[1] != 0 ? 1.0 : 0.0,
          std::clamp(opening_numbers.narrow_door - o.width(), 0.0, 0.5),
          std::clamp(o.width() - opening_numbers.narrow_door, 0.0, 1.5),
          std::clamp(head - opening_numbers.high_door, 0.0, 1.0),
          std::clamp(sizes.usual_lintel - (ceiling - o.top), 0.0, sizes.usual_lintel),
          found.filled,
          found.around,
          o.hinge != OpeningHinge::Unknown ? 1.0 : 0.0,
          raised * found.closed,
          std::clamp(opening_numbers.low_window - o.height(), 0.0, 0.6)};
}

/** @brief Sets the kind of what is likelier an opening than none.
 * @return whether it is */
bool
nameOpening(const OpeningFeatures& features,
            const OpeningSizes& sizes,
            FoundOpening& found)
{
  const double none = std::exp(product(kind_weights.none, features));
  const double window = std::exp(product(kind_weights.window, features));
  const double passage = std::exp(product(kind_weights.passage, features));
  const double any = 1 + window + passage;
  const std::pair<double, OpeningKind> likeliest = std::max(
      {std::pair(1.0, OpeningKind::Door), std::pair(window, OpeningKind::Window),
       std::pair(passage, OpeningKind::Passage)});
  PlanOpening& o = found.opening;
  const bool is_low =
      likeliest.second != OpeningKind::Window && o.height() < sizes.min_head;
  o.confidence = likeliest.first / (any + none);
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
  return any >= none;
}

} // namespace

void
nameOpenings(const Floorplan& plan, OpeningSearch& search, const OpeningSizes& sizes)
{
  std::vector<FoundOpening> named;
  for (const FoundOpening& candidate : search.found) {
    FoundOpening opening = candidate;
    if (nameOpening(featuresOf(plan, search, candidate, sizes), sizes, opening))
      named.push_back(opening);
  }
  search.found = std::move(named);
  search.keepEachOnce();
}

} // namespace pcl::sedr
