// SPDX-License-Identifier: BSD-3-Clause
#include "border_pieces.h"

#include "../curves/contour.h"

#include <cmath>

namespace pcl::sedr {

std::size_t
PlaceNumbers::numberOf(const Eigen::Vector2d& p)
{
  const auto x = static_cast<std::int64_t>(std::floor(p.x() / size));
  const auto y = static_cast<std::int64_t>(std::floor(p.y() / size));
  for (std::int64_t dy = -1; dy <= 1; ++dy)
    for (std::int64_t dx = -1; dx <= 1; ++dx) {
      const auto [begin, end] = numbers_.equal_range({x + dx, y + dy});
      for (auto found = begin; found != end; ++found)
        if ((places_[found->second] - p).norm() < size)
          return found->second;
    }
  numbers_.emplace(std::make_pair(x, y), places_.size());
  places_.push_back(p);
  return places_.size() - 1;
}

double
areaOf(const std::vector<Piece>& loop, const PlaceNumbers& places)
{
  std::vector<Eigen::Vector2d> corners;
  for (const Piece& piece : loop)
    corners.push_back(places.at(piece.from));
  return signedArea(corners);
}

std::vector<std::vector<Piece>>
loopsOf(const std::vector<Piece>& pieces, const PlaceNumbers& places)
{
  std::multimap<std::size_t, std::size_t> from;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    from.emplace(pieces[i].from, i);
  std::vector<std::uint8_t> is_taken(pieces.size(), 0);
  std::vector<std::vector<Piece>> loops;
  for (std::size_t first = 0; first < pieces.size(); ++first) {
    if (is_taken[first])
      continue;
    std::vector<Piece> loop;
    std::size_t i = first;
    while (!is_taken[i]) {
      is_taken[i] = 1;
      loop.push_back(pieces[i]);
      const Eigen::Vector2d way = places.at(pieces[i].to) - places.at(pieces[i].from);
      double best = -10;
      std::size_t next = i;
      const auto [begin, end] = from.equal_range(pieces[i].to);
      for (auto k = begin; k != end; ++k) {
        if (is_taken[k->second] && k->second != first)
          continue;
        const Piece& piece = pieces[k->second];
        const Eigen::Vector2d on = places.at(piece.to) - places.at(piece.from);
        const double turn =
            std::atan2(way.x() * on.y() - way.y() * on.x(), way.dot(on));
        if (turn > best) {
          best = turn;
          next = k->second;
        }
      }
      if (next == i)
        break;
      i = next;
    }
    if (loop.size() > 2 && loop.back().to == loop.front().from)
      loops.push_back(std::move(loop));
  }
  return loops;
}

} // namespace pcl::sedr
