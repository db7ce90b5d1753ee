// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::sedr {

/** @brief One of the two surfaces at which the air along an axis ends. Its pieces are
 * connected without steps of 0.2 m. Small ones that stand out into the air from what is
 * beside them, less than headroom, are things, if an end of them stands free, and bars,
 * if both ends meet walls; the smallest count as a part of one. */
struct EndSurface {
  double levels =
      0;            ///< entropy of its heights in steps of 0.1 m, nats: the mean of
                    ///< those of the first gaps of all columns, of the second ones, ...
  double large = 0; ///< share of pieces of 2 square metres and more
  double things = 0; ///< number of them; those that leave headroom count a third
  double bars = 0; ///< thin as walls, with headroom; above doorways they count a third
  double relief = 0;   ///< share of steps of 3 cm in 10 cm within large pieces
  double stations = 0; ///< log-odds that scanners stand on it, not anywhere, nats
};

/** @brief The air along an axis: the gaps of 1.2 to 12 m between occupied cells of 0.1
 * m in columns along it. */
struct AirAlongAxis {
  double area = 0;   ///< of the gaps, square metres
  double height = 0; ///< their median, metres
  EndSurface low;
  EndSurface high;
};

/** @brief Measures the air along the third row of `axes`, a rotation times the unit of
 * the points in metres. O(n log n).
 * @param stations where scanners stood, as the points; empty if unknown */
AirAlongAxis airAlong(const PointView& points,
                      const std::vector<int>& indices,
                      const Eigen::Matrix3d& axes,
                      std::vector<Eigen::Vector3d> stations,
                      const Priors& priors = {});

} // namespace pcl::sedr
