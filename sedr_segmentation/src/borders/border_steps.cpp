// SPDX-License-Identifier: BSD-3-Clause
#include "border_steps.h"

#include "../sheets/shape_fit.h"

#include <pcl/sedr_segmentation/contour.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl {
namespace sedr {

namespace {

using Place = Eigen::Vector2d;

/** @brief The middle of the places that have most votes on their left, those on their
 * right taken away; 0 where all are alike. */
double
middleOfBest(const std::vector<std::pair<double, double>>& votes)
{
  std::vector<double> sums{0};
  for (const auto& vote : votes)
    sums.front() += vote.second;
  for (const auto& vote : votes)
    sums.push_back(sums.back() - 2 * vote.second);
  const double best = *std::max_element(sums.begin(), sums.end()) - 1e-9;
  std::size_t first = 0;
  while (sums[first] < best)
    ++first;
  std::size_t last = first;
  while (last + 1 < sums.size() && sums[last + 1] >= best)
    ++last;
  if (first == 0 || last + 1 == sums.size())
    return 0; // points on one side only
  return (votes[first - 1].first + votes[last].first) / 2;
}

} // namespace

void
BorderSteps::append(const std::vector<Place>& vertices,
                    const CrackChain& chain,
                    std::vector<BorderPart>& parts) const
{
  const std::vector<Place> corners = simplifiedLine(vertices, 1.2 * cracks_.cellSize());
  for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
    const Place way = corners[k + 1] - corners[k];
    if (way.norm() < 1e-9)
      continue;
    BorderPart part;
    part.samples = {corners[k], corners[k + 1]};
    const Place along = alongWalls(way.normalized());
    part.normal = Place(-along.y(), along.x()); // to the left
    part.through = (corners[k] + corners[k + 1]) / 2;
    part.through += bestShift(part, way.norm(), chain) * part.normal;
    // What runs on along the same line is one step.
    if (!parts.empty() && !parts.back().meets() &&
        std::abs(parts.back().normal.dot(part.normal)) > 0.999 &&
        std::abs(part.normal.dot(parts.back().through - part.through)) <
            cracks_.cellSize()) {
      parts.back().samples.push_back(corners[k + 1]);
      continue;
    }
    parts.push_back(std::move(part));
  }
}

/** @brief The way of the wall that runs nearly as `way` does, else `way`. */
Place
BorderSteps::alongWalls(const Place& way) const
{
  constexpr double nearly = 0.26; // radians: a line of cells tells no more
  for (const double direction : directions_)
    for (const double turn : {0.0, M_PI / 2}) {
      const Place wall(std::cos(direction + turn), std::sin(direction + turn));
      if (std::abs(wall.dot(way)) > std::cos(nearly))
        return wall.dot(way) > 0 ? wall : Place(-wall);
    }
  return way;
}

/** @brief How far a step lies to the left of where its cells say, such that most
 * points lie on the side of their facet. */
double
BorderSteps::bestShift(const BorderPart& part,
                       double length,
                       const CrackChain& chain) const
{
  const SheetGrid& grid = cracks_.sheet.grid;
  const double most = SheetCracks::reach * grid.size;
  const Place along(part.normal.y(), -part.normal.x());
  const double deviation = std::max(0.003, 2 * cracks_.sheet.noise);
  std::vector<std::pair<double, double>> votes; // place across, for the left facet
  const auto cell_reach = static_cast<int>(length / grid.size) + 4;
  const std::size_t middle = grid.at(part.through);
  if (middle >= grid.count())
    return 0;
  for (const std::size_t cell : cells_.window(middle, cell_reach))
    for (const Eigen::Vector3d* p = cells_.begin(cell); p != cells_.end(cell); ++p) {
      const Place off = p->head<2>() - part.through;
      const double across = off.dot(part.normal);
      if (std::abs(off.dot(along)) > length / 2 || std::abs(across) > most)
        continue;
      const auto misfit = [&](std::int32_t piece) {
        const double share = distanceOf(cracks_.facetOf(piece), *p) / deviation;
        return std::min(share * share, 4.0);
      };
      votes.emplace_back(across, misfit(chain.right) - misfit(chain.left));
    }
  std::sort(votes.begin(), votes.end());
  return middleOfBest(votes);
}

} // namespace sedr
} // namespace pcl
