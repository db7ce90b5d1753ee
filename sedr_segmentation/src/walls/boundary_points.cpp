// SPDX-License-Identifier: BSD-3-Clause
#include "boundary_points.h"

#include "../curves/plan_points.h"
#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/middle_value.h"
#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/base/parallel_for.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>

#include <algorithm>
#include <cstdint>
#include <memory>

namespace pcl::sedr {

namespace {

/** @brief Returns the widest angle, radians, between successive directions, which are
 * sorted: pi on a straight rim, 3/2 pi on a protruding corner, 2 pi where there is no
 * direction at all. */
float
widestGap(std::vector<float>& directions)
{
  if (directions.empty())
    return full_turn;
  std::sort(directions.begin(), directions.end());
  float widest = full_turn - directions.back() + directions.front();
  for (std::size_t i = 1; i < directions.size(); ++i)
    widest = std::max(widest, directions[i] - directions[i - 1]);
  return widest;
}

/** @brief The boundary test of some places. */
class BoundaryTest {
public:
  BoundaryTest(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& places,
               const BoundaryOptions& options)
      : places_(*places)
      , options_(options)
      , tree_(false)
  {
    tree_.setInputCloud(places);
    usual_ = usualReach();
    std::vector<Eigen::Vector2d> plan;
    plan.reserve(places->size());
    for (const auto& p : *places)
      plan.emplace_back(p.x, p.y);
    in_plan_ = std::make_unique<PlanPoints>(plan, std::max(usual_, 0.01));
  }

  /** @brief There is no gap among the nearest where none is among fewer, and a wide one
   * where one is among more: circles tell of most places, the tree of the others. */
  bool isBoundary(std::size_t i) const
  {
    thread_local std::vector<float> directions;
    const Eigen::Vector3f place = places_[i].getVector3fMap();
    const auto see = [&](std::size_t k) {
      const Eigen::Vector3f way = places_[k].getVector3fMap() - place;
      if (way.x() != 0 || way.y() != 0)
        directions.push_back(std::atan2(way.y(), way.x()));
    };
    std::size_t count = 0;
    for (double reach = usual_; count < options_.neighbours && reach < 5 * usual_;
         reach *= 2.2) {
      directions.clear();
      count = 0;
      in_plan_->forEachIndexWithin(
          place.head<2>().cast<double>(), reach, [&](std::size_t k) {
            const std::size_t other = in_plan_->given(k);
            if ((places_[other].getVector3fMap() - place).norm() > reach)
              return;
            ++count;
            see(other);
          });
      const bool is_wide = widestGap(directions) > options_.angle;
      if (is_wide ? count >= options_.neighbours && !directions.empty()
                  : count <= options_.neighbours)
        return is_wide;
    }
    const std::vector<std::size_t> nearest = nearestTo(i, options_.neighbours);
    directions.clear();
    std::for_each(nearest.begin(), nearest.end(), see);
    return widestGap(directions) > options_.angle && nearest.size() >= 3 &&
           !directions.empty();
  }

private:
  std::vector<std::size_t> nearestTo(std::size_t i, unsigned number) const
  {
    pcl::Indices nearest;
    std::vector<float> squares;
    tree_.nearestKSearch(places_[i], static_cast<int>(number), nearest, squares);
    return {nearest.begin(), nearest.end()};
  }

  /** @brief Returns the median distance from some places to the last of their nearest
   * few, metres. */
  double usualReach() const
  {
    constexpr unsigned few = 24; // have directions all around an inner point
    constexpr std::size_t samples = 16;
    std::vector<double> reaches;
    for (std::size_t i = 0; i < places_.size(); i += places_.size() / samples + 1) {
      double reach = 0;
      for (const std::size_t k : nearestTo(i, std::min(few, options_.neighbours)))
        reach = std::max<double>(
            reach, (places_[k].getVector3fMap() - places_[i].getVector3fMap()).norm());
      reaches.push_back(reach);
    }
    return middleValue(std::move(reaches));
  }

  const pcl::PointCloud<pcl::PointXYZ>& places_;
  const BoundaryOptions& options_;
  pcl::search::KdTree<pcl::PointXYZ> tree_;
  double usual_ = 0;
  std::unique_ptr<PlanPoints> in_plan_;
};

} // namespace

std::string
problemOf(const BoundaryOptions& options)
{
  if (options.neighbours < 3)
    return "the number of neighbors must be at least 3, it is " +
           std::to_string(options.neighbours);
  if (!(options.angle > 0 && options.angle < full_turn))
    return "the angle threshold must be above 0 and below 2 pi radians, it is " +
           numberText(options.angle);
  return {};
}

pcl::Indices
finiteIndices(const PointView& points, const pcl::Indices& indices)
{
  pcl::Indices finite;
  finite.reserve(indices.size());
  for (const auto i : indices)
    if (points.isFinite(static_cast<std::size_t>(i)))
      finite.push_back(i);
  if (!std::is_sorted(finite.begin(), finite.end()))
    std::sort(finite.begin(), finite.end());
  finite.erase(std::unique(finite.begin(), finite.end()), finite.end());
  return finite;
}

pcl::Indices
boundaryPoints(const PointView& points,
               const pcl::Indices& indices,
               Nearness nearness,
               const BoundaryOptions& options)
{
  const pcl::Indices finite = finiteIndices(points, indices);
  if (finite.empty())
    return {};
  // A cloud of these points only, so that one search tree serves every point type.
  const auto places = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  places->reserve(finite.size());
  for (const auto i : finite) {
    const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
    places->push_back({p.x(), p.y(), nearness == Nearness::Plan ? 0.f : p.z()});
  }
  const BoundaryTest test(places, options);
  std::vector<std::uint8_t> is_boundary(finite.size());
  parallelFor(finite.size(), 1024, options.threads,
              [&](std::size_t i) { is_boundary[i] = test.isBoundary(i); });
  pcl::Indices boundary;
  for (std::size_t i = 0; i < finite.size(); ++i)
    if (is_boundary[i])
      boundary.push_back(finite[i]);
  return boundary;
}

} // namespace pcl::sedr
