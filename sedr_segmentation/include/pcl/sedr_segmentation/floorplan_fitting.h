// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>
#include <pcl/sedr_filters/scan_frame.h>
#include <pcl/sedr_filters/stage_error.h>

#include <pcl/pcl_base.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief How a loop is fitted to a contour; metres. */
struct LoopParameters {
  double tolerance = 0.05; ///< distance of an inlier from its curve (paper, Table 1)
  double expected_offset =
      -0.025;          ///< where the wall is looked for, from the contour, inside > 0
  double reach = 0.06; ///< how far from there it may be: a farther one is another wall
  double evidence_span =
      0.05; ///< how far along the contour a sample looks for it to each side
  double corner_reach = 0.15;  ///< how far from the contour two curves meet in a corner
  double minimum_length = 0.2; ///< of an element that has a curve of its own
  double minimum_radius = 0.15; ///< of an arc
  double maximum_radius = 25.0; ///< of an arc; flatter ones are segments
  Priors priors;
  std::uint64_t seed = 1;
  unsigned threads = 1; ///< that share a loop; 0: as many as there are processors
};

/** @brief A place on a contour, moved onto the wall where points show one. */
struct ContourSample {
  Eigen::Vector2d place;    ///< on the contour, its staircase evened out
  Eigen::Vector2d position; ///< on the wall, where points show one, or else the place
  Eigen::Vector2d tangent;  ///< unit, along the contour
  double support = 0;       ///< points by the loop's median, 1 at most; 0 for too few
  std::size_t points = 0;   ///< that show the wall here
  double deviation = 0;     ///< of these across the contour, root mean square, metres

  /** @brief Whether points show the wall here. */
  bool isSupported() const { return support > 0; }

  /** @brief What the sample counts for in a fit: little where only the contour shows
   * the wall. */
  double weight() const { return isSupported() ? support : 0.3; }
};

/** @brief How a room's plan is fitted; lengths in metres. */
struct RoomFitParameters {
  LoopParameters loop;
  double cell_size = 0.05;
  double slab_tolerance = 0.05;      ///< of the planes of ceiling, floor and details
  double minimum_detail_area = 0.25; ///< square metres
  unsigned threads = 0; ///< rooms fitted at a time; 0: as many as there are processors
};

/** @brief The boundary points that a loop of a room was fitted to (paper, Figure 7a).
 */
struct FittedBoundary {
  std::uint32_t room = 0;                      ///< number of the room
  StructureLabel label = StructureLabel::Wall; ///< Wall, or Column for an inner loop
  std::vector<ContourSample> samples;          ///< around the loop
};

} // namespace sedr

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
  void setCeilingIndices(const sedr::StageIndices& ceiling)
  {
    ceiling_ = ceiling.get();
  }
  IndicesConstPtr getCeilingIndices() const { return ceiling_; }

  /** @brief Points of the floors. Needed. */
  void setFloorIndices(const sedr::StageIndices& floor) { floor_ = floor.get(); }
  IndicesConstPtr getFloorIndices() const { return floor_; }

  /** @brief Points of structural details, as GridSliceDetail gives them. May be left
   * out. */
  void setDetailIndices(const sedr::StageIndices& details) { details_ = details.get(); }
  IndicesConstPtr getDetailIndices() const { return details_; }

  /** @brief Points of walls, as CeilingBoundaryWallGrowing gives them; left out: all
   * points. */
  void setWallIndices(const sedr::StageIndices& walls) { walls_ = walls.get(); }
  IndicesConstPtr getWallIndices() const { return walls_; }

  /** @brief Points of ceilings that are not level, as they were seen: rooms that have
   * some get a ceiling of facets (PlanDetail::is_facet, PlanSlab::curve), unless these
   * explain too little of it. Those of the room are among the points of the ceilings
   * and details, too. May be left out. */
  void setSheetIndices(const sedr::StageIndices& sheets) { sheets_ = sheets.get(); }
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
                   const sedr::StageIndices& indices = nullptr)
  {
    raw_ = nullptr;
    if (raw)
      raw_ = [raw] { return sedr::PointView(*raw); };
    raw_indices_ = indices.get();
  }

  /** @brief The same of a pointer that lets the cloud change. */
  template <typename RawPointT>
  void setRawCloud(const shared_ptr<pcl::PointCloud<RawPointT>>& raw,
                   const sedr::StageIndices& indices = nullptr)
  {
    setRawCloud(shared_ptr<const pcl::PointCloud<RawPointT>>(raw), indices);
  }

  /** @brief Leaves the raw cloud out again. */
  void setRawCloud(std::nullptr_t) { setRawPoints(nullptr); }

  /** @brief The same of a list of its points, metres; null: none. */
  void setRawPoints(const std::shared_ptr<const std::vector<Eigen::Vector3f>>& raw)
  {
    raw_ = nullptr;
    if (raw)
      raw_ = [raw] {
        return sedr::PointView(raw->data(), sizeof(Eigen::Vector3f), raw->size());
      };
    raw_indices_ = nullptr;
  }

  /** @brief Takes the raw points as `map` moves them: a copy of no more of them than
   * the fit looks at. */
  void moveRawPoints(const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& map);

  /** @brief The raw points as they are now, empty without; see getRawIndices(). */
  sedr::PointView getRawPoints() const { return raw_ ? raw_() : sedr::PointView(); }

  /** @brief Which of them count; null: all. */
  IndicesConstPtr getRawIndices() const { return raw_indices_; }

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

  /** @brief What is believed of buildings, furniture and scanners before the scan is
   * looked at. */
  void setPriors(const sedr::Priors& priors) { parameters_.loop.priors = priors; }
  const sedr::Priors& getPriors() const { return parameters_.loop.priors; }

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

#ifdef PCL_NO_PRECOMPILE
#include <pcl/sedr_segmentation/impl/floorplan_fitting.hpp>
#endif
