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

/** @brief Tells boundary points from inner ones by all their neighbours. */
class BoundaryTest {
public:
  BoundaryTest(const PointView& points,
               const NeighbourSearch& search,
               const BoundaryOptions& options)
      : points_(points)
      , search_(search)
      , options_(options)
  {}

  bool operator()(pcl::index_t index)
  {
    search_(index, options_.neighbours, neighbours_);
    return widestGap(points_, index, neighbours_, directions_) > options_.angle &&
           neighbours_.size() >= 3 && !directions_.empty();
  }

private:
  const PointView& points_;
  const NeighbourSearch& search_;
  const BoundaryOptions& options_;
  pcl::Indices neighbours_;
  std::vector<float> directions_;
};

/** @brief Returns the median distance from some of the places to the last of their
 * nearest few, metres. */
double
usualReach(const std::vector<Eigen::Vector3f>& places,
           const NeighbourSearch& search,
           unsigned neighbours)
{
  constexpr unsigned few = 24; // have directions all around an inner point
  constexpr std::size_t samples = 16;
  std::vector<double> reaches;
  pcl::Indices nearest;
  for (std::size_t i = 0; i < places.size(); i += places.size() / samples + 1) {
    search(static_cast<pcl::index_t>(i), std::min(few, neighbours), nearest);
    double reach = 0;
    for (const auto k : nearest)
      reach = std::max<double>(
          reach, (places[static_cast<std::size_t>(k)] - places[i]).norm());
    reaches.push_back(reach);
  }
  return middleValue(std::move(reaches));
}

/** @brief Tells boundary points where circles suffice: there is no gap among the
 * nearest where none is among fewer, and a wide one where one is among more.
 * @return 1 boundary, 0 inner, -1 only the nearest themselves tell */
std::vector<int>
boundaryByCircles(const std::vector<Eigen::Vector3f>& places,
                  const NeighbourSearch& search,
                  const BoundaryOptions& options)
{
  const double usual = usualReach(places, search, options.neighbours);
  std::vector<Eigen::Vector2d> plan;
  plan.reserve(places.size());
  for (const auto& p : places)
    plan.emplace_back(p.head<2>().cast<double>());
  const PlanPoints points(plan, std::max(usual, 0.01));
  std::vector<int> is_boundary(places.size(), -1);
  parallelFor(places.size(), 1024, options.threads, [&](std::size_t i) {
    thread_local std::vector<float> directions;
    for (const double reach : {usual, 2.5 * usual, 4.5 * usual}) {
      directions.clear();
      std::size_t count = 0;
      points.forEachIndexWithin(plan[i], reach, [&](std::size_t k) {
        const Eigen::Vector3f way = places[points.given(k)] - places[i];
        if (way.norm() > reach)
          return;
        ++count;
        if (way.x() != 0 || way.y() != 0)
          directions.push_back(std::atan2(way.y(), way.x()));
      });
      const bool is_wide = widestGap(directions) > options.angle;
      if (count <= options.neighbours && !is_wide)
        is_boundary[i] = 0;
      if (count >= options.neighbours && is_wide && !directions.empty())
        is_boundary[i] = 1;
      if (is_boundary[i] >= 0 || count >= options.neighbours)
        return;
    }
  });
  return is_boundary;
}

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

float
widestGap(const PointView& points,
          pcl::index_t index,
          const pcl::Indices& neighbours,
          std::vector<float>& directions)
{
  const Eigen::Vector3f point = points[static_cast<std::size_t>(index)];
  directions.clear();
  for (const auto i : neighbours) {
    const Eigen::Vector3f way = points[static_cast<std::size_t>(i)] - point;
    if (way.x() != 0 || way.y() != 0)
      directions.push_back(std::atan2(way.y(), way.x()));
  }
  return widestGap(directions);
}

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

pcl::Indices
boundaryPoints(const PointView& points,
               const pcl::Indices& indices,
               const NeighbourSearch& search,
               const BoundaryOptions& options)
{
  std::vector<std::uint8_t> is_boundary(indices.size());
  const auto testBlock = [&](std::size_t begin, std::size_t end) {
    BoundaryTest test(points, search, options);
    for (std::size_t i = begin; i < end; ++i)
      is_boundary[i] = test(indices[i]);
  };
  parallelBlocks(indices.size(), 256, options.threads, testBlock);

  pcl::Indices boundary;
  for (std::size_t i = 0; i < indices.size(); ++i)
    if (is_boundary[i])
      boundary.push_back(indices[i]);
  return boundary;
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

  std::vector<Eigen::Vector3f> places;
  places.reserve(finite.size());
  for (const auto i : finite) {
    const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
    places.emplace_back(p.x(), p.y(), nearness == Nearness::Plan ? 0.f : p.z());
  }
  // A cloud of these points only, so that one search tree serves every point type.
  const auto slab = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  slab->reserve(places.size());
  for (const auto& p : places)
    slab->push_back({p.x(), p.y(), p.z()});
  pcl::search::KdTree<pcl::PointXYZ> tree(false);
  tree.setInputCloud(slab);
  const auto search = [&](pcl::index_t index, unsigned int k, pcl::Indices& nearest) {
    thread_local std::vector<float> square_distances;
    tree.nearestKSearch((*slab)[static_cast<std::size_t>(index)], static_cast<int>(k),
                        nearest, square_distances);
  };
  const std::vector<int> by_circles = boundaryByCircles(places, search, options);
  pcl::Indices boundary;
  pcl::Indices others;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (by_circles[i] != 0)
      (by_circles[i] > 0 ? boundary : others).push_back(static_cast<pcl::index_t>(i));
  for (const auto i : boundaryPoints(PointView(*slab), others, search, options))
    boundary.push_back(i);
  std::sort(boundary.begin(), boundary.end());
  for (auto& i : boundary)
    i = finite[static_cast<std::size_t>(i)];
  return boundary;
}

} // namespace pcl::sedr
