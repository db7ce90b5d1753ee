// SPDX-License-Identifier: BSD-3-Clause
#include "floor_picture.h"

#include "map_cells.h"

namespace pcl::sedr::tools {

FloorCells
floorCellsOf(const pcl::FloorProjectionRecovery<pcl::PointXYZ>& recovery)
{
  FloorCells cells;
  cells.cell_size = recovery.getGridSize();
  const CellGrid grid(cells.cell_size);
  const PointView points(*recovery.getInputCloud());
  const pcl::Indices& sources = recovery.getProjectedIndices();
  const auto first_projected =
      sources.end() - static_cast<std::ptrdiff_t>(recovery.getNumberOfProjected());
  cells.seen = CellSet(grid, points, pcl::Indices(sources.begin(), first_projected));
  cells.recovered = CellSet(grid, points, pcl::Indices(first_projected, sources.end()));
  cells.removed = CellSet(grid, points, *recovery.getRemovedIndices());
  return cells;
}

Picture
drawFloor(const std::vector<FloorCells>& rooms)
{
  constexpr std::size_t min_piece = 40; // smaller pieces are scattered outside
  Panel before("floor as detected");
  Panel after("floor completed");
  CellSet all;
  std::size_t recovered = 0;
  std::size_t removed = 0;
  for (const auto& room : rooms) {
    before.addCells(room.recovered, room.cell_size, lightened(colours::other, 0.5));
    before.addCells(room.removed, room.cell_size, colours::removed);
    before.addCells(room.seen, room.cell_size, colours::floor);
    after.addCells(room.seen, room.cell_size, colours::floor);
    after.addCells(room.recovered, room.cell_size, colours::recovered);
    for (const auto* cells : {&room.seen, &room.recovered, &room.removed})
      addTo(all, *cells);
    recovered += room.recovered.size();
    removed += room.removed.size();
  }
  const Box view = viewOf(all, rooms.empty() ? 1 : rooms[0].cell_size, min_piece);
  for (Panel* panel : {&before, &after})
    panel->setView(view);
  Picture picture("Floor recovery: " + counted(recovered, "cell") +
                  " projected from the ceiling, " + counted(removed, "cell") +
                  " removed");
  picture.addMaps({before, after});
  picture.addLegend("seen", colours::floor);
  picture.addLegend("hidden below the ceiling", lightened(colours::other, 0.5));
  picture.addLegend("outside the rooms: removed", colours::removed);
  picture.addLegend("recovered", colours::recovered);
  return picture;
}

} // namespace pcl::sedr::tools
