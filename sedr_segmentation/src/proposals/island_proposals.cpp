// SPDX-License-Identifier: BSD-3-Clause
#include "island_proposals.h"

#include "../curves/fitted_curve.h"
#include "sedr_filters/src/base/quantiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace pcl::sedr {

namespace {

using Island = std::vector<Eigen::Vector2d>;

/** @brief Returns the islands that may be columns. */
std::vector<Island>
islandsOf(const FacePlaces& places)
{
  constexpr double apart = 0.12; // metres to the next one
  constexpr double widest = 1.6; // metres
  constexpr std::size_t fewest = 8;
  const std::vector<Eigen::Vector2d>& points = places.points.all();
  std::vector<std::uint8_t> is_taken(points.size(), 0);
  std::vector<Island> islands;
  for (std::size_t first = 0; first < points.size(); ++first) {
    if (is_taken[first])
      continue;
    is_taken[first] = 1;
    std::vector<std::size_t> members{first};
    Eigen::AlignedBox2d box;
    for (std::size_t k = 0; k < members.size(); ++k) {
      const Eigen::Vector2d& p = points[members[k]];
      box.extend(p);
      places.points.forEachIndexWithin(p, apart * places.scale, [&](std::size_t i) {
        if (!std::exchange(is_taken[i], 1))
          members.push_back(i);
      });
    }
    if (members.size() < fewest || box.diagonal().norm() > widest * std::sqrt(2.0))
      continue;
    Island island;
    for (const std::size_t i : members)
      island.push_back(points[i]);
    islands.push_back(std::move(island));
  }
  return islands;
}

/** @brief Four lines with two normals, and how far from them places are. */
struct Rectangle {
  Eigen::Vector2d normals[2];
  double low[2];
  double high[2];

  Rectangle(const Island& island, double angle)
      : normals{{std::cos(angle), std::sin(angle)}, {-std::sin(angle), std::cos(angle)}}
  {
    constexpr double outside = 0.04; // share of the places
    for (int k : {0, 1}) {
      std::vector<double> offsets;
      for (const Eigen::Vector2d& p : island)
        offsets.push_back(normals[k].dot(p));
      std::sort(offsets.begin(), offsets.end());
      const auto skip =
          static_cast<std::size_t>(outside * static_cast<double>(offsets.size()));
      low[k] = offsets[skip];
      high[k] = offsets[offsets.size() - 1 - skip];
    }
  }

  /** @brief Returns the nearest side of a place, and how far outside that it is. */
  std::pair<std::size_t, double> nearestSide(const Eigen::Vector2d& p) const
  {
    std::pair<std::size_t, double> best{0, std::numeric_limits<double>::max()};
    for (std::size_t k : {0U, 1U}) {
      const double s = normals[k].dot(p);
      for (const auto& [side, off] :
           {std::make_pair(2 * k, low[k] - s), std::make_pair(2 * k + 1, s - high[k])})
        if (std::abs(off) < std::abs(best.second))
          best = {side, off};
    }
    return best;
  }

  double error(const Island& island) const
  {
    double sum = 0;
    for (const Eigen::Vector2d& p : island)
      sum += std::abs(nearestSide(p).second);
    return sum;
  }
};

/** @brief Appends the sides of the rectangle on which places of an island lie. */
void
appendSides(const Island& island, std::vector<FaceCurve>& found)
{
  constexpr int turns = 90;        // of a quarter turn
  constexpr double thinnest = 0.1; // metres
  constexpr double least = 0.1;    // of the places are on a side that was seen
  const auto rectangleAt = [&](int turn) {
    return Rectangle(island, turn * M_PI / 2 / turns);
  };
  std::pair<double, int> best{std::numeric_limits<double>::max(), 0};
  for (int turn = 0; turn < turns; ++turn)
    best = std::min(best, {rectangleAt(turn).error(island), turn});
  const Rectangle rectangle = rectangleAt(best.second);
  if (std::min(rectangle.high[0] - rectangle.low[0],
               rectangle.high[1] - rectangle.low[1]) < thinnest)
    return;
  std::array<std::vector<double>, 4> offs;
  for (const Eigen::Vector2d& p : island) {
    const auto [side, off] = rectangle.nearestSide(p);
    offs[side].push_back(off);
  }
  const double seen = static_cast<double>(
      std::count_if(offs.begin(), offs.end(), [&](const std::vector<double>& off) {
        return static_cast<double>(off.size()) >
               least * static_cast<double>(island.size());
      }));
  for (std::size_t side = 0; side < 4; ++side) {
    if (offs[side].empty())
      continue;
    const std::size_t k = side / 2;
    const double sign = side % 2 == 0 ? -1 : 1;
    const double offset = (side % 2 == 0 ? rectangle.low : rectangle.high)[k] +
                          sign * middleValue(std::move(offs[side]));
    FaceCurve& line = found.emplace_back();
    line.curve.point = offset * rectangle.normals[k];
    line.curve.direction = rectangle.normals[1 - k];
    line.from = rectangle.low[1 - k];
    line.to = rectangle.high[1 - k];
    line.shared = seen;
  }
}

} // namespace

std::vector<FaceCurve>
proposeIslands(const FacePlaces& places)
{
  std::vector<FaceCurve> found;
  for (const Island& island : islandsOf(places)) {
    appendSides(island, found);
    FaceCurve circle;
    circle.curve = fitCurve(true, island, 2 * places.sigma);
    circle.to = 2 * M_PI * circle.curve.radius;
    if (circle.curve.isCircle())
      found.push_back(circle);
  }
  return found;
}

} // namespace pcl::sedr
