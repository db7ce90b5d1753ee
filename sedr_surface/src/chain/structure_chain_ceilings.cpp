// SPDX-License-Identifier: BSD-3-Clause
#include "../formats/labels.h"

#include "chain_run.h"

#include "sedr_filters/src/plan/room_lookup.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::sedr {

namespace {

/** @brief Smaller parts of a ceiling cause no warning, square metres. */
constexpr double worth_word = 1;

/** @brief Returns the distance of a height from the range of a room's ceiling heights
 * around a place, metres. On a slope, that range is wide. */
double
distanceFromCeiling(const RoomLookup& room,
                    const Eigen::Vector2d& place,
                    double size,
                    double height)
{
  double low = room.ceilingAt(place);
  double high = low;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0}) {
      const double z = room.ceilingAt(place + size * Eigen::Vector2d(x, y));
      low = std::min(low, z);
      high = std::max(high, z);
    }
  return std::max({0.0, low - height, height - high});
}

} // namespace

CellSet
ChainRun::levelColumns(std::size_t region) const
{
  std::vector<CellKey> keys;
  for (const RoomColumn& column : chain_.getBuilding().rooms[region].columns)
    if (column.is_level)
      keys.push_back(keyOf(column.cell));
  return CellSet(std::move(keys));
}

std::size_t
ChainRun::labelLowerCeilings(std::size_t region)
{
  const PointView points(*chain_.cloud);
  const CellGrid& columns = chain_.getBuilding().grid;
  const CellSet level = levelColumns(region);
  std::size_t found = 0;
  double lowest = std::numeric_limits<double>::infinity();
  for (const int i : regions_[region].ceiling) {
    const auto at = static_cast<std::size_t>(i);
    if (chain_.labels[at] != 0)
      continue;
    chain_.rooms[at] = static_cast<std::uint32_t>(region + 1);
    if (!level.contains(columns.at(points[at].x(), points[at].y()))) {
      chain_.labels[at] = valueOf(StructureLabel::Ceiling); // vault or roof
      continue;
    }
    chain_.labels[at] = valueOf(StructureLabel::Detail);
    ++found;
    lowest = std::min<double>(lowest, points[at].z());
  }
  // Below a soffit, walls grow from the floor's boundary, as below any detail.
  double& slice = slice_height_[region];
  if (found > 0 && !(slice < lowest))
    slice = lowest - chain_.plane_detection.getGridSize();
  return found;
}

ChainRun::PlaceOff
ChainRun::ceilingOff(
    std::size_t region,
    const std::function<double(const Eigen::Vector2d&, double)>& distance) const
{
  constexpr double off = 0.1; // metres from the model
  const Building& building = chain_.getBuilding();
  const CellGrid& columns = building.grid;
  PlaceOff place;
  for (const RoomColumn& column : building.rooms[region].columns) {
    if (column.is_level || !column.ceiling_seen ||
        distance(columns.centre(column.cell), column.ceiling) <= off)
      continue;
    place.area += columns.size() * columns.size();
    place.low = std::min<double>(place.low, column.ceiling);
    place.high = std::max<double>(place.high, column.ceiling);
  }
  return place;
}

pcl::Indices
ChainRun::seenCeiling(std::size_t region) const
{
  pcl::Indices seen;
  for (const int i : regions_[region].ceiling)
    if (static_cast<std::size_t>(i) <
        chain_.scanned_points_) // others fill hidden ceilings
      seen.push_back(i);
  return seen;
}

pcl::IndicesPtr
ChainRun::sheetPoints() const
{
  pcl::IndicesPtr sheets(new pcl::Indices);
  for (std::size_t r = 0; r < regions_.size(); ++r)
    for (const int i : seenCeiling(r))
      if (chain_.rooms[static_cast<std::size_t>(i)] ==
          r + 1) // else floor of the one above
        sheets->push_back(i);
  std::sort(sheets->begin(), sheets->end());
  return sheets;
}

void
ChainRun::warnOfCeilings()
{
  for (const PlanRoom& room : chain_.plan->rooms) {
    const std::size_t region = room.id - 1;
    const bool has_facets = room.hasFacets();
    const RoomLookup lookup(room);
    const PlanSlab& slab = regions_[region].ceiling_slab;
    const PlaceOff off = ceilingOff(region, [&](const Eigen::Vector2d& p, double z) {
      return has_facets
                 ? distanceFromCeiling(lookup, p, chain_.getBuilding().grid.size(), z)
                 : std::abs(z - slab.heightAt(p));
    });
    if (off.area < worth_word)
      continue;
    const double floor = room.floor.heightAt(room.boundary.elements.front().start);
    warn({has_facets ? WarningKind::CeilingOff : WarningKind::CeilingSlopes,
          {off.area, off.low - floor, off.high - floor},
          room.id});
  }
}

} // namespace pcl::sedr
