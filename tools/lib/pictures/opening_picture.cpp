// SPDX-License-Identifier: BSD-3-Clause
#include "stage_pictures.h"

#include "sedr_segmentation/src/openings/opening_search.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl::sedr::tools {
namespace {

/** In the order of WallCell. */
constexpr std::array<std::pair<const char*, Colour>, 7> states{
    {{"no room", colours::paper},
     {"seen on the wall", colours::other},
     {"within the wall", colours::detail},
     {"rays through", lightened(colours::detail, 0.5)},
     {"hidden", lightened(colours::floor, 0.5)},
     {"nothing", Colour{250, 226, 140}},
     {"nothing, beside something", lightened(Colour{250, 226, 140}, 0.5)}}};

/** @brief Adds the cells of a map, runs of equal ones as a box. */
void
addMap(const WallMap& map, Panel& panel)
{
  std::array<std::vector<Box>, states.size()> boxes;
  for (std::size_t c = 0; c < map.columns(); ++c)
    for (std::size_t r = 0; r < map.rows();) {
      const WallCell cell = map.at(c, r);
      const std::size_t first = r;
      while (r < map.rows() && map.at(c, r) == cell)
        ++r;
      const double x = map.cell() * static_cast<double>(c);
      boxes[static_cast<std::size_t>(cell)].emplace_back(
          Eigen::Vector2d(x, map.heightOf(first)),
          Eigen::Vector2d(x + map.cell(), map.heightOf(r)));
    }
  for (std::size_t k = 1; k < states.size(); ++k)
    panel.addBoxes(std::move(boxes[k]), states[k].second);
}

} // namespace

Picture
drawOpenings(const Floorplan& plan, const OpeningSearch& search)
{
  constexpr std::size_t max_maps = 24;
  std::vector<std::size_t> sides;
  for (const FoundOpening& found : search.found)
    sides.push_back(found.side);
  std::sort(sides.begin(), sides.end());
  sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
  std::stable_sort(sides.begin(), sides.end(), [&](std::size_t a, std::size_t b) {
    return search.sides[a].line.length() > search.sides[b].line.length();
  });
  const std::size_t shown = std::min(sides.size(), max_maps);
  Picture picture(
      counted(search.found.size(), "opening") +
      (shown < sides.size()
           ? ", without those of " + counted(sides.size() - shown, "shorter wall")
           : ""));
  std::vector<Panel> maps;
  for (std::size_t k = 0; k < shown; ++k) {
    const std::size_t side = sides[k];
    Panel panel("a wall of room " +
                std::to_string(plan.rooms[search.sides[side].room].id));
    addMap(search.maps[side], panel);
    for (const FoundOpening& found : search.found)
      if (const WallRectangle& at = found.rectangle; found.side == side) {
        constexpr int chords = 12; // of an arched head
        std::vector<Eigen::Vector2d> outline{{at.from, at.bottom}, {at.to, at.bottom}};
        for (int chord = 0; chord <= chords; ++chord) {
          const double x = 1 - 2.0 * chord / chords;
          outline.emplace_back((at.from + at.to + x * (at.to - at.from)) / 2,
                               at.top - at.rise * (1 - std::sqrt(1 - x * x)));
        }
        outline.push_back(outline.front());
        panel.addPath(outline, colours::ink, 1.5);
        panel.addLabel({(at.from + at.to) / 2, (at.bottom + at.top) / 2},
                       nameOf(found.opening.kind));
      }
    maps.push_back(std::move(panel));
  }
  picture.addMaps(std::move(maps));
  for (std::size_t k = 1; k < states.size(); ++k)
    picture.addLegend(states[k].first, states[k].second);
  return picture;
}

} // namespace pcl::sedr::tools
