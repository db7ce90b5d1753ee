// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "niche_fit.h"
#include "sedr_filters/src/grids/cell_mask.h"
#include <pcl/sedr_filters/floorplan.h>

#include <cmath>
#include <vector>

namespace pcl::sedr {

/** @brief A point as seen from a wall: metres along it, above its floor, behind it at
 * that height. */
struct WallPoint {
  double along;
  double up;
  double behind;
};

/** @brief How a straight wall that stands on a floor sees a point. */
inline WallPoint
seenFrom(const PlanElement& wall, const PlanSlab& floor, const Eigen::Vector3f& point)
{
  const Eigen::Vector3d p = point.cast<double>();
  const Eigen::Vector2d way = (wall.end - wall.start).normalized();
  const Eigen::Vector2d to = p.head<2>() - wall.start;
  const double up = p.z() - floor.heightAt(p.head<2>());
  return {way.dot(to), up,
          way.y() * to.x() - way.x() * to.y() + std::tan(wall.tilt) * up};
}

/** @brief A straight wall of a room, unrolled. */
struct UnrolledWall {
  const PlanElement& element;
  double height = 0;
  double tolerance = 0; ///< distance within which a point is on the wall
  std::vector<WallPoint> points;
};

/** @brief A recess in a wall: along [left, right], up [low, high]. */
struct Recess {
  double left = 0;
  double right = 0;
  double low = 0;
  double high = 0;
  double depth = 0;
  bool has_bottom = false; ///< seen above the floor

  double mouth() const { return (right - left) * (high - low); }
};

/** @brief The cells behind which something is seen while nothing is on the wall. */
CellMask openCells(const UnrolledWall& wall, const CellGrid& grid);

/** @brief The recess of one region of open cells, if it is a niche. */
bool findRecess(const UnrolledWall& wall,
                const CellMask& region,
                const CellGrid& grid,
                const NicheParameters& parameters,
                Recess& recess);

} // namespace pcl::sedr
