// SPDX-License-Identifier: BSD-3-Clause
#include "floorplan_format.h"

#include "sedr_filters/src/base/number_text.h"
#include <pcl/sedr_filters/straightening.h>

#include <cmath>

namespace pcl::sedr {

namespace {

constexpr double degrees = 180 / M_PI;

} // namespace

std::string
withTilts(const std::string& json,
          const WallTilts& tilts,
          const std::map<std::uint32_t, double>& volumes)
{
  if (tilts.empty())
    return json;
  auto plan = nlohmann::ordered_json::parse(json);
  plan["version"] = floorplan_facets_version;
  for (auto& room : plan["rooms"]) {
    const auto volume = volumes.find(room["id"].get<std::uint32_t>());
    if (volume != volumes.end())
      room["volume"] = volume->second;
    for (const WallTilt& tilt : tilts)
      if (room["id"] == tilt.room && tilt.wall < room["boundary"].size())
        room["boundary"][tilt.wall]["tilt"] = tilt.tilt * degrees;
  }
  return plan.dump(1) + "\n";
}

WallTilts
tiltsFromJson(const std::string& json, std::string& problem)
{
  constexpr double most = 45;
  problem.clear();
  WallTilts tilts;
  try {
    const auto plan = nlohmann::ordered_json::parse(json);
    for (const auto& room : plan.at("rooms"))
      for (std::size_t wall = 0; wall < room.at("boundary").size(); ++wall) {
        const auto& element = room.at("boundary").at(wall);
        if (!element.contains("tilt"))
          continue;
        const double tilt = element.at("tilt").get<double>();
        if (!(std::abs(tilt) <= most)) {
          problem = "the tilt of a wall lies within " + numberText(most) +
                    " degrees, it is " + numberText(tilt);
          return {};
        }
        if (tilt != 0)
          tilts.push_back({room.at("id").get<std::uint32_t>(), wall, tilt / degrees});
      }
  }
  catch (const std::exception& error) {
    problem = std::string("the tilts of walls cannot be read: ") + error.what();
    return {};
  }
  return tilts;
}

} // namespace pcl::sedr
