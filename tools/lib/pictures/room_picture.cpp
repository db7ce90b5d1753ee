// SPDX-License-Identifier: BSD-3-Clause
#include "room_picture.h"

#include "map_cells.h"
#include "scale.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace pcl::sedr::tools {

namespace {

/** @brief Returns the cells of a room, all or those not completely seen. */
CellSet
cellsOf(const BuildingRoom& room, bool hidden_only)
{
  std::vector<CellKey> keys;
  for (const RoomColumn& column : room.columns)
    if (!hidden_only || !column.floor_seen || !column.ceiling_seen)
      keys.push_back(keyOf(column.cell));
  return CellSet(std::move(keys));
}

/** @brief Draws the rooms of a storey. */
Panel
roomsOf(const Building& building, const PlanStorey& storey)
{
  Panel panel(storey.name);
  for (const BuildingRoom& room : building.rooms) {
    if (room.storey != storey.number)
      continue;
    const CellSet cells = cellsOf(room, false);
    panel.addCells(cells, building.grid.size(), roomColour(room.id));
    panel.addCells(cellsOf(room, true), building.grid.size(),
                   darkened(roomColour(room.id), 0.25));
    panel.addLabel(labelPlace(cells, building.grid.size()),
                   std::to_string(room.id) + ": " + fixedText(room.area, 1) + " m²");
  }
  return panel;
}

/** @brief Draws a histogram of ceiling heights above the floors of a storey's rooms. */
Panel
heightsOf(const Building& building, const PlanStorey& storey)
{
  Panel panel("height of " + storey.name);
  constexpr double step = 0.1; // metres
  constexpr int shades = 40;
  std::vector<std::vector<CellKey>> keys(shades);
  for (const BuildingRoom& room : building.rooms)
    if (room.storey == storey.number)
      for (const RoomColumn& column : room.columns) {
        const int shade =
            static_cast<int>((column.ceiling - storey.floor - 1.5) / step);
        keys[static_cast<std::size_t>(std::clamp(shade, 0, shades - 1))].push_back(
            keyOf(column.cell));
      }
  for (int shade = 0; shade < shades; ++shade)
    panel.addCells(CellSet(std::move(keys[static_cast<std::size_t>(shade)])),
                   building.grid.size(),
                   lightened(darkened(colours::ceiling, 0.5),
                             shade / static_cast<double>(shades)));
  return panel;
}

} // namespace

Picture
drawRooms(const Building& building)
{
  CellSet all;
  for (const BuildingRoom& room : building.rooms)
    addTo(all, cellsOf(room, false));
  Picture picture("Rooms: " + std::to_string(building.rooms.size()) + " on " +
                  counted(building.storeys.size(), "storey"));
  for (const PlanStorey& storey : building.storeys) {
    Panel rooms = roomsOf(building, storey);
    Panel heights = heightsOf(building, storey);
    for (Panel* panel : {&rooms, &heights})
      panel->setView(viewOf(all, building.grid.size()));
    picture.addMaps({rooms, heights});
  }
  picture.addLegend("ceiling, the lighter the higher above the storey's floor",
                    colours::ceiling);
  return picture;
}

} // namespace pcl::sedr::tools
