// SPDX-License-Identifier: BSD-3-Clause
#include "boundary_points.h"

#include "../curves/plan_points.h"
#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/base/quantiles.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>

#include <algorithm>
#include <cstdint>
#include <memory>

namespace pcl::sedr {

namespace {

/** @brief Directions around a place. Sectors tell of most gaps between them whether
 * they are wide, so only few directions are sorted. */
class Directions {
public:
  void clear()
  {
    ways_.clear();
    taken_ = 0;
  }

  bool empty() const { return ways_.empty(); }

  void add(const Eigen::Vector2f& way)
  {
    ways_.push_back(way);
    const float part = way.y() / (std::abs(way.x()) + std::abs(way.y()));
    const float turn = way.x() < 0 ? 3 - part : 1 + part; // of 4, from -y
    taken_ |= std::uint64_t(1) << (static_cast<unsigned>(turn * sectors / 4) % sectors);
  }

  /** @brief Tells whether a gap between successive directions is wider than an angle,
   * radians: it is pi on a straight rim, 3/2 pi on a protruding corner, 2 pi where
   * there is no direction at all. */
  bool haveGap(float angle) const
  {
    if (ways_.empty())
      return full_turn > angle;
    static const std::vector<float> bounds = boundsOfSectors();
    float surely = 0;
    float perhaps = 0;
    const unsigned first = nextFrom(0);
    for (unsigned i = first, k; i < first + sectors; i = k) {
      k = nextFrom(i + 1);
      surely = std::max(surely, bounds[k] - bounds[i + 1]);
      perhaps = std::max(perhaps, bounds[k + 1] - bounds[i]);
    }
    return surely > angle || (perhaps > angle && widestGap() > angle);
  }

private:
  static constexpr unsigned sectors = 64; // bits

  /** @brief Returns the angles at which the sectors of two turns begin. */
  static std::vector<float> boundsOfSectors()
  {
    std::vector<float> bounds;
    for (unsigned i = 0; i <= 2 * sectors; ++i) {
      const float turn = 4.f * static_cast<float>(i % sectors) / sectors;
      const float part = turn < 2 ? turn - 1 : 3 - turn;
      const float angle = std::atan2(part, 1 - std::abs(part));
      bounds.push_back((turn < 2 ? angle : full_turn / 2 - angle) +
                       full_turn * static_cast<float>(i / sectors));
    }
    return bounds;
  }

  /** @brief Returns the first taken sector from one on, counted on over full turns. */
  unsigned nextFrom(unsigned i) const
  {
    while (!(taken_ >> (i % sectors) & 1))
      ++i;
    return i;
  }

  float widestGap() const
  {
    std::vector<float> angles;
    for (const Eigen::Vector2f& way : ways_)
      angles.push_back(std::atan2(way.y(), way.x()));
    std::sort(angles.begin(), angles.end());
    float widest = full_turn - angles.back() + angles.front();
    for (std::size_t i = 1; i < angles.size(); ++i)
      widest = std::max(widest, angles[i] - angles[i - 1]);
    return widest;
  }

  std::vector<Eigen::Vector2f> ways_;
  std::uint64_t taken_ = 0;
};

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
    thread_local Directions directions;
    const Eigen::Vector3f place = places_[i].getVector3fMap();
    const auto see = [&](std::size_t k) {
      const Eigen::Vector3f way = places_[k].getVector3fMap() - place;
      if (way.x() != 0 || way.y() != 0)
        directions.add(way.head<2>());
    };
    std::size_t count = 0;
    for (double reach = usual_; count < options_.neighbors && reach < 5 * usual_;
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
      const bool is_wide = directions.haveGap(static_cast<float>(options_.angle));
      if (is_wide ? count >= options_.neighbors && !directions.empty()
                  : count <= options_.neighbors)
        return is_wide;
    }
    const std::vector<std::size_t> nearest = nearestTo(i, options_.neighbors);
    directions.clear();
    std::for_each(nearest.begin(), nearest.end(), see);
    return directions.haveGap(static_cast<float>(options_.angle)) &&
           nearest.size() >= 3 && !directions.empty();
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
      for (const std::size_t k : nearestTo(i, std::min(few, options_.neighbors)))
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
  if (options.neighbors < 3)
    return "the number of neighbors must be at least 3, it is " +
           std::to_string(options.neighbors);
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
