// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cube_table.h"
#include <pcl/sedr_filters/point_view.h>

#include <Eigen/Geometry>

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

  const CubeTable& cubes() const { return cubes_; }

  /** @brief Calls `see(place)` for the points of a cube. */
  template <typename See>
  void forEachPoint(std::uint32_t cube, See see) const
  {
    for (std::uint32_t k = first_[cube]; k < first_[cube + 1]; ++k)
      see(places_[k]);
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

  CubeTable cubes_;
  Eigen::AlignedBox3f box_;             ///< of the points, and a cube around it
  std::vector<std::uint32_t> first_;    ///< point of each cube, and the end
  std::vector<Eigen::Vector3f> places_; ///< of points, cube by cube
};

} // namespace pcl::sedr
