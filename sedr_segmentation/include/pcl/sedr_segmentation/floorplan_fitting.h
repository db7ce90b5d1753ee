// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/impl/stage_error.h>
#include <pcl/sedr_filters/plan_warning.h>
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>
#include <pcl/sedr_filters/scan_frame.h>
#include <pcl/sedr_segmentation/building.h>

#include <pcl/pcl_base.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A place on the outline of a room, and what was seen of the wall there. */
struct ContourSample {
  Eigen::Vector2d place; ///< on the outline
  Eigen::Vector2d
      position; ///< mean of the points of the wall if there are, else `place`
  Eigen::Vector2d tangent; ///< unit, along the outline
  double support = 0;      ///< 1 if a wall was seen clearly, 0 if not at all
  std::size_t points = 0;  ///< number of points that support the wall here

  /** @brief Returns whether points support the wall here. */
  bool isSupported() const { return support > 0; }
};

/** @brief Parameters of the fit of a plan; lengths in metres. */
struct RoomFitParameters {
  Priors priors;
  double tolerance = 0.05; ///< farthest an inlier is from its curve (paper, Table 1)
  double cell_size = 0.05;
  double slab_tolerance = 0.05;      ///< of the planes of ceiling, floor and details
  double minimum_radius = 0.15;      ///< of an arc
  double maximum_radius = 500;       ///< of an arc; flatter ones are segments
  double minimum_detail_area = 0.25; ///< square metres
  std::uint64_t seed = 1;            ///< of the planes' random samples
  unsigned threads = 0;              ///< 0: all processors
};

/** @brief Cells of a room's ceiling and floor that the scan does not show though its
 * air reaches them: their places, with the height that is inferred, metres. */
struct HiddenCells {
  std::vector<Eigen::Vector3f> ceiling;
  std::vector<Eigen::Vector3f> floor;
};

/** @brief Noise of the walls of rooms that share heights, measured along straight
 * stretches of them; metres. */
struct WallNoise {
  double measured = 0;       ///< standard deviation of a place from a metre of its wall
  double correlation = 0.1;  ///< so long a piece of wall is one independent observation
  std::size_t stretches = 0; ///< in which it was measured; 0: too few, it was not
  std::vector<std::uint32_t> rooms; ///< their numbers
};

/** @brief Boundary points along a loop of a room (paper, Figure 7a). */
struct FittedBoundary {
  std::uint32_t room = 0;                      ///< number of the room
  StructureLabel label = StructureLabel::Wall; ///< Wall, or Column for an inner loop
  std::vector<ContourSample> samples;          ///< around the loop
};

} // namespace sedr

/** @brief Fits the floor plan of the rooms (paper, section 2.4 and Figure 7). Frame: z
 * up, metres.
 *
 * The lines and arcs of all faces of a storey part it into cells, and the labels of the
 * cells, a room or none, that make one energy smallest are its plan. The result is a
 * closed loop of segments and arcs per room, with columns as inner loops and details as
 * loops of their own height. Room numbers of the points separate the rooms, see
 * setRooms(); without them there is one room. A plan has no niches and no
 * evidence before OpeningDetection. Non-finite points are left out. O(n log n) for n
 * points plus the cells of the rooms' bounding boxes.
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

  /** @brief Sets the points of the main ceilings. Required. */
  void setCeilingIndices(const sedr::StageIndices& ceiling)
  {
    ceiling_ = ceiling.get();
  }
  IndicesConstPtr getCeilingIndices() const { return ceiling_; }

  /** @brief Sets the points of the floors. Required. */
  void setFloorIndices(const sedr::StageIndices& floor) { floor_ = floor.get(); }
  IndicesConstPtr getFloorIndices() const { return floor_; }

  /** @brief Sets the points of structural details, see GridSliceDetail. Optional. */
  void setDetailIndices(const sedr::StageIndices& details) { details_ = details.get(); }
  IndicesConstPtr getDetailIndices() const { return details_; }

  /** @brief Sets the wall points, see CeilingBoundaryWallGrowing. Default: all points.
   */
  void setWallIndices(const sedr::StageIndices& walls) { walls_ = walls.get(); }
  IndicesConstPtr getWallIndices() const { return walls_; }

  /** @brief Sets the room of every point of the cloud, 0 for none. Empty (default): the
   * field `room` of the point type, or one room if it has no such field. */
  void setRooms(std::vector<std::uint32_t> rooms) { rooms_ = std::move(rooms); }

  /** @brief Sets what of each room was hidden, by its number. Hidden cells are of the
   * room as those that were seen, but no surface is fitted to them where three points
   * were seen. Default: none. */
  void setHiddenCells(std::map<std::uint32_t, sedr::HiddenCells> hidden)
  {
    hidden_ = std::move(hidden);
  }

  /** @brief Sets the owner of every point of the cloud. Empty (default): the room with
   * the nearest ceiling at the heights of the point. */
  void setOwners(std::vector<sedr::PointOwner> owners) { owners_ = std::move(owners); }

  /** @brief Sets the scan from which the input cloud was thinned, of any point type.
   * The plan found on the input cloud is then fitted to the scan near each element,
   * which is an order of magnitude more accurate. Null (default): no such fit.
   * @param indices the points of the scan to use; null: all */
  template <typename RawPointT>
  void setRawCloud(const shared_ptr<const pcl::PointCloud<RawPointT>>& raw,
                   const sedr::StageIndices& indices = nullptr)
  {
    raw_ = nullptr;
    if (raw)
      raw_ = [raw] { return sedr::PointView(*raw); };
    raw_indices_ = indices.get();
  }

  /** @brief Sets the raw cloud from a pointer to a mutable cloud. */
  template <typename RawPointT>
  void setRawCloud(const shared_ptr<pcl::PointCloud<RawPointT>>& raw,
                   const sedr::StageIndices& indices = nullptr)
  {
    setRawCloud(shared_ptr<const pcl::PointCloud<RawPointT>>(raw), indices);
  }

  /** @brief Removes the raw cloud. */
  void setRawCloud(std::nullptr_t) { setRawPoints(nullptr); }

  /** @brief Sets the raw cloud as a list of points, metres; null: none. */
  void setRawPoints(const std::shared_ptr<const std::vector<Eigen::Vector3f>>& raw)
  {
    raw_ = nullptr;
    if (raw)
      raw_ = [raw] {
        return sedr::PointView(raw->data(), sizeof(Eigen::Vector3f), raw->size());
      };
    raw_indices_ = nullptr;
  }

  /** @brief Transforms the raw points by `map`; copies only those that the fit uses. */
  void moveRawPoints(const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& map);

  /** @brief Returns the current raw points, empty if there are none; see
   * getRawIndices(). */
  sedr::PointView getRawPoints() const { return raw_ ? raw_() : sedr::PointView(); }

  /** @brief Returns the indices of the raw points to use; null: all. */
  IndicesConstPtr getRawIndices() const { return raw_indices_; }

  /** @brief Sets the number of threads; 0 (default): all processors. */
  void setNumberOfThreads(unsigned threads) { parameters_.threads = threads; }
  unsigned getNumberOfThreads() const { return parameters_.threads; }

  /** @brief Sets the maximum distance of an inlier from its line or circle, metres,
   * above 0 and at most 1. Default 0.05 (paper, Table 1). A surface is seen on a line
   * within three fifths of it: the rest is left to the wall's own unevenness. */
  void setDistanceThreshold(double threshold) { parameters_.tolerance = threshold; }
  double getDistanceThreshold() const { return parameters_.tolerance; }

  /** @brief Sets the edge of a grid cell, metres, > 0. Default 0.05. */
  void setGridSize(double size) { parameters_.cell_size = size; }
  double getGridSize() const { return parameters_.cell_size; }

  /** @brief Sets the limits of the radii of arcs, metres, 0 < minimum < maximum;
   * flatter walls are segments. Default 0.15 to 500. */
  void setRadiusLimits(double minimum, double maximum)
  {
    parameters_.minimum_radius = minimum;
    parameters_.maximum_radius = maximum;
  }
  double getMinimumRadius() const { return parameters_.minimum_radius; }
  double getMaximumRadius() const { return parameters_.maximum_radius; }

  /** @brief Sets the minimum area of a detail, square metres, > 0. Default 0.25. */
  void setMinimumDetailArea(double area) { parameters_.minimum_detail_area = area; }
  double getMinimumDetailArea() const { return parameters_.minimum_detail_area; }

  /** @brief Sets the priors about buildings, furniture and scanners. */
  void setPriors(const sedr::Priors& priors) { parameters_.priors = priors; }
  const sedr::Priors& getPriors() const { return parameters_.priors; }

  /** @brief Sets the seed of the random samples. Default 1. */
  void setSeed(std::uint64_t seed) { parameters_.seed = seed; }
  std::uint64_t getSeed() const { return parameters_.seed; }

  /** @brief Fits the plan.
   * @param[out] plan its rooms by increasing number; empty if there are none
   * @return false, with a reason in getErrorMessage(), for bad input or parameters or
   * if no room could be fitted */
  bool segment(sedr::Floorplan& plan);

  /** @brief Returns the warnings: rooms that could not be fitted,
   * ceilings with a part left out, and a raw cloud that could not be used. */
  const std::vector<sedr::PlanWarning>& getWarnings() const { return warnings_; }

  /** @brief Returns the boundary points along the walls and columns of the last run. */
  const std::vector<sedr::FittedBoundary>& getBoundaries() const { return boundaries_; }

  /** @brief Returns the noise of the walls in the last run, storey by storey. */
  const std::vector<sedr::WallNoise>& getWallNoise() const { return noise_; }

private:
  using PCLBase<PointT>::input_;
  using PCLBase<PointT>::indices_;

  IndicesConstPtr ceiling_;
  IndicesConstPtr floor_;
  IndicesConstPtr details_;
  IndicesConstPtr walls_;
  std::vector<std::uint32_t> rooms_;
  std::map<std::uint32_t, sedr::HiddenCells> hidden_;
  std::vector<sedr::PointOwner> owners_;
  std::function<sedr::PointView()> raw_; ///< returns the current raw cloud
  IndicesConstPtr raw_indices_;
  sedr::RoomFitParameters parameters_;
  std::vector<sedr::PlanWarning> warnings_;
  std::vector<sedr::FittedBoundary> boundaries_;
  std::vector<sedr::WallNoise> noise_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/sedr_segmentation/impl/floorplan_fitting.hpp>
#endif
