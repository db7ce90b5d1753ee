// SPDX-License-Identifier: BSD-3-Clause
#include "storey_rule.h"

#include <algorithm>

namespace pcl::sedr::tools {

StoreyRule::StoreyRule(const Floorplan& plan)
    : storeys_(storeysOf(plan))
    , storey_of_room_(storeyOfRooms(plan))
{}

const PlanStorey*
StoreyRule::find(std::uint32_t number) const
{
  const auto found =
      std::find_if(storeys_.begin(), storeys_.end(),
                   [number](const PlanStorey& s) { return s.number == number; });
  return found == storeys_.end() ? nullptr : &*found;
}

bool
StoreyRule::holds(std::uint32_t number, std::uint32_t room, double z) const
{
  constexpr double beside = 0.15; // metres, for scanned floors and ceilings
  const PlanStorey* storey = find(number);
  if (!storey)
    return true;
  const auto known = storey_of_room_.find(room);
  if (known != storey_of_room_.end())
    return known->second == number;
  return z >= storey->floor - beside && z <= storey->ceiling + beside;
}

} // namespace pcl::sedr::tools
