// SPDX-License-Identifier: BSD-3-Clause
#include "opening_kind.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {
namespace {

/** @brief Weights of the measures of an opening, nats: of each kind over a door. Fitted
 * by logistic regression, see doc/opening_detection.md. */
struct KindWeights {
  OpeningFeatures window;
  OpeningFeatures passage;
};

const KindWeights kind_weights{
    // one raised sill room narrow wide tall filled
    {{-1.5, 4.0, 3.0, -2.0, 2, 1, 1, 0.5}},
    {{-2.0, -3.0, -2.0, 1.0, 8, 3, 4, -2.0}}};

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
  const WallMap& map = search.maps[found.side];
  const PlanOpening& o = found.opening;
  const WallRectangle& at = found.rectangle;
  constexpr double usual_width = 0.8; ///< of the narrowest usual door, metres
  constexpr double usual_head = 2.25; ///< of the highest usual door
  const double floor = highestFloor(plan, o);
  const double sill = o.bottom - floor;
  const double head = o.top - floor;
  std::size_t filled = 0;
  std::size_t all = 0;
  for (double x = at.from + 0.1; x < at.to - 0.1; x += map.cell())
    for (double z = at.bottom + 0.1; z < at.top - 0.1; z += map.cell()) {
      ++all;
      filled += map.at(x, z) == WallCell::Within ? 1 : 0;
    }
  return {1,
          sill > sizes.on_floor ? 1.0 : 0.0,
          std::clamp(sill, 0.0, 1.2),
          o.rooms[1] != 0 ? 1.0 : 0.0,
          std::clamp(usual_width - o.width(), 0.0, 0.5),
          std::clamp(o.width() - usual_width, 0.0, 1.5),
          std::clamp(head - usual_head, 0.0, 0.5),
          all > 0 ? static_cast<double>(filled) / static_cast<double>(all) : 0.0};
}

} // namespace

void
nameOpenings(const Floorplan& plan,
             OpeningSearch& search,
             const OpeningParameters& parameters)
{
  constexpr double certain = 0.5;
  for (FoundOpening& found : search.found) {
    found.features = featuresOf(plan, search, found, parameters.sizes);
    const double window = std::exp(product(kind_weights.window, found.features));
    const double passage = std::exp(product(kind_weights.passage, found.features));
    const std::pair<double, OpeningKind> likeliest =
        std::max({std::pair(1.0, OpeningKind::Door),
                  std::pair(window, OpeningKind::Window),
                  std::pair(passage, OpeningKind::Passage)});
    found.opening.confidence = likeliest.first / (1 + window + passage);
    found.opening.kind = found.opening.confidence < certain ? OpeningKind::Unknown
                                                            : likeliest.second;
  }
}

} // namespace pcl::sedr
