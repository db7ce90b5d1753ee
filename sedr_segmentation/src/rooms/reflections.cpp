// SPDX-License-Identifier: BSD-3-Clause
#include "reflections.h"

#include "sedr_filters/src/grids/disjoint_sets.h"
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

/** @brief Returns for each part of the air one of those that air leads to from it: the
 * same for all that are connected. */
std::vector<std::uint32_t>
connectedParts(const PartedAir& parted)
{
  DisjointSets<> sets(parted.rooms);
  for (const RoomOpening& opening : parted.openings)
    sets.join(opening.a, opening.b);
  std::vector<std::uint32_t> connected;
  for (std::uint32_t p = 0; p < parted.rooms; ++p)
    connected.push_back(sets.find(p));
  return connected;
}

using Borders = std::map<std::pair<std::size_t, std::size_t>, Places>;

/** @brief Returns the places between parts that are side by side, one behind a wall of
 * the other, and not connected, by the numbers of both. */
Borders
bordersOf(const AirGaps& air, const PartedAir& parted)
{
  const std::vector<std::uint32_t> connected = connectedParts(parted);
  Borders borders;
  for (std::uint32_t g = 0; g < air.size(); ++g)
    for (int k = 0; parted.room[g] != PartedAir::no_room && k < 9; ++k) {
      const Eigen::Vector2d step = beside * Eigen::Vector2d(k % 3 - 1, k / 3 - 1);
      const Eigen::Vector2d between = air.placeOf(g) + step;
      const std::uint32_t column = air.columnAt(between + step);
      if (column == VoxelColumns::none)
        continue;
      for (std::size_t o = air.first(column); o < air.first(column + 1); ++o)
        if (parted.room[o] > parted.room[g] && air[o].low < air[g].high &&
            air[o].high > air[g].low &&
            connected[static_cast<std::size_t>(parted.room[o])] !=
                connected[static_cast<std::size_t>(parted.room[g])])
          borders[{parted.room[g], parted.room[o]}].emplace_back(between.x(),
                                                                 between.y(), 0);
    }
  return borders;
}

/** @brief What was seen of parts of the air, but their floors and ceilings. */
struct SeenParts {
  std::vector<SeenPart> parts;              ///< empty for those with no border
  CubeTable cubes = CubeTable(mirror_cube); ///< of these and what else was seen
};

/** @brief Returns what was seen of the parts with borders: of points in their columns
 * or beside them one a cube. */
SeenParts
partsSeen(const AirGaps& air,
          const PartedAir& parted,
          const PointView& points,
          const std::vector<double>& floors,
          const Borders& borders)
{
  SeenParts seen;
  seen.parts.resize(parted.rooms);
  std::vector<std::uint8_t> has_border(parted.rooms, 0);
  for (const auto& border : borders)
    has_border[border.first.first] = has_border[border.first.second] = 1;
  const VoxelColumns& columns = air.columns();
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
    const std::size_t known = seen.cubes.size();
    if (!points.isFinite(i) || !columns.grid().holds(points[i].x(), points[i].y()) ||
        isOfSlab(p) || seen.cubes.add(seen.cubes.at(p)) < known)
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
        Places& of_part = seen.parts[part].places;
        if (has_border[part] != 0 && p.z() > floors[part] + beside &&
            p.z() < columns.heightOf(air[g].high) - beside &&
            (of_part.empty() || of_part.back() != p))
          seen.parts[part].add(p);
      }
    }
  }
  return seen;
}

} // namespace

std::vector<std::uint8_t>
mirroredParts(const AirGaps& air,
              const PartedAir& parted,
              const PointView& points,
              const std::vector<double>& floors)
{
  std::vector<std::uint8_t> is_mirrored(parted.rooms, 0);
  const Borders borders = bordersOf(air, parted);
  if (borders.empty())
    return is_mirrored;
  const SeenParts seen = partsSeen(air, parted, points, floors, borders);
  for (const auto& [parts, border] : borders) {
    const auto [behind, before] =
        std::minmax(parts.first, parts.second, [&](std::size_t a, std::size_t b) {
          return seen.parts[a].places.size() < seen.parts[b].places.size();
        });
    if (is_mirrored[behind] == 0 && is_mirrored[before] == 0 &&
        isReflection(border, seen.parts[before], seen.parts[behind], seen.cubes,
                     points))
      is_mirrored[behind] = 1;
  }
  return is_mirrored;
}

} // namespace pcl::sedr
