// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/impl/stage_error.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>

#include <pcl/pcl_base.h>

#include <memory>

namespace pcl {
namespace sedr {

struct OpeningSearch;
class SightLines;

} // namespace sedr

/** @brief Finds the doors, windows, passages and niches in the walls of a floor plan,
 * and which shares of the walls a scan shows. Frame: z up, metres.
 *
 * For each side of a wall, flat or curved, the scan is sorted into a map of arc length
 * and height: a cell was seen on the face, shows something within the wall, is hidden
 * by something before it, or shows nothing. Openings are the rectangles on the maps of
 * both sides that are likeliest together, found exactly; their edges are then fitted to
 * the reveals, or else to the rims of the faces. What is in doubt is
 * OpeningKind::Unknown. Non-finite points are left out. O(n) for n points, plus for
 * each side its columns times the square of its rows.
 * @code
 * pcl::OpeningDetection<pcl::PointXYZ> detection;
 * detection.setInputCloud(scan); // before thinning
 * detection.segment(plan);       // sets plan.openings, niches, evidence of walls
 * @endcode */
template <typename PointT>
class OpeningDetection : public PCLBase<PointT>, public sedr::StageError {
public:
  using Ptr = shared_ptr<OpeningDetection<PointT>>;
  using ConstPtr = shared_ptr<const OpeningDetection<PointT>>;

  /** @brief Sets the number of threads; 0 (default): all processors. */
  void setNumberOfThreads(unsigned threads) { threads_ = threads; }
  unsigned getNumberOfThreads() const { return threads_; }

  /** @brief Sets the priors about walls and furniture. */
  void setPriors(const sedr::Priors& priors) { priors_ = priors; }
  const sedr::Priors& getPriors() const { return priors_; }

  /** @brief Sets the rays of the scanners, in the frame of the points: what they went
   * through is open. Null (default): not known. */
  void setSightLines(const std::shared_ptr<const sedr::SightLines>& sight)
  {
    sight_ = sight;
  }
  std::shared_ptr<const sedr::SightLines> getSightLines() const { return sight_; }

  /** @brief Sets the openings of a plan to those found in the input cloud, by
   * decreasing evidence, the niches of its rooms and PlanElement::evidence of its walls.
   * @return false, with a reason in getErrorMessage(), for bad input; a plan without
   * openings is no failure */
  bool segment(sedr::Floorplan& plan);

  /** @brief As above, in points that are kept elsewhere.
   * @param indices of the points to use; null: all */
  bool segment(const sedr::PointView& points,
               const IndicesConstPtr& indices,
               sedr::Floorplan& plan);

  /** @brief Returns the maps of the last run, for pictures; null before it. */
  std::shared_ptr<const sedr::OpeningSearch> getSearch() const { return search_; }

private:
  using PCLBase<PointT>::input_;
  using PCLBase<PointT>::indices_;

  unsigned threads_ = 0;
  sedr::Priors priors_;
  std::shared_ptr<const sedr::SightLines> sight_;
  std::shared_ptr<const sedr::OpeningSearch> search_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/sedr_segmentation/impl/opening_detection.hpp>
#endif
