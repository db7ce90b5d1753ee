// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cube_points.h"

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/scan_frame.h>

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief A ray of a scanner and what it ended on. */
struct ScanRay {
  Eigen::Vector3f from;   ///< the position
  Eigen::Vector3f to;     ///< the point
  std::uint32_t cube = 0; ///< that the point is in
};

/** @brief What rays of a scan go through: panes of glass, which return few points, and
 * whatever else has gaps. Points are kept by cubes of a quarter of a metre. */
class PiercedSurfaces {
public:
  /** @param points of the scan, thinned */
  explicit PiercedSurfaces(const PointView& points);

  const CubeTable& cubes() const { return points_.cubes(); }

  /** @brief Returns the points of a cube. */
  const std::vector<Eigen::Vector3f>& pointsOf(std::uint32_t cube) const
  {
    return points_[cube];
  }

  /** @brief Returns how far from its start a ray enters the box of the points, metres;
   * 0 if it starts inside. Rays end inside. */
  float entryOf(const ScanRay& ray) const;

  /** @brief Returns the first cube in which a ray has points on all sides around it, at
   * least 0.4 m before its end; CubeTable::none where it has none. O(length of the ray
   * within the box of the points). */
  std::uint32_t firstPierced(const ScanRay& ray) const;

private:
  /** @brief Whether points stand on all sides around a ray near `along` metres from its
   * start. */
  bool isSurrounded(const Eigen::Vector3f& from,
                    const Eigen::Vector3f& direction,
                    float along,
                    const Cube& cube) const;

  CubePoints points_;
  Eigen::AlignedBox3f box_; ///< of the points, and a cube around it
};

/** @brief A flat surface that rays go through. */
struct Pane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double offset = 0;                ///< normal.dot(p) of its points
  std::vector<std::uint32_t> cubes; ///< of PiercedSurfaces, that it is in

  /** @brief Whether a ray ends at least `depth` metres behind the plane of a pane. */
  bool parts(const ScanRay& ray, double depth) const
  {
    const double before = normal.dot(ray.from.cast<double>()) - offset;
    const double behind = normal.dot(ray.to.cast<double>()) - offset;
    return before * behind < 0 && std::abs(behind) >= depth;
  }

  /** @brief Where a ray meets the plane of a pane that parts it. */
  Eigen::Vector3d placeOn(const ScanRay& ray) const
  {
    const Eigen::Vector3d from = ray.from.cast<double>();
    const Eigen::Vector3d whole = ray.to.cast<double>() - from;
    return from + (offset - normal.dot(from)) / normal.dot(whole) * whole;
  }

  /** @brief What a place looks like in it. */
  Eigen::Vector3d imageOf(const Eigen::Vector3d& p) const
  {
    return p - 2 * (normal.dot(p) - offset) * normal;
  }
};

/** @brief The panes of which rays went through several cubes: planes through the points
 * of these cubes.
 * @param pierced of each ray, see PiercedSurfaces */
std::vector<Pane> panesOf(const PiercedSurfaces& surfaces,
                          const std::vector<std::uint32_t>& pierced);

/** @brief Rays, and what each goes through first. */
struct PaneRays {
  std::vector<ScanRay> rays;
  std::vector<Pane> panes;
  std::vector<std::size_t> before; ///< pane of each ray, panes.size() for none
};

/** @brief Places that a file tells but that its points were not taken from, such as the
 * one pose of a file of several scans that were joined: those on a surface, and those
 * of which more than a tenth of the rays go through flat surfaces in a way that no pane
 * allows. A pane returns some of the rays in its direction, and there are no more than
 * in others; of what is seen through a wall from where no scanner stood, there is more
 * than a scanner casts, or nothing of the wall, or most.
 *
 * A wrong place whose rays go through nothing is not found, and does no harm.
 * @param rows every `step`-th point of the scan, those that are not finite too
 * @return places of `positions`, each once */
std::vector<Eigen::Vector3f> untruePlaces(const PiercedSurfaces& surfaces,
                                          const PaneRays& through,
                                          const PointView& rows,
                                          std::size_t step,
                                          const ScanPositions& positions,
                                          unsigned threads);

} // namespace pcl::sedr
