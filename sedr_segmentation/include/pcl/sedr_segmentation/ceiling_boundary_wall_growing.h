// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/stage_error.h>

#include <pcl/PointIndices.h>
#include <pcl/pcl_base.h>
#include <pcl/search/search.h>

#include <cmath>
#include <limits>
#include <string>

namespace pcl {
namespace sedr {

/** @brief When a point of a slab lies on its boundary (paper, section 2.3.2 and Table
 * 1). */
struct BoundaryOptions {
  unsigned int neighbours =
      200; ///< nearest points looked at, the point itself among them
  float angle = static_cast<float>(M_PI / 3); ///< widest gap of an inner point, radians
  unsigned int threads = 0;                   ///< 0 takes all processors
};

/** @brief How walls grow from their seeds (paper, section 2.3.2). */
struct WallGrowingOptions {
  double distance = 0.15; ///< in plan, seed to wall point, metres
  /** From this height up the seeds above it count, below it the others; NaN: no
   * division. */
  double slice_height = std::numeric_limits<double>::quiet_NaN();
  /** For the support; NaN: the median of the floor. */
  double floor_height = std::numeric_limits<double>::quiet_NaN();
  double minimum_support = 0; ///< of a rim, share 0 to 1; 0 asks for none
  unsigned int threads = 0;   ///< 0 takes all processors

  bool hasSlice() const { return !std::isnan(slice_height); }
};

/** @brief The seeds of walls: indices of finite points, ascending. */
struct WallSeeds {
  pcl::Indices above; ///< of the whole height where there is no slice
  pcl::Indices below;
};

/** @brief What CeilingBoundaryWallGrowing found: indices, ascending. */
struct GrownWalls {
  pcl::Indices walls;            ///< without the details
  pcl::Indices with_details;     ///< the same and the details
  pcl::Indices ceiling_boundary; ///< boundary points of the ceiling
  pcl::Indices scope_boundary;   ///< of ceiling and details, seen in plan
  pcl::Indices floor_boundary;
  WallSeeds seeds; ///< that had the minimum support
};

} // namespace sedr

/** @brief Finds the wall points of a room: the boundary points of its ceiling are the
 * seeds, and what lies near a seed in plan is wall (paper, section 2.3.2). Frame: z up.
 *
 * A ceiling point is a boundary point where the directions to its nearest neighbours,
 * seen from above, leave a gap wider than an angle, as in pcl::BoundaryEstimation. With
 * structural details and a slice height the seeds above the slice are the boundary of
 * the ceiling and that of the room's scope (ceiling and details together), below it the
 * boundary of the floor; the details join the walls (paper, Figure 6). Ceiling and
 * floor points are never walls, nor are non-finite points.
 *
 * Give it one room at a time: across a partition wall of 10 cm the ceilings of two
 * rooms leave no gap wide enough. The same result for any number of threads. Time O((c
 * + n) log c) for c ceiling and n candidate points, the factor growing with the number
 * of neighbours along the boundary.
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
  using SearchPtr = typename pcl::search::Search<PointT>::Ptr;

  /** @brief The points of the ceiling, of which at least 3 must be finite. The indices
   * of setIndices() are the candidates for walls; by default all points are. */
  void setCeilingIndices(const sedr::StageIndices& indices)
  {
    ceiling_ = indices.get();
  }
  IndicesConstPtr getCeilingIndices() const { return ceiling_; }

  /** @brief The points of the floor. Needed with a slice height. */
  void setFloorIndices(const sedr::StageIndices& indices) { floor_ = indices.get(); }
  IndicesConstPtr getFloorIndices() const { return floor_; }

  /** @brief The points of structural details, as GridSliceDetail finds them. Of no
   * effect without a slice height. */
  void setDetailIndices(const sedr::StageIndices& indices) { details_ = indices.get(); }
  IndicesConstPtr getDetailIndices() const { return details_; }

  /** @brief Height that divides the walls below the details from those beside them,
   * metres, in the frame of the cloud. Default NaN: no details, no division. */
  void setSliceHeight(double z) { growing_.slice_height = z; }
  double getSliceHeight() const { return growing_.slice_height; }

  /** @brief How many nearest points decide whether one is boundary, itself among them,
   * >= 3. Default 200. */
  void setNumberOfNeighbors(unsigned int number) { boundary_.neighbours = number; }
  unsigned int getNumberOfNeighbors() const { return boundary_.neighbours; }

  /** @brief Widest gap between directions around an inner point, radians (as in
   * pcl::BoundaryEstimation), above 0 and below 2 pi. Default pi / 3, 60 degrees. */
  void setAngleThreshold(float angle) { boundary_.angle = angle; }
  float getAngleThreshold() const { return boundary_.angle; }

  /** @brief Farthest a wall point may be from a seed in plan, metres, > 0. Default
   * 0.15: two cells of 0.05 m from the outermost point of the ceiling, and a voxel. */
  void setDistanceThreshold(double distance) { growing_.distance = distance; }
  double getDistanceThreshold() const { return growing_.distance; }

  /** @brief Least support of a rim, share from 0 to 1. Default 0: none is asked for.
   *
   * Seeds that touch each other on a grid of the distance threshold are one rim. From
   * every seed cell a column of 3 x 3 cells hangs down to the floor (to the slice,
   * where there is one); its share of height cells that hold candidate or detail
   * points, averaged over the rim, is the support. Rims below the minimum seed no wall:
   * lamps hang short of the floor, columns and walls with their doors and windows do
   * not. Needs setFloorHeight() or floor indices. */
  void setMinimumSupport(double share) { growing_.minimum_support = share; }
  double getMinimumSupport() const { return growing_.minimum_support; }

  /** @brief Height of the floor for the support, metres. Default NaN: the median height
   * of the floor points. */
  void setFloorHeight(double z) { growing_.floor_height = z; }
  double getFloorHeight() const { return growing_.floor_height; }

  /** @brief Number of threads, 0 (default) for all processors. */
  void setNumberOfThreads(unsigned int threads)
  {
    boundary_.threads = growing_.threads = threads;
  }
  unsigned int getNumberOfThreads() const { return boundary_.threads; }

  /** @brief Search for the neighbours on ceiling and floor; must allow concurrent
   * queries. By default, and with nullptr, a k-d tree. */
  void setSearchMethod(const SearchPtr& search) { search_ = search; }
  SearchPtr getSearchMethod() const { return search_; }

  /** @brief Finds the walls.
   * @param[out] walls wall and detail points, increasing; cleared first
   * @return false, with a reason in getErrorMessage(), for bad input or parameters. No
   * wall near the boundary is no error: walls is empty then. */
  bool segment(pcl::PointIndices& walls);

  /** @brief Wall points of the last run without the details, increasing. */
  const pcl::Indices& getWallIndices() const { return result_.walls; }

  /** @brief Boundary points of the ceiling, increasing; filled by segment(), as those
   * below. */
  const pcl::Indices& getBoundaryIndices() const { return result_.ceiling_boundary; }

  /** @brief Boundary points of ceiling and details together, seen in plan; empty
   * without a slice height. */
  const pcl::Indices& getScopeBoundaryIndices() const { return result_.scope_boundary; }

  /** @brief Boundary points of the floor; empty without a slice height. */
  const pcl::Indices& getFloorBoundaryIndices() const { return result_.floor_boundary; }

  /** @brief Seeds of the last run, above and below the slice height: the boundary
   * points without those of rims that had less than the minimum support. All are above
   * where there is no slice height. */
  const sedr::WallSeeds& getSeeds() const { return result_.seeds; }

private:
  using PCLBase<PointT>::input_;
  using PCLBase<PointT>::indices_;

  IndicesConstPtr ceiling_;
  IndicesConstPtr floor_;
  IndicesConstPtr details_;
  SearchPtr search_;
  sedr::BoundaryOptions boundary_;
  sedr::WallGrowingOptions growing_;

  sedr::GrownWalls result_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/sedr_segmentation/impl/ceiling_boundary_wall_growing.hpp>
#endif
