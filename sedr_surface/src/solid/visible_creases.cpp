// SPDX-License-Identifier: BSD-3-Clause
#include "visible_creases.h"

#include <algorithm>

namespace pcl::sedr {

namespace {

double
cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/** @brief Returns the winding number of a closed chain around a point,
 * counter-clockwise. */
int
turnsAround(const std::vector<Eigen::Vector2d>& corners, const Eigen::Vector2d& p)
{
  int turns = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d from = corners[i] - p;
    const Eigen::Vector2d to = corners[(i + 1) % corners.size()] - p;
    if ((from.y() <= 0) == (to.y() <= 0))
      continue;
    const bool is_left = cross(from, to) > 0;
    if (is_left && from.y() <= 0)
      ++turns;
    else if (!is_left && from.y() > 0)
      --turns;
  }
  return turns;
}

} // namespace

VisibleCreases::VisibleCreases(const RoomLayers& layers,
                               const std::vector<FacetChain>& chains)
    : layers_(layers)
    , chains_(chains)
    , boxes_(chains.size())
{
  for (std::size_t l = 0; l < chains.size(); ++l)
    for (const Eigen::Vector2d& corner : chains[l].corners)
      boxes_[l].extend(corner);
}

std::vector<Crease>
VisibleCreases::of(std::size_t slab, double tolerance) const
{
  const RoomLayers::Slab& own = layers_.slabs[slab];
  std::vector<Crease> visible;
  Eigen::AlignedBox2d bounds;
  for (std::size_t l = 0; l < chains_.size(); ++l)
    if (layers_.loops[l].loop == own.loop)
      bounds.extend(boxes_[l]);
  if (!own.slab.curve || bounds.isEmpty())
    return visible;
  for (const Crease& crease : creasesOf(*own.slab.curve, bounds, tolerance)) {
    const std::vector<double> shares = crossings(crease);
    const Eigen::Vector2d way = crease.second - crease.first;
    for (std::size_t k = 0; k + 1 < shares.size(); ++k) {
      const double middle = (shares[k] + shares[k + 1]) / 2;
      if (!regionAt(crease.first + middle * way).has(static_cast<int>(slab)))
        continue;
      visible.emplace_back(crease.first + shares[k] * way,
                           crease.first + shares[k + 1] * way);
    }
  }
  return visible;
}

std::vector<double>
VisibleCreases::crossings(const Crease& crease) const
{
  const Eigen::Vector2d way = crease.second - crease.first;
  Eigen::AlignedBox2d box(crease.first);
  box.extend(crease.second);
  std::vector<double> shares{0, 1};
  for (std::size_t l = 0; l < chains_.size(); ++l) {
    if (!boxes_[l].intersects(box))
      continue;
    const auto& corners = chains_[l].corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Eigen::Vector2d from = corners[i] - crease.first;
      const Eigen::Vector2d to = corners[(i + 1) % corners.size()] - crease.first;
      const double side = cross(way, from);
      const double side_to = cross(way, to);
      if ((side < 0) == (side_to < 0))
        continue;
      const Eigen::Vector2d at = from + side / (side - side_to) * (to - from);
      const double share = at.dot(way) / way.squaredNorm();
      if (share > 0 && share < 1)
        shares.push_back(share);
    }
  }
  std::sort(shares.begin(), shares.end());
  return shares;
}

PlanRegion
VisibleCreases::regionAt(const Eigen::Vector2d& p) const
{
  std::vector<int> winding(chains_.size(), 0);
  for (std::size_t l = 0; l < chains_.size(); ++l)
    if (boxes_[l].contains(p))
      winding[l] = turnsAround(chains_[l].corners, p);
  return layers_.regionOf(winding);
}

} // namespace pcl::sedr
