// SPDX-License-Identifier: BSD-3-Clause
#include "room_borders.h"

#include "../air/air_measures.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Whether the air of a gap goes all round what begins at a column, that is no
 * longer than `most` columns in x and in y, and half as thick as long at least: a pier
 * between two openings is thinner. */
bool
isFreeStanding(const AirGaps& air, std::uint32_t g, std::uint32_t column, int most)
{
  const Cell first = air.columns().cellOf(column);
  std::vector<std::uint32_t> met = {column};
  Eigen::Matrix2Xd places = Eigen::Vector2d::Zero();
  for (std::size_t k = 0; k < met.size(); ++k)
    for (int d = 0; d < 8; ++d) { // beside it and across its corners
      std::uint32_t next = air.columns().neighbour(met[k], d % 4);
      if (d >= 4 && next != VoxelColumns::none)
        next = air.columns().neighbour(next, (d + 1) % 4);
      if (next == VoxelColumns::none)
        return false;
      if (air.goingOnFrom(air[g], next) != AirGaps::none ||
          std::find(met.begin(), met.end(), next) != met.end())
        continue;
      met.push_back(next);
      const Cell at = air.columns().cellOf(next);
      places.conservativeResize(Eigen::NoChange, places.cols() + 1);
      places.rightCols<1>() << at.x - first.x, at.y - first.y;
      const Eigen::Vector2d extent =
          places.rowwise().maxCoeff() - places.rowwise().minCoeff();
      if (extent.maxCoeff() >= most)
        return false;
    }
  places.colwise() -= places.rowwise().mean().eval();
  const Eigen::Vector2d squares =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(places * places.transpose())
          .eigenvalues();
  return 4 * squares[0] >= squares[1];
}

/** @brief The gap behind the wall at which another ends, `none` if there is none within
 * `reach` columns, or no wall as seen from either of the two: where air ends at stairs,
 * at furniture or at the edge of a gallery there is none, nor at what stands free and
 * is no longer than `thickest` columns, as columns are. */
std::uint32_t
facedFrom(const AirGaps& air, std::uint32_t g, int d, int reach, int thickest)
{
  std::uint32_t column = air[g].column;
  for (int step = 0; step <= reach; ++step) {
    column = air.columns().neighbour(column, d);
    if (column == VoxelColumns::none)
      return AirGaps::none;
    const std::uint32_t o = air.goingOnFrom(air[g], column);
    if (o != AirGaps::none) {
      const bool is_wall =
          step > 0 && (isWallBeside(air, g, d) || isWallBeside(air, o, (d + 2) % 4)) &&
          !isFreeStanding(air, g, air.columns().neighbour(air[g].column, d), thickest);
      return is_wall ? o : AirGaps::none;
    }
  }
  return AirGaps::none;
}

} // namespace

void
RoomBorder::add(const RoomBorder& other)
{
  links += other.links;
  walls += other.walls;
  drops += other.drops;
  dip += other.dip;
  stacked += other.stacked;
  at += other.at;
  clear = std::max(clear, other.clear);
}

RoomBorders::RoomBorders(const AirGaps& air,
                         const std::vector<float>& dip,
                         const PartingParameters& parameters,
                         RoomLabels& labels)
    : parameters_(parameters)
    , labels_(labels)
    , cell_(air.columns().cellSize())
    , rooms_(labels.sizes().size())
{
  measureRooms(air);
  measureBorders(air, dip);
}

RoomOdds
RoomBorders::oddsOfOne(std::uint32_t a, std::uint32_t b) const
{
  const BorderOdds& odds = parameters_.odds;
  const RoomBorder& border = rooms_[a].beside.at(b);
  if (border.links == 0)
    return {};
  const auto leastOf = [&](const auto& measure) {
    return std::min(measure(rooms_[a]), measure(rooms_[b]));
  };
  const double depth = leastOf([](const RoomExtent& r) { return r.depth; });
  const double outline = leastOf([&](const RoomExtent& r) {
    return r.links / (r.links + r.ends + odds.unseen_outline / cell_);
  });
  const double shorter = leastOf([](const RoomExtent& r) { return r.links + r.ends; });
  const double share = border.links / (shorter + odds.unseen_outline / cell_);
  const double unseen = odds.unseen_border / cell_;
  RoomOdds found;
  found.by_border =
      odds.any + odds.dip * std::min(border.dip / border.links, 1.0) +
      odds.open * std::log((border.links + unseen) / (border.walls + unseen)) +
      odds.neck * std::pow(std::min(border.clear / depth, 1.0), 2);
  found.by_all = depth < parameters_.min_way / 2
                     ? std::numeric_limits<double>::infinity()
                     : found.by_border + odds.drop * border.drops / border.links +
                           odds.stacked * border.stacked * cell_ * cell_ +
                           odds.depth * std::log(std::min(depth, 1.0)) +
                           odds.outline * outline * outline +
                           odds.share * std::max(share - 0.2, 0.0);
  return found;
}

void
RoomBorders::join(std::uint32_t a, std::uint32_t b)
{
  labels_.join(a, b);
  RoomExtent& into = rooms_[a];
  const RoomExtent joined = std::exchange(rooms_[b], {});
  into.area += joined.area;
  into.depth = std::max(into.depth, joined.depth);
  into.ends += joined.ends;
  into.links += joined.links - 2 * joined.beside.at(a).links;
  into.beside.erase(b);
  for (const auto& [other, border] : joined.beside) {
    if (other == a)
      continue;
    into.beside[other].add(border);
    rooms_[other].beside[a].add(border);
    rooms_[other].beside.erase(b);
  }
}

void
RoomBorders::measureRooms(const AirGaps& air)
{
  const std::vector<float> free = distanceToRim(air);
  for (std::uint32_t g = 0; g < air.size(); ++g)
    if (labels_.hasRoom(g)) {
      const std::uint32_t r = labels_.roomOf(g);
      rooms_[r].area += cell_ * cell_;
      rooms_[r].depth = std::max<double>(rooms_[r].depth, free[g] * cell_);
      for (std::uint32_t o = air.first(air[g].column); o < g; ++o)
        if (labels_.hasRoom(o) && !labels_.isSameRoom(o, g)) {
          ++rooms_[r].beside[labels_.roomOf(o)].stacked;
          ++rooms_[labels_.roomOf(o)].beside[r].stacked;
        }
    }
}

void
RoomBorders::measureBorders(const AirGaps& air, const std::vector<float>& dip)
{
  const auto reach =
      static_cast<int>(std::lround(2 * parameters_.lintel_reach / cell_));
  const auto thickest =
      static_cast<int>(std::lround(parameters_.thickest_wall / cell_)) + 1;
  const std::vector<float> clear = distanceToLintel(air, dip, parameters_.lintel);
  for (std::uint32_t g = 0; g < air.size(); ++g) {
    if (!labels_.hasRoom(g))
      continue;
    RoomExtent& room = rooms_[labels_.roomOf(g)];
    for (int d = 0; d < 4; ++d) {
      const std::uint32_t o = air.link(g, d);
      const std::uint32_t faced =
          o == AirGaps::none ? facedFrom(air, g, d, reach, thickest) : AirGaps::none;
      if (o == AirGaps::none)
        ++room.ends;
      else if (labels_.hasRoom(o) && !labels_.isSameRoom(o, g)) {
        RoomBorder& border = room.beside[labels_.roomOf(o)];
        ++room.links;
        ++border.links;
        border.drops += air.isDrop(g, d) ? 1 : 0;
        border.dip += std::max(dip[g], dip[o]);
        border.at += air.placeOf(g);
        border.clear =
            std::max<double>(border.clear, std::max(clear[g], clear[o]) * cell_);
      }
      if (faced != AirGaps::none && labels_.hasRoom(faced) &&
          !labels_.isSameRoom(faced, g)) {
        const std::uint32_t other = labels_.roomOf(faced);
        room.beside[other].walls += 0.5; // each is met from both sides
        rooms_[other].beside[labels_.roomOf(g)].walls += 0.5;
      }
    }
  }
}

} // namespace pcl::sedr
