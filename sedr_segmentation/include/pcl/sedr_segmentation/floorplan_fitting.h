// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/levelling.h>
#include <pcl/sedr_filters/stage_error.h>
#include <pcl/sedr_segmentation/plan_fit.h>

#include <pcl/pcl_base.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pcl {

/** @brief Fits the floor plan of the rooms (paper, section 2.4 and Figure 7): lines and
 * circles by seeded 2D RANSAC along the outline of ceiling and details, then by robust
 * least squares to the wall points; closed loops of segments and arcs a room, columns
 * as inner loops, details as loops with a height of their own. Frame: z up, metres.
 *
 * Room numbers of the points part the rooms, see setRooms(); without them all is one
 * room. Non-finite points are left out. O(n log n) for n points plus the cells of the
 * rooms' boxes.
 * @code
 * pcl::FloorplanFitting<pcl::PointXYZ> fitting;
 * fitting.setInputCloud(thinned);
 * fitting.setCeilingIndices(ceiling);
 * fitting.setFloorIndices(floor);
 * fitting.setWallIndices(walls);
 * pcl::sedr::Floorplan plan;
 * fitting.segment(plan);
 * @endcode */
template <typename PointT>
class FloorplanFitting : public PCLBase<PointT>, public sedr::StageError {
public:
  using Ptr = shared_ptr<FloorplanFitting<PointT>>;
  using ConstPtr = shared_ptr<const FloorplanFitting<PointT>>;

  /** @brief Points of the main ceilings. Needed. */
  void setCeilingIndices(const IndicesConstPtr& ceiling) { ceiling_ = ceiling; }
  IndicesConstPtr getCeilingIndices() const { return ceiling_; }

  /** @brief Points of the floors. Needed. */
  void setFloorIndices(const IndicesConstPtr& floor) { floor_ = floor; }
  IndicesConstPtr getFloorIndices() const { return floor_; }

  /** @brief Points of structural details, as GridSliceDetail gives them. May be left
   * out. */
  void setDetailIndices(const IndicesConstPtr& details) { details_ = details; }
  IndicesConstPtr getDetailIndices() const { return details_; }

  /** @brief Points of walls, as CeilingBoundaryWallGrowing gives them; left out: all
   * points. */
  void setWallIndices(const IndicesConstPtr& walls) { walls_ = walls; }
  IndicesConstPtr getWallIndices() const { return walls_; }

  /** @brief Points of ceilings that are not level, as they were seen: rooms that have
   * some get a ceiling of facets (PlanDetail::is_facet, PlanSlab::curve), unless these
   * explain too little of it. Those of the room are among the points of the ceilings
   * and details, too. May be left out. */
  void setSheetIndices(const IndicesConstPtr& sheets) { sheets_ = sheets; }
  IndicesConstPtr getSheetIndices() const { return sheets_; }

  /** @brief Room of every point of the cloud, 0 none; empty (default): the field `room`
   * of the point type, or one room where it has none. */
  void setRooms(std::vector<std::uint32_t> rooms) { rooms_ = std::move(rooms); }

  /** @brief The scan that the input cloud was thinned from, of any point type: the plan
   * is found on the input cloud and then fitted to the scan near each of its elements,
   * which is more exact by an order of magnitude. Left out, or null: the plan stays as
   * found.
   * @param indices the points of it that count; null: all */
  template <typename RawPointT>
  void setRawCloud(const shared_ptr<const pcl::PointCloud<RawPointT>>& raw,
                   const IndicesConstPtr& indices = nullptr)
  {
    raw_ = nullptr;
    if (raw)
      raw_ = [raw] { return sedr::PointView(*raw); };
    raw_indices_ = indices;
  }

  /** @brief The same of a list of its points, say a sedr::ScanExcerpt's; null: none. */
  void setRawPoints(const std::shared_ptr<const std::vector<Eigen::Vector3f>>& raw)
  {
    raw_ = nullptr;
    if (raw)
      raw_ = [raw] {
        return sedr::PointView(raw->data(), sizeof(Eigen::Vector3f), raw->size());
      };
    raw_indices_ = nullptr;
  }

  /** @brief Takes the raw points as a levelling turns them: a copy of no more of them
   * than the fit looks at. */
  void levelRawPoints(const sedr::Levelling& levelling);

  /** @brief Number of threads; 0 (default): all processors.
   */
  void setNumberOfThreads(unsigned threads) { parameters_.threads = threads; }
  unsigned getNumberOfThreads() const { return parameters_.threads; }

  /** @brief Distance of an inlier from its line or circle, metres, above 0 and at
   * most 1. Default 0.05 (paper, Table 1). */
  void setDistanceThreshold(double threshold)
  {
    parameters_.loop.tolerance = threshold;
  }
  double getDistanceThreshold() const { return parameters_.loop.tolerance; }

  /** @brief Edge of a grid cell, metres, > 0. Default 0.05. */
  void setGridSize(double size) { parameters_.cell_size = size; }
  double getGridSize() const { return parameters_.cell_size; }

  /** @brief Shortest element with a line or circle of its own, metres, > 0. Default
   * 0.2. */
  void setMinimumLength(double length) { parameters_.loop.minimum_length = length; }
  double getMinimumLength() const { return parameters_.loop.minimum_length; }

  /** @brief Radii of arcs, metres, 0 < minimum < maximum; flatter walls are segments.
   * Default 0.15 to 25. */
  void setRadiusLimits(double minimum, double maximum)
  {
    parameters_.loop.minimum_radius = minimum;
    parameters_.loop.maximum_radius = maximum;
  }
  double getMinimumRadius() const { return parameters_.loop.minimum_radius; }
  double getMaximumRadius() const { return parameters_.loop.maximum_radius; }

  /** @brief Smallest detail that becomes part of the plan, square metres, > 0. Default
   * 0.25. */
  void setMinimumDetailArea(double area) { parameters_.minimum_detail_area = area; }
  double getMinimumDetailArea() const { return parameters_.minimum_detail_area; }

  /** @brief Seed of the random samples. Default 1. */
  void setSeed(std::uint64_t seed) { parameters_.loop.seed = seed; }
  std::uint64_t getSeed() const { return parameters_.loop.seed; }

  /** @brief Fits the plan.
   * @param[out] plan its rooms by increasing number; empty where there is none
   * @return false, with a reason in getErrorMessage(), for bad input or parameters or
   * where no room could be fitted */
  bool segment(sedr::Floorplan& plan);

  /** @brief A sentence for every room that could not be fitted while others could, or
   * of whose ceiling a part is left out, and one if the raw cloud could not be used. */
  const std::vector<std::string>& getWarnings() const { return warnings_; }

  /** @brief The boundary points that walls and columns were fitted to in the last run,
   * those of rooms that could not be fitted too. */
  const std::vector<sedr::FittedBoundary>& getBoundaries() const { return boundaries_; }

private:
  using PCLBase<PointT>::input_;
  using PCLBase<PointT>::indices_;

  bool validate();

  bool checkPart(const char* name, const IndicesConstPtr& indices, bool is_needed);

  bool run(sedr::Floorplan& plan);

  void fitToRaw(sedr::Floorplan& plan);

  IndicesConstPtr ceiling_;
  IndicesConstPtr floor_;
  IndicesConstPtr details_;
  IndicesConstPtr walls_;
  IndicesConstPtr sheets_;
  std::vector<std::uint32_t> rooms_;
  std::function<sedr::PointView()> raw_; ///< the raw cloud as it is then
  IndicesConstPtr raw_indices_;
  sedr::RoomFitParameters parameters_;
  std::vector<std::string> warnings_;
  std::vector<sedr::FittedBoundary> boundaries_;
};

} // namespace pcl
