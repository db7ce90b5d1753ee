// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/impl/stage_error.h>
#include <pcl/sedr_filters/priors.h>

#include <pcl/ModelCoefficients.h>
#include <pcl/PointIndices.h>
#include <pcl/pcl_base.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Kind of a horizontal plane of a scan. */
enum class LevelKind { Other, Ceiling, Floor };

/** @brief Parameters of the level detection; lengths in metres, angles in radians. */
struct LevelParameters {
  double tolerance = 0.07; ///< distance of an inlier from its plane (paper, Table 1)
  double cell_size = 0.05; ///< edge of a cell of the grid in which sizes are counted
  double maximum_tilt = radians(Priors().max_slab_tilt); ///< of a plane
  double minimum_area = 1.0; ///< square metres of occupied cells
  double minimum_room_height = Priors().min_headroom; ///< from a floor to its ceiling
  Priors priors;
  std::uint64_t seed = 1;
  unsigned threads = 0; ///< 0: all processors
};

} // namespace sedr

/** @brief A horizontal plane found by HorizontalPlaneDetection. */
struct HorizontalPlane {
  pcl::PointIndices
      inliers; ///< points within the distance threshold, without walls, increasing
  pcl::ModelCoefficients
      coefficients; ///< a, b, c, d of a x + b y + c z + d = 0, unit normal up
  sedr::LevelKind kind = sedr::LevelKind::Other;
  double height = 0;     ///< z at the centre of its cells, metres
  std::size_t cells = 0; ///< occupied grid cells, without those of walls
  double area = 0;       ///< of these cells, square metres
  double residual = 0;   ///< root mean square distance of the fitted points, metres
  sedr::PlanSlab slab;   ///< the same plane in double precision
};

/** @brief Finds the horizontal planes of a scan and classifies them as ceiling, floor
 * or other (paper, section 2.3.1). The heights at which most grid cells are
 * occupied give the candidates; RANSAC with a tilt limit fits each plane. Frame: z up.
 * Non-finite points are never inliers.
 *
 * A scan may contain several ceilings and floors at different heights; a table top is
 * neither. Sizes are counted in occupied cells, so the density of the scan does not
 * matter. Time O(n log n) for n points plus O(n) per plane; input thinned to the grid
 * size is enough.
 * @code
 * pcl::HorizontalPlaneDetection<pcl::PointXYZ> detection;
 * detection.setInputCloud(thinned);
 * std::vector<pcl::HorizontalPlane> planes;
 * detection.segment(planes);
 * @endcode */
template <typename PointT>
class HorizontalPlaneDetection : public PCLBase<PointT>, public sedr::StageError {
public:
  using Ptr = shared_ptr<HorizontalPlaneDetection<PointT>>;
  using ConstPtr = shared_ptr<const HorizontalPlaneDetection<PointT>>;

  /** @brief Sets the maximum distance of an inlier, metres, > 0. Default 0.07. */
  void setDistanceThreshold(double threshold) { parameters_.tolerance = threshold; }
  double getDistanceThreshold() const { return parameters_.tolerance; }

  /** @brief Sets the edge of the cells that measure sizes, metres, > 0. Default 0.05.
   */
  void setGridSize(double size) { parameters_.cell_size = size; }
  double getGridSize() const { return parameters_.cell_size; }

  /** @brief Sets the maximum angle of a plane with the horizontal, radians, 0 to pi/4.
   * Default 3 degrees. */
  void setMaximumTilt(double tilt) { parameters_.maximum_tilt = tilt; }
  double getMaximumTilt() const { return parameters_.maximum_tilt; }

  /** @brief Sets the minimum area of a plane, square metres of cells, > 0. Default 1.
   */
  void setMinimumArea(double area) { parameters_.minimum_area = area; }
  double getMinimumArea() const { return parameters_.minimum_area; }

  /** @brief Sets the minimum height of a room, metres, > 0. Default 1.8. */
  void setMinimumRoomHeight(double height) { parameters_.minimum_room_height = height; }
  double getMinimumRoomHeight() const { return parameters_.minimum_room_height; }

  /** @brief Sets the priors, and with them the room height and tilt. */
  void setPriors(const sedr::Priors& priors)
  {
    parameters_.priors = priors;
    parameters_.maximum_tilt = sedr::radians(priors.max_slab_tilt);
    parameters_.minimum_room_height = priors.min_headroom;
  }
  const sedr::Priors& getPriors() const { return parameters_.priors; }

  /** @brief Sets the seed of the random samples. Default 1. */
  void setSeed(std::uint64_t seed) { parameters_.seed = seed; }
  std::uint64_t getSeed() const { return parameters_.seed; }

  /** @brief Sets the number of threads, 0 (default) for all processors. The planes do
   * not depend on it. */
  void setNumberOfThreads(unsigned threads) { parameters_.threads = threads; }
  unsigned getNumberOfThreads() const { return parameters_.threads; }

  /** @brief Finds the planes, lowest first.
   * @param[out] planes cleared first; empty if none was found
   * @return false, with a reason in getErrorMessage(), for bad input or parameters or
   * if no plane has the minimum area */
  bool segment(std::vector<HorizontalPlane>& planes);

private:
  using PCLBase<PointT>::input_;
  using PCLBase<PointT>::indices_;

  sedr::LevelParameters parameters_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/sedr_segmentation/impl/horizontal_plane_detection.hpp>
#endif
