// SPDX-License-Identifier: BSD-3-Clause
#include "wall_picture.h"

#include "map_cells.h"
#include "sedr_segmentation/src/walls/wall_growing.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace pcl::sedr::tools {

namespace {

constexpr double wall_pixels = 2.5;
constexpr double seed_pixels = 3.5;

pcl::Indices
without(const pcl::Indices& a, const pcl::Indices& b)
{
  pcl::Indices rest;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(rest));
  return rest;
}

pcl::Indices
sorted(pcl::Indices indices)
{
  std::sort(indices.begin(), indices.end());
  return indices;
}

/** @brief Returns the walls of a room above or below its slice. */
pcl::Indices
onSide(const RoomWalls& room, const PointView& points, bool is_below)
{
  pcl::Indices walls;
  for (const auto i : room.walls) {
    const bool lies_below =
        room.hasSlice() && points[static_cast<std::size_t>(i)].z() < room.slice_height;
    if (lies_below == is_below)
      walls.push_back(i);
  }
  return walls;
}

Panel
sidePanel(const std::string& title,
          const std::vector<RoomWalls>& rooms,
          const PointView& points,
          bool is_below)
{
  Panel panel(title);
  for (const auto& room : rooms)
    panel.addPoints(placesOf(points, onSide(room, points, is_below)), colours::wall,
                    wall_pixels);
  for (const auto& room : rooms)
    panel.addPoints(placesOf(points, is_below ? room.below : room.above),
                    is_below ? colours::floor : colours::ceiling, seed_pixels);
  for (const auto& room : rooms)
    if (!is_below)
      panel.addPoints(
          placesOf(points, without(room.boundary, unite(room.above, room.below))),
          colours::removed, seed_pixels);
  return panel;
}

Panel
finalPanel(const std::vector<RoomWalls>& rooms, const PointView& points)
{
  std::size_t walls = 0;
  Panel panel("");
  for (const auto& room : rooms)
    panel.addPoints(
        placesOf(points, without(room.candidates, unite(room.walls, room.details))),
        colours::faint, wall_pixels);
  for (const auto& room : rooms) {
    panel.addPoints(placesOf(points, room.details), colours::detail, wall_pixels);
    panel.addPoints(placesOf(points, room.walls), colours::wall, wall_pixels);
    walls += room.walls.size();
  }
  panel.title = "all walls: " + counted(walls, "point");
  return panel;
}

/** @brief Returns the view of the boundaries of all rooms. */
Box
viewOf(const std::vector<RoomWalls>& rooms, const PointView& points)
{
  constexpr double margin = 0.4;
  Box view;
  for (const auto& room : rooms)
    for (const auto& place : placesOf(points, room.boundary))
      view.extend(place);
  return grown(view, margin);
}

} // namespace

bool
RoomWalls::hasSlice() const
{
  return !std::isnan(slice_height);
}

RoomWalls
roomWallsOf(const pcl::CeilingBoundaryWallGrowing<pcl::PointXYZ>& growing,
            std::uint32_t room)
{
  RoomWalls result;
  result.room = room;
  result.boundary =
      unite(unite(growing.getBoundaryIndices(), growing.getScopeBoundaryIndices()),
            growing.getFloorBoundaryIndices());
  result.above = growing.getSeeds().above;
  result.below = growing.getSeeds().below;
  result.walls = growing.getWallIndices();
  result.slice_height = growing.getSliceHeight();
  if (growing.getDetailIndices() && result.hasSlice())
    result.details = sorted(*growing.getDetailIndices());
  if (growing.getIndices())
    result.candidates = sorted(*growing.getIndices());
  for (const auto& slab : {growing.getCeilingIndices(), growing.getFloorIndices()})
    if (slab)
      result.candidates = without(result.candidates, sorted(*slab));
  return result;
}

Picture
drawWalls(const std::vector<RoomWalls>& rooms, const PointView& points)
{
  const bool has_slice = std::any_of(rooms.begin(), rooms.end(),
                                     [](const auto& room) { return room.hasSlice(); });
  const bool has_rejected = std::any_of(rooms.begin(), rooms.end(), [](const auto& r) {
    return !without(r.boundary, unite(r.above, r.below)).empty();
  });
  std::vector<Panel> maps;
  maps.push_back(sidePanel(has_slice ? "above the slice" : "boundary and walls", rooms,
                           points, false));
  if (has_slice)
    maps.push_back(sidePanel("below the slice", rooms, points, true));
  maps.push_back(finalPanel(rooms, points));
  for (auto& map : maps)
    map.setView(viewOf(rooms, points));
  std::size_t seeds = 0;
  for (const auto& room : rooms)
    seeds += room.above.size() + room.below.size();
  Picture picture("Wall growing in " + counted(rooms.size(), "room") + " from " +
                  counted(seeds, "seed"));
  picture.addMaps(maps);
  picture.addLegend("wall", colours::wall);
  picture.addLegend(has_slice ? "seed: boundary of ceiling and scope"
                              : "seed: boundary of the ceiling",
                    colours::ceiling);
  if (has_slice) {
    picture.addLegend("seed: boundary of the floor", colours::floor);
    picture.addLegend("detail", colours::detail);
  }
  if (has_rejected)
    picture.addLegend("boundary without support: no seed", colours::removed);
  picture.addLegend("no wall", colours::faint);
  return picture;
}

} // namespace pcl::sedr::tools
