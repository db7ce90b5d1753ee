// SPDX-License-Identifier: BSD-3-Clause
#include "opening_search.h"

#include <algorithm>

namespace pcl::sedr {
namespace {

/** @brief Returns what the face behind a candidate shows; Hidden: there is none. */
WallCell
behindAt(const OpeningSearch& search,
         const FoundOpening& candidate,
         double along,
         double height)
{
  if (candidate.behind == search.sides.size())
    return WallCell::Hidden;
  const Eigen::Vector2d place = search.sides[candidate.side].line.pointAt(along);
  return search.maps[candidate.behind].at(
      search.sides[candidate.behind].line.project(place), height);
}

} // namespace

void
countCells(const OpeningSearch& search,
           const OpeningSizes& sizes,
           FoundOpening& candidate)
{
  const WallMap& map = search.maps[candidate.side];
  const WallRectangle& at = candidate.rectangle;
  const double step = map.cell();
  const double inset = std::min(
      {sizes.beside, (at.to - at.from) / 4, (at.top - at.bottom) / 4}); // of frames
  double all = 0;
  double inner = 0;
  for (double s = at.from + step / 2; s < at.to; s += step)
    for (double z = at.bottom + step / 2; z < at.top; z += step) {
      const WallCell here = map.at(s, z);
      const WallCell there = behindAt(search, candidate, s, z);
      ++all;
      candidate.closed += here == WallCell::Seen ? 1 : 0;
      candidate.solid += there == WallCell::Seen ? 1 : 0;
      if (s > at.from + inset && s < at.to - inset && z > at.bottom + inset &&
          z < at.top - inset) {
        ++inner;
        candidate.filled += here == WallCell::Within ? 1 : 0;
      }
    }
  candidate.closed /= std::max(1.0, all);
  candidate.solid /= std::max(1.0, all);
  candidate.filled /= std::max(1.0, inner);
}

double
seenAround(const OpeningSearch& search,
           const FoundOpening& candidate,
           const WallRectangle& at,
           const OpeningSizes& sizes)
{
  const WallMap& map = search.maps[candidate.side];
  const double step = map.cell();
  const auto isSeen = [&](double along, double height) {
    return map.at(along, height) == WallCell::Seen ||
           behindAt(search, candidate, along, height) == WallCell::Seen;
  };
  std::size_t seen = 0;
  std::size_t all = 0;
  const auto look = [&](double along, double height, double way, double up) {
    ++all;
    // Points of a corner may lie at a jamb. Above a head the wall may be a narrow bar:
    // looked at from the first cell on.
    for (double d = up > 0 ? step / 2 : sizes.beside; d <= 2 * sizes.beside; d += step)
      if (isSeen(along + d * way, height + d * up)) {
        ++seen;
        return;
      }
  };
  for (double z = at.bottom + step / 2; z < at.top; z += step) {
    look(at.from, z, -1, 0);
    look(at.to, z, 1, 0);
  }
  for (double s = at.from + step / 2; s < at.to; s += step)
    if (map.at(s, at.top + sizes.beside) != WallCell::Beyond) // below the ceiling
      look(s, at.top, 0, 1);
  return all > 0 ? static_cast<double>(seen) / static_cast<double>(all) : 0;
}

} // namespace pcl::sedr
