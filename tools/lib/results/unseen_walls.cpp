// SPDX-License-Identifier: BSD-3-Clause
#include "unseen_walls.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <cmath>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

namespace pcl::sedr::tools {

namespace {

/** @brief What a scan shows of a wall, see wallMaps(). */
struct WallMap {
  double start = 0; ///< of the wall, from that of the map, metres
  double base = 0;
  double cell = 0;
  long columns = 0;
  long rows = 0;
  std::string cells; ///< row by row from the top

  bool isUnseen(double along, double height) const
  {
    const long column = std::lround(std::floor((start + along) / cell));
    const long row = rows - 1 - std::lround(std::floor((height - base) / cell));
    if (column < 0 || column >= columns || row < 0 || row >= rows)
      return false;
    const char state = cells[static_cast<std::size_t>(row * columns + column)];
    return state == 'h' || state == 'e';
  }
};

/** @brief Returns a text whose runs are written as their lengths and letters. */
std::string
withoutRuns(const std::string& runs)
{
  std::istringstream stream(runs);
  std::string text;
  std::size_t length = 0;
  for (char letter = 0; stream >> length >> letter;)
    text.append(length, letter);
  return text;
}

} // namespace

std::function<bool(std::uint32_t, std::size_t, double, double)>
unseenPlaces(const nlohmann::ordered_json& report, const Floorplan& plan)
{
  std::map<std::pair<std::uint32_t, std::size_t>, WallMap> maps;
  for (const auto& told : report.value("walls", nlohmann::ordered_json::array())) {
    WallMap map{0,
                told.value("base", 0.0),
                told.value("cell", 0.0),
                told.value("columns", 0L),
                told.value("rows", 0L),
                withoutRuns(told.value("cells", ""))};
    const PlanRoom* const room = findRoom(plan, told.value("room", 0U));
    if (!room || !(map.cell > 0) ||
        map.cells.size() != static_cast<std::size_t>(map.columns * map.rows))
      continue;
    for (const std::size_t wall : told.value("walls", std::vector<std::size_t>())) {
      if (wall < 1 || wall > room->boundary.elements.size())
        break;
      maps[{room->id, wall - 1}] = map;
      map.start += room->boundary.elements[wall - 1].length();
    }
  }
  if (maps.empty())
    return {};
  return [maps](std::uint32_t room, std::size_t wall, double along, double height) {
    const auto map = maps.find({room, wall});
    return map != maps.end() && map->second.isUnseen(along, height);
  };
}

} // namespace pcl::sedr::tools
