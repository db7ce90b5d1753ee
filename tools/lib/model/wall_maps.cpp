// SPDX-License-Identifier: BSD-3-Clause
#include "wall_maps.h"

#include "sedr_segmentation/src/openings/opening_search.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<char, 7> letters{'n', 's', 'w', 't', 'h', 'e', 'e'}; // as WallCell

/** @brief Returns the states in the middle of coarser cells, in runs, row by row from
 * the top. */
std::string
runsOf(const WallMap& map, double cell, std::size_t columns, std::size_t rows)
{
  std::string text;
  std::size_t length = 0;
  char last = 0;
  const auto end = [&] { text += length > 0 ? std::to_string(length) + last : ""; };
  for (std::size_t r = rows; r-- > 0;)
    for (std::size_t c = 0; c < columns; ++c) {
      const WallCell state =
          map.at(cell * (static_cast<double>(c) + 0.5),
                 map.heightOf(0) + cell * (static_cast<double>(r) + 0.5));
      const char letter = letters[static_cast<std::size_t>(state)];
      if (letter != last)
        end();
      length = letter == last ? length + 1 : 1;
      last = letter;
    }
  end();
  return text;
}

} // namespace

Json
wallMaps(const Floorplan& plan,
         const OpeningSearch& search,
         const BuildingFrame& to_maps)
{
  const auto onSide = [&](const WallSide& side, const Eigen::Vector2d& p) {
    return side.line.project(to_maps.toBuilding({p.x(), p.y(), 0}).head<2>());
  };
  constexpr double finest = 0.1; // metres
  constexpr double most = 5e5;   // cells
  double area = 0;
  for (const WallMap& map : search.maps)
    area += map.cell() * map.cell() * static_cast<double>(map.columns() * map.rows());
  const double cell = std::max(finest, std::sqrt(area / most));
  Json maps = Json::array();
  for (std::size_t k = 0; k < search.maps.size(); ++k) {
    const WallSide& side = search.sides[k];
    const WallMap& map = search.maps[k];
    const double size = std::max(cell, map.cell());
    const auto partsOf = [size](double length) {
      return static_cast<std::size_t>(std::ceil(length / size));
    };
    const std::size_t columns = partsOf(side.line.length());
    const std::size_t rows = partsOf(map.cell() * static_cast<double>(map.rows()));
    std::vector<std::size_t> walls = side.elements;
    for (std::size_t& wall : walls)
      ++wall;
    Json openings = Json::array(); // framed on this side or on the other one
    for (const PlanOpening& opening : plan.openings)
      for (const OpeningWall& in : opening.walls)
        if (in.room == plan.rooms[side.room].id &&
            std::count(side.elements.begin(), side.elements.end(), in.element) > 0) {
          const auto [from, to] =
              std::minmax({onSide(side, opening.start), onSide(side, opening.end)});
          openings.push_back({{"kind", nameOf(opening.kind)},
                              {"from", from},
                              {"to", to},
                              {"bottom", opening.bottom},
                              {"top", opening.top}});
        }
    maps.push_back({{"room", plan.rooms[side.room].id},
                    {"walls", walls},
                    {"length", side.line.length()},
                    {"base", map.heightOf(0) + to_maps.origin.z()},
                    {"cell", size},
                    {"columns", columns},
                    {"rows", rows},
                    {"cells", runsOf(map, size, columns, rows)},
                    {"openings", openings}});
  }
  return maps;
}

} // namespace pcl::sedr::tools
