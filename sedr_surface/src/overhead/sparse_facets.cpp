// SPDX-License-Identifier: BSD-3-Clause
#include "sparse_facets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace pcl::sedr {
namespace {

/** @brief A surface of a ceiling, which several facets may lie on. */
struct Surface {
  double area = 0;
  double points = 0;
};

std::array<double, 4>
keyOf(const PlanSlab& slab)
{
  return {slab.plane[0], slab.plane[1], slab.plane[2], slab.plane[3]};
}

} // namespace

std::vector<bool>
sparseFacets(const PlanRoom& room)
{
  constexpr double sparse = 0.25; // of the points an area that the whole ceiling has
  std::map<std::array<double, 4>, Surface> surfaces;
  const auto add = [&](const PlanSlab& slab, double area) {
    Surface& surface = surfaces[keyOf(slab)];
    surface.area += std::max(area, 0.0);
    surface.points = std::max(surface.points, static_cast<double>(slab.inliers));
  };
  double rest = room.area();
  for (const PlanDetail& detail : room.details) {
    double area = detail.boundary.area();
    for (const PlanLoop& hole : detail.holes)
      area += hole.area();
    add(detail.slab, area);
    rest -= area;
  }
  add(room.ceiling, rest);
  Surface whole;
  for (const auto& [key, surface] : surfaces)
    if (surface.points > 0) {
      whole.area += surface.area;
      whole.points += surface.points;
    }
  const auto isSparse = [&](const PlanSlab& slab) {
    const Surface& surface = surfaces[keyOf(slab)];
    return surface.points > 0 &&
           surface.points * whole.area < sparse * whole.points * surface.area;
  };
  std::vector<bool> found{isSparse(room.ceiling)};
  for (const PlanDetail& detail : room.details)
    found.push_back(detail.is_facet && isSparse(detail.slab));
  return found;
}

} // namespace pcl::sedr
