// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>
#include <pcl/sedr_filters/stage_error.h>

#include <pcl/ModelCoefficients.h>
#include <pcl/PointIndices.h>
#include <pcl/pcl_base.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief What a horizontal plane of a scan is. */
enum class LevelKind { Other, Ceiling, Floor };

/** @brief How levels are looked for; lengths in metres, angles in radians. */
struct LevelParameters {
  double tolerance = 0.07; ///< distance of an inlier from its plane (paper, Table 1)
  double cell_size = 0.05; ///< cell of the grid in which sizes are counted
  double maximum_tilt = radians(Priors().max_slab_tilt); ///< a plane leans no more
  double minimum_area = 1.0; ///< square metres of occupied cells
  double minimum_room_height = Priors().min_headroom; ///< from a floor to its ceiling
  double least_step =
      Priors().min_floor_step; ///< rooms whose slabs differ by less may share a level
  Priors priors;
  std::uint64_t seed = 1;
  unsigned threads = 0; ///< 0: as many as there are processors
};

/** @brief What is seen how often at each height: where levels are looked for. */
struct HeightHistogram {
  /** @brief A stretch of heights in which something was seen. */
  struct Bin {
    double low = 0;        ///< its lower end, metres
    std::size_t cells = 0; ///< grid cells with a point in it, walls left out
  };

  double bin_height = 0; ///< metres
  std::vector<Bin> bins; ///< by increasing height
};

} // namespace sedr

/** @brief A horizontal plane as HorizontalPlaneDetection finds it. */
struct HorizontalPlane {
  pcl::PointIndices
      inliers; ///< points within the distance threshold, increasing; not those of walls
  pcl::ModelCoefficients
      coefficients; ///< a, b, c, d of a x + b y + c z + d = 0, unit normal up
  sedr::LevelKind kind = sedr::LevelKind::Other;
  double height = 0;     ///< z in the middle of its cells, metres
  std::size_t cells = 0; ///< occupied grid cells, those of walls left out
  double area = 0;       ///< of these cells, square metres
  double residual =
      0; ///< root mean square distance of the points it was fitted to, metres
  sedr::PlanSlab slab; ///< the same plane in double precision
};

/** @brief Finds the horizontal planes of a scan and tells which are ceiling and which
 * floor (paper, section 2.3.1): the heights at which many grid cells are occupied say
 * where to look, RANSAC with a tilt limit finds the plane there. Frame: z up.
 * Non-finite points are never inliers.
 *
 * A scan may hold several ceilings and floors at different heights; a table top is
 * neither. What a glossy floor reflects is left out: getReflections(). Size counts in
 * occupied cells, so that the density of the scan does not matter. Time O(n log n) for
 * n points plus O(n) a plane; input thinned to the grid size is enough.
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

  /** @brief Distance within which a point belongs to a plane, metres, > 0. Default
   * 0.07. */
  void setDistanceThreshold(double threshold) { parameters_.tolerance = threshold; }
  double getDistanceThreshold() const { return parameters_.tolerance; }

  /** @brief Edge of the grid cells in which sizes are counted, metres, > 0. Default
   * 0.05. */
  void setGridSize(double size) { parameters_.cell_size = size; }
  double getGridSize() const { return parameters_.cell_size; }

  /** @brief Largest angle of a plane with the horizontal, radians, 0 to pi/4. Default 3
   * degrees. */
  void setMaximumTilt(double tilt) { parameters_.maximum_tilt = tilt; }
  double getMaximumTilt() const { return parameters_.maximum_tilt; }

  /** @brief Smallest plane, square metres of occupied cells, > 0. Default 1. */
  void setMinimumArea(double area) { parameters_.minimum_area = area; }
  double getMinimumArea() const { return parameters_.minimum_area; }

  /** @brief Smallest height of a ceiling above its floor, metres, > 0. Default 1.8. */
  void setMinimumRoomHeight(double height) { parameters_.minimum_room_height = height; }
  double getMinimumRoomHeight() const { return parameters_.minimum_room_height; }

  /** @brief What is believed of buildings; headroom, tilt and steps with them. */
  void setPriors(const sedr::Priors& priors)
  {
    parameters_.priors = priors;
    parameters_.maximum_tilt = sedr::radians(priors.max_slab_tilt);
    parameters_.minimum_room_height = priors.min_headroom;
    parameters_.least_step = priors.min_floor_step;
  }
  const sedr::Priors& getPriors() const { return parameters_.priors; }

  /** @brief Seed of the random samples. Default 1. */
  void setSeed(std::uint64_t seed) { parameters_.seed = seed; }
  std::uint64_t getSeed() const { return parameters_.seed; }

  /** @brief Number of threads, 0 (default) for all processors. The planes do not depend
   * on it. */
  void setNumberOfThreads(unsigned threads) { parameters_.threads = threads; }
  unsigned getNumberOfThreads() const { return parameters_.threads; }

  /** @brief Finds the planes, lowest first.
   * @param[out] planes cleared first; empty where nothing was found
   * @return false, with a reason in getErrorMessage(), for bad input or parameters or
   * where there is no plane of the minimum area */
  bool segment(std::vector<HorizontalPlane>& planes);

  /** @brief The heights at which the last run looked for planes: cells seen at each,
   * walls left out. Empty after bad input or parameters. */
  const sedr::HeightHistogram& getHeightHistogram() const { return histogram_; }

  /** @brief The points that the last run left out as reflections in a floor.
   * Indices, increasing. */
  const pcl::Indices& getReflections() const { return reflections_; }

private:
  using PCLBase<PointT>::input_;
  using PCLBase<PointT>::indices_;

  sedr::LevelParameters parameters_;
  pcl::Indices reflections_;
  sedr::HeightHistogram histogram_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/sedr_segmentation/impl/horizontal_plane_detection.hpp>
#endif
