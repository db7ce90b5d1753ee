// SPDX-License-Identifier: BSD-3-Clause
#include "storey_levels.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>

namespace pcl::sedr {

std::vector<PlanStorey>
findStoreys(std::vector<BuildingRoom>& rooms, double step)
{
  std::vector<BuildingRoom*> order;
  for (BuildingRoom& room : rooms)
    order.push_back(&room);
  std::stable_sort(
      order.begin(), order.end(),
      [](const BuildingRoom* a, const BuildingRoom* b) { return a->floor < b->floor; });
  std::vector<PlanStorey> storeys;
  std::vector<double> middle; // mean floor of each storey, by area
  std::vector<double> area;
  for (BuildingRoom* room : order) {
    if (storeys.empty() || room->floor >= middle.back() + step) {
      PlanStorey storey;
      storey.number = static_cast<std::uint32_t>(storeys.size() + 1);
      storey.name = storeyName(storey.number);
      storey.floor = room->floor;
      storey.ceiling = room->ceiling;
      storeys.push_back(storey);
      middle.push_back(room->floor);
      area.push_back(0);
    }
    PlanStorey& storey = storeys.back();
    middle.back() = (middle.back() * area.back() + room->floor * room->area) /
                    (area.back() + room->area);
    area.back() += room->area;
    storey.ceiling = std::max(storey.ceiling, room->ceiling);
    storey.rooms.push_back(room->id);
    room->storey = storey.number;
  }
  for (PlanStorey& storey : storeys)
    std::sort(storey.rooms.begin(), storey.rooms.end());
  return storeys;
}

} // namespace pcl::sedr
