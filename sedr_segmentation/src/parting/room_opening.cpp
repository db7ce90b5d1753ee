// SPDX-License-Identifier: BSD-3-Clause
#include "room_opening.h"

#include "../air/height_counts.h"
#include "sedr_filters/src/base/symmetric_eigen.h"
#include "sedr_filters/src/grids/disjoint_sets.h"
#include "wall_beside.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace pcl::sedr {

std::vector<std::vector<Crossing>>
openingsOf(const AirGaps& air,
           const std::vector<Crossing>& crossings,
           double widest_pier)
{
  const int near =
      1 + std::max(
              1, static_cast<int>(std::lround(widest_pier / air.columns().cellSize())));
  const auto cellOf = [&](std::uint32_t k) {
    return air.columns().cellOf(air[crossings[k].from].column);
  };
  std::unordered_map<CellKey, std::vector<std::uint32_t>> at;
  for (std::uint32_t k = 0; k < crossings.size(); ++k)
    at[keyOf(cellOf(k))].push_back(k);
  DisjointSets<> sets(crossings.size());
  for (std::uint32_t k = 0; k < crossings.size(); ++k) {
    const Cell c = cellOf(k);
    for (int dx = -near; dx <= near; ++dx)
      for (int dy = -near; dy <= near; ++dy)
        if (const auto found = at.find(keyOf({c.x + dx, c.y + dy})); found != at.end())
          for (const std::uint32_t o : found->second)
            sets.join(k, o);
  }
  std::map<std::uint32_t, std::vector<Crossing>> parts;
  for (std::uint32_t k = 0; k < crossings.size(); ++k)
    parts[sets.find(k)].push_back(crossings[k]);
  std::vector<std::vector<Crossing>> openings;
  for (auto& entry : parts)
    openings.push_back(std::move(entry.second));
  return openings;
}

OpeningMeasures::OpeningMeasures(const AirGaps& air,
                                 const std::vector<float>& dip,
                                 const PartingParameters& parameters)
    : air_(air)
    , dip_(dip)
    , parameters_(parameters)
    , cell_(air.columns().cellSize())
{}

MeasuredOpening
OpeningMeasures::measure(const std::vector<Crossing>& crossings,
                         RoomLabels& rooms) const
{
  MeasuredOpening m;
  Eigen::Vector2d through = Eigen::Vector2d::Zero();
  double beside_top = 0;
  for (const Crossing& c : crossings) {
    const double dip = std::max(dip_[c.from], dip_[c.to]);
    const double high =
        air_.columns().heightOf(std::min(air_[c.from].high, air_[c.to].high));
    through += air_.placeOf(c.to) - air_.placeOf(c.from);
    m.middle += (air_.placeOf(c.from) + air_.placeOf(c.to)) / 2;
    m.dip += dip;
    m.bottom += air_.columns().heightOf(std::max(air_[c.from].low, air_[c.to].low));
    m.top += high;
    beside_top += high + dip;
  }
  const auto n = static_cast<double>(crossings.size());
  m.middle /= n;
  m.dip /= n;
  m.bottom /= n;
  m.top /= n;
  m.direction = directionOf(crossings, through);
  const Ends ends = endsOf(crossings, m.direction);
  const Eigen::Vector2d across(-m.direction.y(), m.direction.x());
  m.width = std::max(
      m.direction.dot(air_.placeOf(ends[1].from) - air_.placeOf(ends[0].from)) + cell_,
      n / std::sqrt(2.0) * cell_);
  m.floor_a = floorBeside(crossings, true, rooms);
  m.floor_b = floorBeside(crossings, false, rooms);
  const auto [lower, higher] = std::minmax(m.floor_a, m.floor_b);
  m.open_height = std::clamp(
      (m.top - higher) / std::max(beside_top / n - lower, air_.columns().voxelHeight()),
      0.0, 1.0);
  m.has_ends = endsAtWalls(ends, m.direction);
  if (m.has_ends && m.width <= parameters_.widest_passage) {
    const Eigen::Vector2d into = across.dot(through) < 0 ? -across : across;
    const auto a = besideOf(ends, m.direction, -into, true, rooms);
    const auto b = besideOf(ends, m.direction, into, false, rooms);
    m.jamb_a = std::max(a[0], a[1]);
    m.jamb_b = std::max(b[0], b[1]);
    m.beside = std::max(a[0] + a[1], b[0] + b[1]);
  }
  return m;
}

/** @brief The direction along which most crossings lie; for one or two of them at a
 * right angle to the way through. */
Eigen::Vector2d
OpeningMeasures::directionOf(const std::vector<Crossing>& crossings,
                             const Eigen::Vector2d& through) const
{
  const auto n = static_cast<double>(crossings.size());
  if (n <= 2 && through.norm() > 0)
    return Eigen::Vector2d(-through.y(), through.x()).normalized();
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  for (const Crossing& c : crossings) {
    const Eigen::Vector2d at = (air_.placeOf(c.from) + air_.placeOf(c.to)) / 2;
    mean += at / n;
    squares += at * at.transpose() / n;
  }
  return symmetricEigen(Eigen::Matrix2d(squares - mean * mean.transpose()))
      .vectors.col(1);
}

/** @brief The crossings at the two ends of an opening along its direction. */
OpeningMeasures::Ends
OpeningMeasures::endsOf(const std::vector<Crossing>& crossings,
                        const Eigen::Vector2d& direction) const
{
  const auto [first, last] = std::minmax_element(
      crossings.begin(), crossings.end(), [&](const Crossing& a, const Crossing& b) {
        return direction.dot(air_.placeOf(a.from)) <
               direction.dot(air_.placeOf(b.from));
      });
  return {*first, *last};
}

/** @brief The height of a room's floor near an opening: that which most of it has, not
 * over the edge of a stairwell. */
double
OpeningMeasures::floorBeside(const std::vector<Crossing>& crossings,
                             bool of_first,
                             RoomLabels& rooms) const
{
  std::unordered_set<std::uint32_t> visited;
  std::vector<std::uint32_t> front;
  for (const Crossing& c : crossings)
    if (const std::uint32_t g = of_first ? c.from : c.to; visited.insert(g).second)
      front.push_back(g);
  HeightCounts lows;
  for (int step = 0; step <= parameters_.floor_reach / cell_ && !front.empty();
       ++step) {
    std::vector<std::uint32_t> next;
    for (const std::uint32_t g : front) {
      lows.add(air_.columns().heightOf(air_[g].low));
      for (int d = 0; d < 4; ++d) {
        const std::uint32_t o = air_.next(g, d);
        if (o != AirGaps::none && rooms.isSameRoom(o, g) && visited.insert(o).second)
          next.push_back(o);
      }
    }
    front = std::move(next);
  }
  return lows.highestCount();
}

/** @brief Whether walls stand beyond both ends of an opening, not stairs, drops or what
 * was not seen. */
bool
OpeningMeasures::endsAtWalls(const Ends& ends, const Eigen::Vector2d& direction) const
{
  const int reach = static_cast<int>(std::lround(parameters_.jamb / cell_)) + 2;
  for (std::size_t end = 0; end < 2; ++end) {
    const Eigen::Vector2d outwards = (end == 0 ? -cell_ : cell_) * direction;
    bool is_wall = false;
    for (int step = 0; step <= reach && !is_wall; ++step)
      is_wall =
          isWallAt(air_, air_.columnAt(air_.placeOf(ends[end].from) + step * outwards),
                   air_[ends[end].from]);
    if (!is_wall)
      return false;
  }
  return true;
}

/** @brief How far the room on one side goes on beside each end of an opening, metres:
 * behind the wall in which it is. */
std::array<double, 2>
OpeningMeasures::besideOf(const Ends& ends,
                          const Eigen::Vector2d& direction,
                          const Eigen::Vector2d& into,
                          bool of_first,
                          RoomLabels& rooms) const
{
  const int depth = static_cast<int>(std::ceil(parameters_.thickest_wall / cell_));
  const auto isInWall = [&](const Eigen::Vector2d& place, const AirGap& like) {
    const std::uint32_t g = air_.gapAt(place, like);
    return g != AirGaps::none && dip_[g] >= parameters_.lintel;
  };
  std::array<double, 2> farthest{0, 0};
  for (std::size_t end = 0; end < 2; ++end) {
    const AirGap& like = air_[ends[end].from];
    const std::uint32_t own = of_first ? ends[end].from : ends[end].to;
    const auto isInRoom = [&](const Eigen::Vector2d& place) {
      const std::uint32_t g = air_.gapAt(place, like);
      return g != AirGaps::none && rooms.isSameRoom(g, own);
    };
    for (int away = 1;; ++away) {
      const Eigen::Vector2d outwards = (end == 0 ? -cell_ : cell_) * direction;
      Eigen::Vector2d place = air_.placeOf(ends[end].from) + away * cell_ * into;
      if (away > depth && !isInWall(place - cell_ * into, like))
        break; // no lintel goes on above: a wall thicker than most ends here
      double length = -cell_; // the first step is the end itself
      while (length < parameters_.jamb_reach && isInRoom(place)) {
        length += cell_;
        place += outwards;
      }
      farthest[end] = std::max(farthest[end], length);
    }
  }
  return farthest;
}

bool
isDoor(const MeasuredOpening& opening, const PartingParameters& parameters)
{
  if (!opening.has_ends)
    return false;
  const bool has_lintel = opening.dip >= parameters.lintel;
  const bool is_deep = opening.dip >= parameters.deep_lintel;
  const bool on_one = std::max(opening.jamb_a, opening.jamb_b) >= parameters.jamb;
  const bool on_both = std::min(opening.jamb_a, opening.jamb_b) >= parameters.jamb;
  if (opening.width <= parameters.widest_door)
    return (on_one && has_lintel) ||
           (on_both &&
            opening.width <= parameters.widest_leaf * parameters.widest_door);
  return opening.width <= parameters.widest_passage &&
         ((on_both && has_lintel) || (on_one && is_deep));
}

} // namespace pcl::sedr
