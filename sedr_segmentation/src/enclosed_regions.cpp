// SPDX-License-Identifier: BSD-3-Clause
#include "room_enclosure.h"

#include <pcl/sedr_segmentation/cell_count.h>
#include <pcl/sedr_segmentation/enclosed_regions.h>

#include <utility>

namespace pcl {
namespace sedr {

namespace {

/** @brief Whether walls close a region of a ceiling all around. */
bool
isEnclosed(const CellSet& region,
           const std::vector<Level>& levels,
           std::size_t ceiling,
           const PointView& points,
           const std::vector<int>& indices,
           const RoomParameters& parameters)
{
  constexpr double closed = 0.8; // of the outline: the rest is the door of a closet
  constexpr double margin = 1;   // metres, of what enclosureOf() looks at
  const CellGrid grid(parameters.cell_size);
  const CellBox box = grown(boxOf(region), cellsFor(margin, parameters.cell_size));
  if (!maskProblem(box).empty())
    return false;
  Piece piece;
  piece.level = ceiling;
  piece.cells = CellMask(region, box);
  piece.size = region.size();
  // Most have no floor, for which no points are needed.
  if (!findFloor({levels, parameters, grid, box, ColumnTable(grid, box, points, {})},
                 piece))
    return false;
  const Storey storey{levels, parameters, grid, box,
                      ColumnTable(grid, box, points, indices)};
  return enclosureOf(storey, solidOf(storey, piece.cells), {&piece}, piece.floor) >=
         closed;
}

} // namespace

CellSet
enclosedRegions(const RegionMap& map,
                const std::vector<Level>& levels,
                std::size_t ceiling,
                const PointView& points,
                const std::vector<int>& indices,
                const RoomParameters& parameters)
{
  const double cell_area = parameters.cell_size * parameters.cell_size;
  const auto mayBeRoom = [&](std::size_t r) {
    return map.number[r] == 0 &&
           static_cast<double>(map.regions.sizes[r]) * cell_area >=
               parameters.minimum_area;
  };
  std::vector<std::size_t> asked;
  for (std::size_t r = 0; r < map.number.size(); ++r)
    if (mayBeRoom(r))
      asked.push_back(r);
  if (asked.empty())
    return {};
  const std::vector<CellSet> regions = map.regionCells();
  std::vector<CellKey> enclosed;
  for (const std::size_t r : asked)
    if (isEnclosed(regions[r], levels, ceiling, points, indices, parameters))
      enclosed.insert(enclosed.end(), regions[r].keys().begin(),
                      regions[r].keys().end());
  return CellSet(std::move(enclosed));
}

} // namespace sedr
} // namespace pcl
