// SPDX-License-Identifier: BSD-3-Clause
#include "unseen_cells.h"

#include "../base/parallel.h"
#include "../base/parallel_for.h"

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief The scanned points of one surface. */
class SeenPoints {
public:
  /** @param begin,end range of the cells of the surface */
  SeenPoints(const std::vector<SurfaceCell>& cells,
             std::size_t begin,
             std::size_t end,
             const std::vector<SurfacePoint>& points)
  {
    for (std::size_t c = begin; c < end; ++c)
      if (cells[c].is_occupied) {
        if (cloud_->empty())
          origin_ = cells[c].centre.position;
        cloud_->push_back(local(points[cells[c].source].position));
      }
    if (!cloud_->empty())
      tree_.setInputCloud(cloud_);
  }

  std::size_t size() const { return cloud_->size(); }

  /** @brief Returns the distance from the k-th of at least two points to its nearest
   * neighbour. */
  float spacingAt(std::size_t k) const
  {
    return std::sqrt(squaredDistance((*cloud_)[k], 2));
  }

  bool isWithin(const Eigen::Vector3d& place, double reach) const
  {
    return !cloud_->empty() && squaredDistance(local(place), 1) <= reach * reach;
  }

private:
  /** @brief Returns local coordinates, which keep their precision as floats. */
  pcl::PointXYZ local(const Eigen::Vector3d& place) const
  {
    const Eigen::Vector3f p = (place - origin_).cast<float>();
    return {p.x(), p.y(), p.z()};
  }

  /** @brief Returns the squared distance of the k-th nearest point. */
  float squaredDistance(const pcl::PointXYZ& place, int k) const
  {
    pcl::Indices indices;
    std::vector<float> squared;
    tree_.nearestKSearch(place, k, indices, squared);
    return squared.back();
  }

  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud_{new pcl::PointCloud<pcl::PointXYZ>};
  pcl::KdTreeFLANN<pcl::PointXYZ> tree_;
};

/** @brief Returns half the diagonal of a square with the scan's spacing, metres; 0
 * without points. */
double
reachOf(std::vector<float> distances)
{
  constexpr double share = 0.95;
  if (distances.empty())
    return 0;
  const auto at =
      distances.begin() +
      static_cast<std::ptrdiff_t>(share * static_cast<double>(distances.size() - 1));
  std::nth_element(distances.begin(), at, distances.end());
  return *at / std::sqrt(2.0);
}

double
share(std::size_t part, std::size_t whole)
{
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

/** @brief Returns the share of wall profiles of which less than a fifth was seen; the
 * fit of the wall lines ignores these, too. */
double
shareOfWalls(const SurfaceCells& cells, const std::vector<std::uint8_t>& is_unseen)
{
  constexpr double min_seen = 0.2;
  std::size_t all = 0;
  std::size_t unseen = 0;
  for (const auto& strip : cells.strips()) {
    if (strip.surface.label != StructureLabel::Wall)
      continue;
    for (std::size_t c = 0; c + 1 < strip.first.size(); ++c) {
      const auto begin = is_unseen.begin();
      const auto first = begin + static_cast<std::ptrdiff_t>(strip.first[c]);
      const auto last = begin + static_cast<std::ptrdiff_t>(strip.first[c + 1]);
      if (first == last)
        continue;
      const auto seen = static_cast<double>(std::count(first, last, 0));
      ++all;
      unseen += seen < min_seen * static_cast<double>(last - first) ? 1 : 0;
    }
  }
  return share(unseen, all);
}

} // namespace

UnseenShares
unseenSharesOf(const SurfaceCells& cells,
               const std::vector<SurfacePoint>& points,
               unsigned threads)
{
  const std::vector<std::size_t>& starts = cells.starts();
  constexpr std::size_t block = 1024; // cells or points
  std::vector<std::unique_ptr<const SeenPoints>> seen(starts.size() - 1);
  parallelBlocks(seen.size(), 1, threads, [&](std::size_t s, std::size_t) {
    seen[s] =
        std::make_unique<SeenPoints>(cells.cells(), starts[s], starts[s + 1], points);
  });
  std::vector<std::pair<std::size_t, std::size_t>> spaced; // surfaces, their points
  for (std::size_t s = 0; s < seen.size(); ++s)
    for (std::size_t k = 0; k < seen[s]->size() && seen[s]->size() > 1; ++k)
      spaced.emplace_back(s, k);
  std::vector<float> distances(spaced.size());
  parallelFor(spaced.size(), block, threads, [&](std::size_t i) {
    distances[i] = seen[spaced[i].first]->spacingAt(spaced[i].second);
  });
  const double reach = reachOf(std::move(distances));
  std::vector<std::uint8_t> is_unseen(cells.cells().size(), 0);
  parallelBlocks(
      is_unseen.size(), block, threads, [&](std::size_t begin, std::size_t end) {
        auto s = static_cast<std::size_t>(
            std::upper_bound(starts.begin(), starts.end(), begin) - starts.begin() - 1);
        for (std::size_t c = begin; c < end; ++c) {
          while (c >= starts[s + 1])
            ++s;
          const SurfaceCell& cell = cells.cells()[c];
          is_unseen[c] =
              !cell.is_occupied && !seen[s]->isWithin(cell.centre.position, reach) ? 1
                                                                                   : 0;
        }
      });
  UnseenShares shares;
  shares.surface =
      share(static_cast<std::size_t>(std::count(is_unseen.begin(), is_unseen.end(), 1)),
            is_unseen.size());
  shares.walls = shareOfWalls(cells, is_unseen);
  return shares;
}

} // namespace pcl::sedr
