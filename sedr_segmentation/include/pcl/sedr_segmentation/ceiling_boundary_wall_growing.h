// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/impl/stage_error.h>

#include <pcl/PointIndices.h>
#include <pcl/pcl_base.h>

#include <cmath>
#include <limits>
#include <string>

namespace pcl {
namespace sedr {

/** @brief Parameters of the boundary test of slabs (paper, section 2.3.2 and Table 1).
 */
struct BoundaryOptions {
  unsigned int neighbors = 200; ///< nearest points, including the point itself
  float angle =
      static_cast<float>(M_PI / 3); ///< maximum gap of an inner point, radians
  unsigned int threads = 0;         ///< 0: all processors
};

/** @brief Parameters of the growing of walls from seeds (paper, section 2.3.2). */
struct WallGrowingOptions {
  double distance = 0.15; ///< maximum, in plan, seed to wall point, metres
  /** Height that separates upper and lower seeds, metres; NaN: no division. */
  double slice_height = std::numeric_limits<double>::quiet_NaN();
  unsigned int threads = 0; ///< 0: all processors

  bool hasSlice() const { return !std::isnan(slice_height); }
};

/** @brief Result of CeilingBoundaryWallGrowing: indices, increasing. */
struct GrownWalls {
  pcl::Indices walls;            ///< without the details
  pcl::Indices with_details;     ///< wall points and details
  pcl::Indices ceiling_boundary; ///< boundary points of the ceiling
  pcl::Indices
      scope_boundary; ///< boundary points of ceiling and details together, in plan
  pcl::Indices floor_boundary;
};

} // namespace sedr

/** @brief Finds the wall points of a room (paper, section 2.3.2). The seeds are the
 * boundary points of the ceiling; points near a seed in plan are walls. Frame: z up.
 *
 * A ceiling point is a boundary point if the horizontal directions to its nearest
 * neighbors leave a gap wider than an angle, as in pcl::BoundaryEstimation. With
 * structural details and a slice height, the seeds above the slice are the boundaries
 * of the ceiling and of ceiling and details together. The seeds below the slice are the
 * boundary of the floor, and the details join the walls (paper, Figure 6). Ceiling,
 * floor and non-finite points are never wall points.
 *
 * Process one room at a time: across a partition wall of 10 cm, the ceilings of two
 * rooms leave no gap wide enough. The result does not depend on the number of threads.
 * Time O((c + n) log c) for c ceiling and n candidate points; the factor grows with the
 * number of neighbors along the boundary.
 * @code
 * pcl::CeilingBoundaryWallGrowing<pcl::PointXYZ> growing;
 * growing.setInputCloud(thinned);
 * growing.setCeilingIndices(ceiling);
 * growing.setFloorIndices(floor);
 * pcl::PointIndices walls;
 * if (!growing.segment(walls))
 *   std::cerr << growing.getErrorMessage() << '\n';
 * @endcode */
template <typename PointT>
class CeilingBoundaryWallGrowing : public PCLBase<PointT>, public sedr::StageError {
public:
  using Ptr = shared_ptr<CeilingBoundaryWallGrowing<PointT>>;
  using ConstPtr = shared_ptr<const CeilingBoundaryWallGrowing<PointT>>;

  /** @brief Sets the points of the ceiling; at least 3 must be finite. The indices of
   * setIndices() are the candidates for walls, by default all points. */
  void setCeilingIndices(const sedr::StageIndices& indices)
  {
    ceiling_ = indices.get();
  }
  IndicesConstPtr getCeilingIndices() const { return ceiling_; }

  /** @brief Sets the points of the floor. Required with a slice height. */
  void setFloorIndices(const sedr::StageIndices& indices) { floor_ = indices.get(); }
  IndicesConstPtr getFloorIndices() const { return floor_; }

  /** @brief Sets the points of structural details, see GridSliceDetail. Ignored without
   * a slice height. */
  void setDetailIndices(const sedr::StageIndices& indices) { details_ = indices.get(); }
  IndicesConstPtr getDetailIndices() const { return details_; }

  /** @brief Sets the height that separates walls below and beside the details, metres,
   * in the frame of the cloud. Default NaN: no details, no division. */
  void setSliceHeight(double z) { growing_.slice_height = z; }
  double getSliceHeight() const { return growing_.slice_height; }

  /** @brief Sets the number of nearest points of the boundary test, including the point
   * itself, >= 3. Default 200. */
  void setNumberOfNeighbors(unsigned int number) { boundary_.neighbors = number; }
  unsigned int getNumberOfNeighbors() const { return boundary_.neighbors; }

  /** @brief Sets the maximum gap between directions around an inner point, radians (as
   * in pcl::BoundaryEstimation), above 0 and below 2 pi. Default pi / 3. */
  void setAngleThreshold(float angle) { boundary_.angle = angle; }
  float getAngleThreshold() const { return boundary_.angle; }

  /** @brief Sets the maximum distance of a wall point from a seed in plan, metres, > 0.
   * Default 0.15: two cells of 0.05 m from the outermost ceiling point, and a voxel. */
  void setDistanceThreshold(double distance) { growing_.distance = distance; }
  double getDistanceThreshold() const { return growing_.distance; }

  /** @brief Sets the number of threads, 0 (default) for all processors. */
  void setNumberOfThreads(unsigned int threads)
  {
    boundary_.threads = growing_.threads = threads;
  }
  unsigned int getNumberOfThreads() const { return boundary_.threads; }

  /** @brief Finds the wall points.
   * @param[out] walls wall and detail points, increasing; cleared first
   * @return false, with a reason in getErrorMessage(), for bad input or parameters. No
   * wall near the boundary is no error: `walls` is then empty. */
  bool segment(pcl::PointIndices& walls);

  /** @brief Returns the wall points of the last run without the details, increasing. */
  const pcl::Indices& getWallIndices() const { return result_.walls; }

  /** @brief Returns the boundary points of the ceiling in the last run, increasing. */
  const pcl::Indices& getBoundaryIndices() const { return result_.ceiling_boundary; }

  /** @brief Returns the boundary points of ceiling and details together, in plan; empty
   * without a slice height. */
  const pcl::Indices& getScopeBoundaryIndices() const { return result_.scope_boundary; }

  /** @brief Returns the boundary points of the floor; empty without a slice height. */
  const pcl::Indices& getFloorBoundaryIndices() const { return result_.floor_boundary; }

private:
  using PCLBase<PointT>::input_;
  using PCLBase<PointT>::indices_;

  IndicesConstPtr ceiling_;
  IndicesConstPtr floor_;
  IndicesConstPtr details_;
  sedr::BoundaryOptions boundary_;
  sedr::WallGrowingOptions growing_;

  sedr::GrownWalls result_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/sedr_segmentation/impl/ceiling_boundary_wall_growing.hpp>
#endif
