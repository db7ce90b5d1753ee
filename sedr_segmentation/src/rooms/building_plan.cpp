// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_segmentation/building.h>

#include <algorithm>
#include <iterator>

namespace pcl::sedr {

void
giveStoreys(const Building& building, Floorplan& plan)
{
  const auto isKnown = [&](std::uint32_t id) { // 0: a stair's end that nobody saw
    return id == 0 || std::any_of(plan.rooms.begin(), plan.rooms.end(),
                                  [&](const PlanRoom& room) { return room.id == id; });
  };
  const auto isKept = [&](const auto& link) {
    return isKnown(link.rooms[0]) && isKnown(link.rooms[1]) && link.leadsSomewhere();
  };
  plan.storeys = building.storeys;
  plan.storeys = storeysOf(plan); // without the rooms that have no plan
  plan.doorways.clear();
  plan.stairs.clear();
  std::copy_if(building.doorways.begin(), building.doorways.end(),
               std::back_inserter(plan.doorways), isKept);
  std::copy_if(building.stairs.begin(), building.stairs.end(),
               std::back_inserter(plan.stairs), isKept);
}

} // namespace pcl::sedr
