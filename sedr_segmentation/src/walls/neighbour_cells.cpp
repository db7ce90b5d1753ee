// SPDX-License-Identifier: BSD-3-Clause
#include "neighbour_cells.h"

#include "boundary_points.h"
#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl::sedr {

namespace {

/** @brief How many cells away an inner point is looked for, and any at most. */
constexpr int first_reach = 2;
constexpr int max_reach = 8;

/** @brief More cells than so many a point are no table. */
constexpr std::size_t max_cells_a_point = 8;

/** @brief Where so many times as many points as are asked for lie around one, denser
 * than elsewhere, a search tree finds the nearest sooner. */
constexpr std::size_t max_crowded = 16;

/** @brief Distance that all points within `reach` cells have been seen at, squared. */
float
completeWithin(double cell_size, int reach)
{
  return static_cast<float>(reach * reach * cell_size * cell_size *
                            (1 - 10 * same_place));
}

} // namespace

NeighbourCells::NeighbourCells(const std::vector<Eigen::Vector3f>& places,
                               std::size_t neighbours,
                               float angle,
                               unsigned threads)
    : neighbours_(neighbours)
    , angle_(angle)
    , sectors_(angle)
    , grid_(cellSizeFor(places, threads))
{
  if (places.size() <= neighbours || !(grid_.size() > 0))
    return;
  Eigen::Vector3f low = places.front();
  Eigen::Vector3f high = low;
  for (const auto& p : places) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  if (!grid_.holds(low.x(), low.y()) || !grid_.holds(high.x(), high.y()))
    return;
  const CellBox box =
      grown({grid_.at(low.x(), low.y()), grid_.at(high.x(), high.y())}, max_reach);
  if (box.count() > max_cells_a_point * places.size() || !maskProblem(box).empty())
    return;
  frame_ = CellMask(box);
  first_.assign(frame_.values().size() + 1, 0);
  std::vector<std::uint32_t> cell_of;
  cell_of.reserve(places.size());
  for (const auto& p : places) {
    cell_of.push_back(
        static_cast<std::uint32_t>(frame_.indexOf(grid_.at(p.x(), p.y()))));
    ++first_[cell_of.back() + 1];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  std::vector<std::uint32_t> next = first_;
  places_.resize(places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
    places_[next[cell_of[i]]++] = places[i];
}

/** @brief Cells of which about five by five, at most, hold as many points as there are
 * neighbours, metres: from the distances to the last neighbours of some points. 0 where
 * these are in one place. */
double
NeighbourCells::cellSizeFor(const std::vector<Eigen::Vector3f>& places,
                            unsigned threads) const
{
  constexpr std::size_t samples = 16;
  if (places.size() <= neighbours_)
    return 0;
  const std::size_t step = places.size() / samples + 1;
  std::vector<float> radii((places.size() - 1) / step + 1);
  parallelBlocks(radii.size(), 1, threads, [&](std::size_t sample, std::size_t) {
    std::vector<float> squares;
    squares.reserve(places.size());
    for (const auto& p : places)
      squares.push_back((p - places[sample * step]).squaredNorm());
    const auto last = squares.begin() + static_cast<std::ptrdiff_t>(neighbours_ - 1);
    std::nth_element(squares.begin(), last, squares.end());
    radii[sample] = std::sqrt(*last);
  });
  const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
  std::nth_element(radii.begin(), middle, radii.end());
  // A circle as large as the block, less a fifth of the points.
  return *middle * std::sqrt(0.8 * M_PI) / 5;
}

template <typename See>
void
NeighbourCells::forEachRow(const Eigen::Vector3f& place, int reach, See see) const
{
  const Cell cell = grid_.at(place.x(), place.y());
  for (int k = 0; k <= 2 * reach; ++k) {
    const int dy = k % 2 == 0 ? k / 2 : -(k + 1) / 2;
    const std::size_t from = frame_.indexOf({cell.x - reach, cell.y + dy});
    const std::size_t to = from + static_cast<std::size_t>(2 * reach) + 1;
    see(first_[from], first_[to]);
  }
}

/** @brief Returns whether the points up to `farthest` cells away leave no gap. The
 * nearest cells suffice for most places, so they are looked at first. */
bool
NeighbourCells::isInner(const Eigen::Vector3f& place, int farthest) const
{
  const float within = completeWithin(grid_.size(), farthest);
  std::uint64_t seen = 0;
  for (int reach = 1; reach <= farthest; ++reach) {
    forEachRow(place, reach, [&](std::uint32_t from, std::uint32_t to) {
      for (std::uint32_t k = from; k < to; ++k) {
        const Eigen::Vector3f way = places_[k] - place;
        if (way.x() == 0 && way.y() == 0)
          continue;
        // No branch, as nothing foretells which points lie just too far away.
        const std::uint64_t is_near = way.squaredNorm() <= within ? 1 : 0;
        seen |= DirectionSectors::bitOf(way.x(), way.y()) * is_near;
      }
    });
    if (sectors_.areClose(seen))
      return true;
  }
  return false;
}

std::size_t
NeighbourCells::countAround(const Eigen::Vector3f& place, int reach) const
{
  std::size_t count = 0;
  forEachRow(place, reach,
             [&](std::uint32_t from, std::uint32_t to) { count += to - from; });
  return count;
}

NeighbourCells::Ball
NeighbourCells::ballAround(const Eigen::Vector3f& place,
                           int reach,
                           Around& around) const
{
  const float within = completeWithin(grid_.size(), reach);
  Ball ball;
  around.points.clear();
  forEachRow(place, reach, [&](std::uint32_t from, std::uint32_t to) {
    for (std::uint32_t k = from; k < to; ++k) {
      // Added up as search trees do.
      const Eigen::Vector3f way = places_[k] - place;
      float square = way.x() * way.x();
      square += way.y() * way.y();
      square += way.z() * way.z();
      if (square > within)
        continue;
      ++ball.count;
      around.points.push_back({square, way.x(), way.y()});
      if (way.x() != 0 || way.y() != 0)
        ball.seen |= DirectionSectors::bitOf(way.x(), way.y());
    }
  });
  return ball;
}

Gap
NeighbourCells::gapOfNearest(Around& around) const
{
  auto& points = around.points;
  const auto last = points.begin() + static_cast<std::ptrdiff_t>(neighbours_ - 1);
  std::nth_element(points.begin(), last, points.end(),
                   [](const auto& a, const auto& b) { return a.square < b.square; });
  const float farthest = last->square;
  if (std::any_of(last + 1, points.end(),
                  [&](const Around::Point& p) { return p.square == farthest; }))
    return Gap::Unknown;
  std::uint64_t seen = 0;
  for (auto it = points.begin(); it <= last; ++it)
    if (it->x != 0 || it->y != 0)
      seen |= DirectionSectors::bitOf(it->x, it->y);
  const Gap gap = sectors_.gapOf(seen);
  if (gap != Gap::Unknown || seen == 0)
    return gap;
  around.directions.clear();
  for (auto it = points.begin(); it <= last; ++it)
    if (it->x != 0 || it->y != 0)
      around.directions.push_back(std::atan2(it->y, it->x));
  return widestGap(around.directions) > angle_ ? Gap::Wide : Gap::None;
}

Gap
NeighbourCells::gapAt(const Eigen::Vector3f& place, Around& around) const
{
  if (places_.empty())
    return Gap::Unknown;
  // The largest reach whose points are all among the `neighbours_` nearest ones.
  int near = first_reach;
  while (near > 0 && countAround(place, near) > neighbours_)
    --near;
  if (near > 0 && isInner(place, near))
    return Gap::None;
  for (int reach = first_reach; reach <= max_reach; ++reach) {
    const std::size_t count = countAround(place, reach);
    if (count > max_crowded * neighbours_)
      return Gap::Unknown;
    if (reach > first_reach && count < neighbours_)
      continue; // too few to tell a wide gap
    const Ball ball = ballAround(place, reach, around);
    const Gap gap = sectors_.gapOf(ball.seen);
    if (ball.count <= neighbours_ && gap == Gap::None)
      return Gap::None;
    if (ball.count >= neighbours_)
      return gap == Gap::Wide ? Gap::Wide : gapOfNearest(around);
  }
  return Gap::Unknown;
}

} // namespace pcl::sedr
