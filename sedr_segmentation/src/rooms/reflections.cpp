// SPDX-License-Identifier: BSD-3-Clause
#include "reflections.h"

#include "sedr_filters/src/rays/mirror_likeness.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace pcl::sedr {

namespace {

constexpr double beside = 0.15; // metres, of the air that a surface bounds

/** @brief How much of each part of the air is of some kind. */
class Shares {
public:
  Shares(const PartedAir& parted)
      : some_(parted.rooms, 0)
      , all_(parted.rooms, 0)
  {}

  void add(std::int32_t part, bool is_some)
  {
    if (part == PartedAir::no_room)
      return;
    ++all_[static_cast<std::size_t>(part)];
    some_[static_cast<std::size_t>(part)] += is_some ? 1 : 0;
  }

  /** @brief Returns 1 for each part of which a share is more than `most`. */
  std::vector<std::uint8_t> above(double most) const
  {
    std::vector<std::uint8_t> is_above(all_.size());
    for (std::size_t p = 0; p < all_.size(); ++p)
      is_above[p] = static_cast<double>(some_[p]) > most * static_cast<double>(all_[p]);
    return is_above;
  }

private:
  std::vector<std::size_t> some_;
  std::vector<std::size_t> all_;
};

/** @brief Calls `visit(g, point, index)` for each gap of the column of each point. */
template <typename Visitor>
void
forEachGap(const AirGaps& air, const PointView& points, Visitor visit)
{
  const VoxelColumns& columns = air.columns();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f p = points[i];
    if (!p.allFinite() || !columns.grid().holds(p.x(), p.y()))
      continue;
    const std::uint32_t column = columns.columnAt(columns.grid().at(p.x(), p.y()));
    if (column == VoxelColumns::none)
      continue;
    for (std::size_t g = air.first(column); g < air.first(column + 1); ++g)
      visit(g, p, i);
  }
}

/** @brief Mean height of some points, NaN of none. */
struct MeanHeight {
  double sum = 0;
  double count = 0;

  void add(double height)
  {
    sum += height;
    ++count;
  }
  double mean() const { return sum / count; }
};

} // namespace

std::vector<std::uint8_t>
mirrorImages(const AirGaps& air,
             const PartedAir& parted,
             const PointView& points,
             const std::vector<double>& floors)
{
  constexpr double thinnest = 0.08; // metres, of slabs; a floor has no thickness
  constexpr double most = 0.8;      // of its columns
  const VoxelColumns& columns = air.columns();
  std::vector<MeanHeight> lows(air.size());
  std::vector<MeanHeight> highs(air.size());
  std::vector<MeanHeight> main_floors(floors.size());
  forEachGap(air, points, [&](std::size_t g, const Eigen::Vector3f& p, std::size_t) {
    const std::int32_t voxel = columns.voxelAt(p.z());
    if (voxel == air[g].high)
      highs[g].add(p.z());
    if (voxel + 1 != air[g].low)
      return;
    lows[g].add(p.z());
    const std::int32_t part = parted.room[g];
    if (part != PartedAir::no_room &&
        std::abs(columns.heightOf(air[g].low) -
                 floors[static_cast<std::size_t>(part)]) <= columns.voxelHeight())
      main_floors[static_cast<std::size_t>(part)].add(p.z());
  });
  Shares shares(parted);
  for (std::size_t g = 0; g < air.size(); ++g) {
    const std::size_t above = g + 1;
    const auto isMirrored = [&] {
      const double plane = (highs[g].mean() + lows[above].mean()) / 2;
      const double floor =
          main_floors[static_cast<std::size_t>(parted.room[above])].mean();
      return std::abs(floor - plane) <= thinnest / 4 &&
             std::abs(air.height(above) - air.height(g)) <= beside;
    };
    shares.add(parted.room[g],
               above < air.size() && air[above].column == air[g].column &&
                   parted.room[above] != PartedAir::no_room &&
                   parted.room[above] != parted.room[g] && isMirrored());
  }
  return shares.above(most);
}

std::vector<std::uint8_t>
viewsThroughPanes(const AirGaps& air,
                  const PartedAir& parted,
                  const PointView& points,
                  const std::vector<std::uint8_t>& behind)
{
  Shares shares(parted);
  const VoxelColumns& columns = air.columns();
  if (!behind.empty())
    forEachGap(
        air, points, [&](std::size_t g, const Eigen::Vector3f& p, std::size_t i) {
          if (i < behind.size() && p.z() > columns.heightOf(air[g].low) - beside &&
              p.z() < columns.heightOf(air[g].high) + beside)
            shares.add(parted.room[g], behind[i] != 0);
        });
  return shares.above(0.9);
}

namespace {

/** @brief Returns what was seen of each part of the air, but its floor and ceiling: of
 * points in its columns or beside them one a cube. */
std::vector<Places>
placesOfParts(const AirGaps& air,
              const PartedAir& parted,
              const PointView& points,
              const std::vector<double>& floors)
{
  std::vector<Places> places(parted.rooms);
  const VoxelColumns& columns = air.columns();
  CubeTable cubes(mirror_cube);
  const auto isOfSlab = [&](const Eigen::Vector3d& p) {
    const std::uint32_t column = air.columnAt(p.head<2>());
    for (std::size_t g = column == VoxelColumns::none ? air.size() : air.first(column);
         g < air.size() && air[g].column == column; ++g)
      if (parted.room[g] != PartedAir::no_room &&
          (std::abs(p.z() - columns.heightOf(air[g].high)) <= beside ||
           std::abs(p.z() - floors[static_cast<std::size_t>(parted.room[g])]) <=
               beside))
        return true;
    return false;
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d p = points[i].cast<double>();
    const std::size_t known = cubes.size();
    if (!points.isFinite(i) || !columns.grid().holds(points[i].x(), points[i].y()) ||
        isOfSlab(p) || cubes.add(cubes.at(p)) < known)
      continue;
    for (int k = 0; k < 9; ++k) {
      const std::uint32_t column =
          air.columnAt(p.head<2>() + beside * Eigen::Vector2d(k % 3 - 1, k / 3 - 1));
      if (column == VoxelColumns::none)
        continue;
      for (std::size_t g = air.first(column); g < air.first(column + 1); ++g) {
        if (parted.room[g] == PartedAir::no_room)
          continue;
        const auto part = static_cast<std::size_t>(parted.room[g]);
        Places& of_part = places[part];
        if (p.z() > floors[part] + beside &&
            p.z() < columns.heightOf(air[g].high) - beside &&
            (of_part.empty() || of_part.back() != p))
          of_part.push_back(p);
      }
    }
  }
  return places;
}

/** @brief Returns the places between parts that are side by side, one behind a wall of
 * the other, by the numbers of both. */
std::map<std::pair<std::size_t, std::size_t>, Places>
bordersOf(const AirGaps& air, const PartedAir& parted)
{
  std::map<std::pair<std::size_t, std::size_t>, Places> borders;
  for (std::uint32_t g = 0; g < air.size(); ++g)
    for (int k = 0; parted.room[g] != PartedAir::no_room && k < 9; ++k) {
      const Eigen::Vector2d step = beside * Eigen::Vector2d(k % 3 - 1, k / 3 - 1);
      const Eigen::Vector2d between = air.placeOf(g) + step;
      const std::uint32_t column = air.columnAt(between + step);
      if (column == VoxelColumns::none)
        continue;
      for (std::size_t o = air.first(column); o < air.first(column + 1); ++o)
        if (parted.room[o] > parted.room[g] && air[o].low < air[g].high &&
            air[o].high > air[g].low)
          borders[{parted.room[g], parted.room[o]}].emplace_back(between.x(),
                                                                 between.y(), 0);
    }
  return borders;
}

} // namespace

std::vector<std::uint8_t>
mirroredParts(const AirGaps& air,
              const PartedAir& parted,
              const PointView& points,
              const std::vector<double>& floors)
{
  constexpr double least = 0.7; // of mirrors 0.9 and more, of rooms built alike to 0.4
  std::vector<std::uint8_t> is_mirrored(parted.rooms, 0);
  const std::vector<Places> places = placesOfParts(air, parted, points, floors);
  for (const auto& [parts, border] : bordersOf(air, parted)) {
    const auto isBetween = [a = parts.first, b = parts.second](const RoomOpening& at) {
      return at.a == a && at.b == b;
    };
    if (std::any_of(parted.openings.begin(), parted.openings.end(), isBetween))
      continue; // no mirror is there
    const auto [behind, before] =
        std::minmax(parts.first, parts.second, [&](std::size_t a, std::size_t b) {
          return places[a].size() < places[b].size();
        });
    if (mirroredBehind(border, places[before], places[behind]) >= least)
      is_mirrored[behind] = 1;
  }
  return is_mirrored;
}

} // namespace pcl::sedr
