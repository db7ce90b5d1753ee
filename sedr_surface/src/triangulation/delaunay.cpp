// SPDX-License-Identifier: BSD-3-Clause
#include "constrained_triangulation.h"

#include <boost/polygon/voronoi.hpp>

namespace pcl::sedr {
namespace {

/** @brief Cuts a polygon of cocircular points, counter-clockwise, into triangles of
 * non-zero area. */
bool
cutPolygon(const std::vector<GridPoint>& points,
           std::vector<std::uint32_t> polygon,
           PlanTriangles& triangles)
{
  while (polygon.size() >= 3) {
    const std::size_t n = polygon.size();
    std::size_t ear = 0;
    while (ear < n && turn(points[polygon[(ear + n - 1) % n]], points[polygon[ear]],
                           points[polygon[(ear + 1) % n]]) <= 0)
      ++ear;
    if (ear == n)
      return false;
    triangles.push_back(
        {polygon[(ear + n - 1) % n], polygon[ear], polygon[(ear + 1) % n]});
    polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  return true;
}

} // namespace

bool
delaunay(const std::vector<GridPoint>& points, PlanTriangles& triangles)
{
  std::vector<boost::polygon::point_data<std::int32_t>> sites;
  sites.reserve(points.size());
  for (const GridPoint& p : points)
    sites.emplace_back(p.x, p.y);
  boost::polygon::voronoi_diagram<double> diagram;
  boost::polygon::construct_voronoi(sites.begin(), sites.end(), &diagram);
  // A polygon around each vertex of the Voronoi diagram, from the points of its cells.
  for (const auto& vertex : diagram.vertices()) {
    std::vector<std::uint32_t> polygon;
    const auto* edge = vertex.incident_edge();
    do {
      polygon.push_back(static_cast<std::uint32_t>(edge->cell()->source_index()));
      edge = edge->rot_next();
    } while (edge != vertex.incident_edge());
    if (!cutPolygon(points, std::move(polygon), triangles))
      return false;
  }
  return true;
}

} // namespace pcl::sedr
