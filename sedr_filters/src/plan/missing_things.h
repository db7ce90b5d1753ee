// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Says that a plan lacks a thing, and which ones it has: "the plan has no
 * opening D9; there are: D1, W1". */
template <typename Thing, typename NameOf>
std::string
lacks(const std::string& wanted, const std::vector<Thing>& things, NameOf name_of)
{
  std::string known;
  for (const Thing& thing : things)
    known += (known.empty() ? "; there are: " : ", ") + name_of(thing);
  return "the plan has no " + wanted + known;
}

inline std::string
lacksRoom(const Floorplan& plan, std::uint32_t id)
{
  return lacks("room " + std::to_string(id), plan.rooms,
               [](const PlanRoom& room) { return std::to_string(room.id); });
}

inline std::string
lacksOpening(const Floorplan& plan, const std::string& number)
{
  return lacks("opening " + number, plan.openings, markOf);
}

inline std::string
lacksStorey(const std::vector<PlanStorey>& storeys, std::uint32_t number)
{
  return lacks("storey " + std::to_string(number), storeys,
               [](const PlanStorey& storey) { return std::to_string(storey.number); });
}

/** @brief Returns the storey with a number, null if there is none. */
inline const PlanStorey*
findStorey(const std::vector<PlanStorey>& storeys, std::uint32_t number)
{
  const auto found = std::find_if(storeys.begin(), storeys.end(),
                                  [&](const auto& s) { return s.number == number; });
  return found == storeys.end() ? nullptr : &*found;
}

} // namespace pcl::sedr
