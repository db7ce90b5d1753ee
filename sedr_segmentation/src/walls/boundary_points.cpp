// SPDX-License-Identifier: BSD-3-Clause
#include "boundary_points.h"

#include "neighbour_cells.h"

#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/base/parallel.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>

#include <algorithm>
#include <cstdint>
#include <memory>

namespace pcl::sedr {

namespace {

/** Neighbours asked for first: an inner point has directions all around among so few.
 */
constexpr unsigned int first_look = 32;

/** @brief Looks at the nearest few points and, only where they leave a gap, at all.
 * More neighbours never widen a gap, so the answer is that of all. */
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
    if (options_.neighbours > first_look && !hasGap(index, first_look))
      return false;
    return hasGap(index, options_.neighbours) && neighbours_.size() >= 3 &&
           !directions_.empty();
  }

private:
  bool hasGap(pcl::index_t index, unsigned int k)
  {
    search_(index, k, neighbours_);
    return widestGap(points_, index, neighbours_, directions_) > options_.angle;
  }

  const PointView& points_;
  const NeighbourSearch& search_;
  const BoundaryOptions& options_;
  pcl::Indices neighbours_;
  std::vector<float> directions_;
};

/** @brief The points at which the nearest neighbours leave a gap, and those where they
 * may. */
struct RimPoints {
  pcl::Indices boundary;
  pcl::Indices unknown;
};

RimPoints
rimPoints(const std::vector<Eigen::Vector3f>& places, const BoundaryOptions& options)
{
  const NeighbourCells cells(places, options.neighbours, options.angle,
                             options.threads);
  std::vector<Gap> gaps(places.size());
  parallelBlocks(places.size(), 1024, options.threads,
                 [&](std::size_t begin, std::size_t end) {
                   NeighbourCells::Around around;
                   for (std::size_t i = begin; i < end; ++i)
                     gaps[i] = cells.gapAt(places[i], around);
                 });
  RimPoints rim;
  for (std::size_t i = 0; i < gaps.size(); ++i)
    if (gaps[i] != Gap::None)
      (gaps[i] == Gap::Wide ? rim.boundary : rim.unknown)
          .push_back(static_cast<pcl::index_t>(i));
  return rim;
}

/** @brief Those of some points that are boundary, by a search tree. */
pcl::Indices
boundaryByTree(const std::vector<Eigen::Vector3f>& places,
               const pcl::Indices& some,
               const BoundaryOptions& options)
{
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
  return boundaryPoints(PointView(*slab), some, search, options);
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
  const RimPoints rim = rimPoints(places, options);
  pcl::Indices boundary = rim.boundary;
  if (!rim.unknown.empty()) {
    const pcl::Indices others = boundaryByTree(places, rim.unknown, options);
    boundary.insert(boundary.end(), others.begin(), others.end());
    std::sort(boundary.begin(), boundary.end());
  }
  for (auto& i : boundary)
    i = finite[static_cast<std::size_t>(i)];
  return boundary;
}

} // namespace pcl::sedr
