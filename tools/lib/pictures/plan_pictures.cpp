// SPDX-License-Identifier: BSD-3-Clause
#include "stage_pictures.h"

#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/plan/plan_geometry.h"
#include "sedr_segmentation/src/openings/opening_search.h"
#include "sedr_surface/src/sheet/text_places.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
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
     {"nothing", 0xfae28c},
     {"nothing, beside something", lightened(0xfae28c, 0.5)}}};

/** @brief Returns the map of a side of a wall, x along it and y above its first row. */
Panel
mapOf(const WallMap& map, const std::string& title)
{
  ColouredCells cells;
  for (std::size_t c = 0; c < map.columns(); ++c)
    for (std::size_t r = 0; r < map.rows(); ++r)
      cells[states[static_cast<std::size_t>(map.at(c, r))].second].push_back(
          keyOf({static_cast<std::int32_t>(c), static_cast<std::int32_t>(r)}));
  const Eigen::Vector2d size(map.columns(), map.rows());
  Panel panel(title, Box(Eigen::Vector2d(0, 0), map.cell() * size));
  panel.addCells(cells, map.cell());
  return panel;
}

/** @brief Adds an opening to the map of its wall.
 * @param base z of the map's first row */
void
addOpening(const FoundOpening& found, double base, Panel& panel)
{
  constexpr int chords = 12; // of an arched head
  const WallRectangle& at = found.rectangle;
  const double bottom = at.bottom - base;
  const double top = at.top - base;
  const double middle = (at.from + at.to) / 2;
  Places outline{{at.from, bottom}, {at.to, bottom}};
  for (int chord = 0; chord <= chords; ++chord) {
    const double x = 1 - 2.0 * chord / chords;
    outline.emplace_back(middle + x * (at.to - middle),
                         top - at.rise * (1 - std::sqrt(1 - x * x)));
  }
  panel.addLines({loopOf(outline)}, colours::ink, 1.5);
  panel.labels.emplace_back(Eigen::Vector2d(middle, (bottom + top) / 2),
                            nameOf(found.opening.kind));
}

} // namespace

Picture
drawPlan(const Floorplan& plan, const std::vector<FittedBoundary>& boundaries)
{
  constexpr Colour unsupported = colours::recovered;
  const Box view = viewOf({&plan});
  std::array<Places, 2> samples; // without and with a wall
  for (const FittedBoundary& boundary : boundaries)
    for (const auto& sample : boundary.samples)
      samples[sample.isSupported() ? 1 : 0].push_back(sample.position);
  Panel boundary("boundary: " + counted(samples[0].size() + samples[1].size(), "point"),
                 view);
  boundary.addPlan(plan, 1);
  boundary.addPoints(samples[0], unsupported);
  boundary.addPoints(samples[1], colours::wall);
  Places corners;
  std::size_t arcs = 0;
  for (const PlanRoom& room : plan.rooms)
    for (const PlanElement& element : room.boundary.elements) {
      arcs += element.isArc() ? 1 : 0;
      corners.push_back(element.start);
    }
  Panel fitted("fitted: " + counted(corners.size() - arcs, "segment") + " and " +
                   counted(arcs, "arc"),
               view);
  fitted.addPlan(plan, 2.5);
  fitted.addPoints(corners, colours::ink, 0.08);
  for (const PlanRoom& room : plan.rooms)
    fitted.labels.emplace_back(textSpotIn(room.boundary, room.columns).place,
                               std::to_string(room.id) + ": " +
                                   decimalText(room.area(), 1) + " m²");
  return {"Floor plan of " + counted(plan.rooms.size(), "room"),
          {boundary, fitted},
          {{"boundary point on a wall", colours::wall},
           {"edge of the ceiling, no wall seen", unsupported},
           {"segment", colours::ink},
           {"arc", colours::arc},
           {"column", colours::column},
           {"detail of the ceiling", colours::detail},
           {"step of the floor", colours::floor}}};
}

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
  Picture picture{
      counted(search.found.size(), "opening") +
      (shown < sides.size()
           ? ", without those of " + counted(sides.size() - shown, "shorter wall")
           : "")};
  sides.resize(shown);
  for (const std::size_t side : sides) {
    const WallMap& map = search.maps[side];
    picture.maps.push_back(
        mapOf(map, "a wall of room " +
                       std::to_string(plan.rooms[search.sides[side].room].id)));
    for (const FoundOpening& found : search.found)
      if (found.side == side)
        addOpening(found, map.heightOf(0), picture.maps.back());
  }
  picture.legend.assign(states.begin() + 1, states.end());
  return picture;
}

} // namespace pcl::sedr::tools
