// SPDX-License-Identifier: BSD-3-Clause
#include "room_picture.h"

#include "map_cells.h"
#include "scale.h"

namespace pcl {
namespace sedr {
namespace tools {

Picture
drawRooms(const std::vector<RoomRegion>& rooms,
          const CellSet& ceilings,
          double cell_size)
{
  Panel before("ceilings");
  Panel after("rooms");
  before.addCells(ceilings, cell_size, colours::ceiling);
  CellSet scopes;
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    after.addCells(rooms[r].scope, cell_size, colourNumber(r));
    addTo(scopes, rooms[r].scope);
    if (rooms[r].scope.empty())
      continue;
    const double area =
        static_cast<double>(rooms[r].scope.size()) * cell_size * cell_size;
    after.addLabel(labelPlace(rooms[r].scope, cell_size),
                   std::to_string(r + 1) + ": " + fixedText(area, 1) + " m2");
  }
  const CellSet without = subtract(ceilings, scopes);
  after.addCells(without, cell_size, colours::removed);
  CellSet all = ceilings;
  addTo(all, scopes);
  for (Panel* panel : {&before, &after})
    panel->setView(viewOf(all, cell_size));
  Picture picture("Rooms: " + std::to_string(rooms.size()) + ", and " +
                  counted(without.size(), "cell") + " of ceilings in none");
  picture.addMaps({before, after});
  picture.addLegend("ceiling", colours::ceiling);
  picture.addLegend("in no room: no walls around, no floor below or too small",
                    colours::removed);
  return picture;
}

} // namespace tools
} // namespace sedr
} // namespace pcl
