// SPDX-License-Identifier: BSD-3-Clause
#include "wall_maps.h"

#include "sedr_segmentation/src/openings/opening_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<char, 5> letters{'n', 's', 'w', 'h', 'e'}; // as WallCell

/** @brief A map in coarser cells: the most frequent state of each. */
class CoarseMap {
public:
  CoarseMap(const WallMap& map, double cell)
      : map_(map)
      , factor_(static_cast<std::size_t>(std::max(1.0, std::round(cell / map.cell()))))
  {}

  std::size_t columns() const { return (map_.columns() + factor_ - 1) / factor_; }
  std::size_t rows() const { return (map_.rows() + factor_ - 1) / factor_; }

  double cell() const { return map_.cell() * static_cast<double>(factor_); }

  /** @brief Returns the runs of cells, row by row from the top. */
  std::string runs() const
  {
    std::string text;
    std::size_t length = 0;
    char last = 0;
    const auto end = [&] { text += length > 0 ? std::to_string(length) + last : ""; };
    for (std::size_t r = rows(); r-- > 0;)
      for (std::size_t c = 0; c < columns(); ++c) {
        const char letter = letters[stateAt(c, r)];
        if (letter != last)
          end();
        length = letter == last ? length + 1 : 1;
        last = letter;
      }
    end();
    return text;
  }

private:
  std::size_t stateAt(std::size_t column, std::size_t row) const
  {
    std::array<std::size_t, letters.size()> counts{};
    for (std::size_t c = column * factor_;
         c < std::min((column + 1) * factor_, map_.columns()); ++c)
      for (std::size_t r = row * factor_;
           r < std::min((row + 1) * factor_, map_.rows()); ++r)
        ++counts[static_cast<std::size_t>(map_.at(c, r))];
    return static_cast<std::size_t>(std::max_element(counts.begin(), counts.end()) -
                                    counts.begin());
  }

  const WallMap& map_;
  std::size_t factor_;
};

} // namespace

Json
wallMaps(const Floorplan& plan, const OpeningSearch& search)
{
  constexpr double finest = 0.1; // metres
  constexpr double most = 5e5;   // cells
  double area = 0;
  for (const WallMap& map : search.maps)
    area += map.cell() * map.cell() * static_cast<double>(map.columns() * map.rows());
  const double cell = std::max(finest, std::sqrt(area / most));
  Json maps = Json::array();
  for (std::size_t k = 0; k < search.maps.size(); ++k) {
    const WallSide& side = search.sides[k];
    const CoarseMap coarse(search.maps[k], cell);
    std::vector<std::size_t> walls = side.elements;
    for (std::size_t& wall : walls)
      ++wall;
    Json openings = Json::array();
    for (const FoundOpening& found : search.found)
      if (found.side == k)
        openings.push_back({{"kind", nameOf(found.opening.kind)},
                            {"from", found.rectangle.from},
                            {"to", found.rectangle.to},
                            {"bottom", found.rectangle.bottom},
                            {"top", found.rectangle.top}});
    maps.push_back({{"room", plan.rooms[side.room].id},
                    {"walls", walls},
                    {"length", side.line.length()},
                    {"base", search.maps[k].heightOf(0)},
                    {"cell", coarse.cell()},
                    {"columns", coarse.columns()},
                    {"rows", coarse.rows()},
                    {"cells", coarse.runs()},
                    {"openings", openings}});
  }
  return maps;
}

} // namespace pcl::sedr::tools
