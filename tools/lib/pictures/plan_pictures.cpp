// SPDX-License-Identifier: BSD-3-Clause
#include "counted.h"
#include "stage_pictures.h"

#include "sedr_filters/src/plan/plan_bounds.h"
#include "sedr_surface/src/drawing/text_spot.h"
#include "sedr_surface/src/formats/decimal_text.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace pcl::sedr::tools {
namespace {

Places
placesOf(const PointView& points, const pcl::Indices& indices)
{
  Places places;
  for (const auto i : indices)
    if (points.isFinite(static_cast<std::size_t>(i)))
      places.emplace_back(points[static_cast<std::size_t>(i)].head<2>().cast<double>());
  return places;
}

/** @brief Adds walls, columns and details of all rooms. */
void
addPlan(const Floorplan& plan, double pixels, Panel& panel)
{
  for (const PlanRoom& room : plan.rooms) {
    for (const auto& [details, colour] :
         {std::pair(&room.floor_details, colours::floor),
          std::pair(&room.details, colours::detail)})
      for (const PlanDetail& detail : *details) {
        panel.addLoop(detail.boundary, colour, colour, pixels);
        for (const PlanLoop& hole : detail.holes)
          panel.addLoop(hole, colour, colour, pixels);
      }
    for (const PlanNiche& niche : room.niches)
      panel.addLoop(niche.boundary, colours::wall, colours::wall, pixels);
    for (const PlanLoop& column : room.columns)
      panel.addLoop(column, colours::column, colours::column, pixels);
    panel.addLoop(room.boundary, colours::ink, colours::arc, pixels);
  }
}

/** @brief Returns the extent of all rooms with some space around. */
Box
viewOf(const Floorplan& plan)
{
  Box view;
  for (const PlanRoom& room : plan.rooms)
    view.extend(boundsOf(room.boundary));
  return grown(view, 0.4);
}

pcl::Indices
sorted(pcl::Indices indices)
{
  std::sort(indices.begin(), indices.end());
  return indices;
}

/** @brief Returns the indices of a sorted list that are not in another. */
pcl::Indices
without(const pcl::Indices& a, const pcl::Indices& b)
{
  pcl::Indices rest;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(rest));
  return rest;
}

} // namespace

RoomWalls
roomWallsOf(const pcl::CeilingBoundaryWallGrowing<pcl::PointXYZ>& growing,
            std::uint32_t room)
{
  RoomWalls result;
  result.room = room;
  for (const auto* part :
       {&growing.getBoundaryIndices(), &growing.getScopeBoundaryIndices(),
        &growing.getFloorBoundaryIndices()})
    result.boundary.insert(result.boundary.end(), part->begin(), part->end());
  result.seeds = growing.getSeeds().above;
  result.seeds.insert(result.seeds.end(), growing.getSeeds().below.begin(),
                      growing.getSeeds().below.end());
  result.walls = growing.getWallIndices();
  if (growing.getDetailIndices() && !std::isnan(growing.getSliceHeight()))
    result.details = *growing.getDetailIndices();
  result.candidates = sorted(*growing.getIndices());
  for (const auto& slab : {growing.getCeilingIndices(), growing.getFloorIndices()})
    if (slab)
      result.candidates = without(result.candidates, sorted(*slab));
  return result;
}

Picture
drawWalls(const std::vector<RoomWalls>& rooms, const PointView& points)
{
  Panel seeded("boundary and seeds");
  Panel grown_walls;
  std::array<std::size_t, 2> count{}; // seeds, walls
  Box view;
  for (const auto& room : rooms) {
    const Places boundary = placesOf(points, room.boundary);
    for (const Eigen::Vector2d& place : boundary)
      view.extend(place);
    seeded.addPoints(boundary, colours::removed);
    seeded.addPoints(placesOf(points, room.seeds), colours::ceiling);
    grown_walls.addPoints(placesOf(points, room.candidates), colours::faint);
    count[0] += room.seeds.size();
    count[1] += room.walls.size();
  }
  for (const auto& room : rooms) {
    grown_walls.addPoints(placesOf(points, room.details), colours::detail);
    grown_walls.addPoints(placesOf(points, room.walls), colours::wall);
  }
  grown_walls.title = "all walls: " + counted(count[1], "point");
  Picture picture("Wall growing in " + counted(rooms.size(), "room") + " from " +
                  counted(count[0], "seed"));
  picture.addMaps({seeded, grown_walls}, grown(view, 0.4));
  picture.addLegend("seed: boundary of ceiling, scope or floor", colours::ceiling);
  picture.addLegend("boundary without support: no seed", colours::removed);
  picture.addLegend("wall", colours::wall);
  picture.addLegend("detail", colours::detail);
  picture.addLegend("no wall", colours::faint);
  return picture;
}

Picture
drawPlan(const Floorplan& plan, const std::vector<FittedBoundary>& boundaries)
{
  constexpr Colour unsupported = colours::recovered;
  std::array<Places, 2> samples; // without and with a wall
  for (const FittedBoundary& boundary : boundaries)
    for (const auto& sample : boundary.samples)
      samples[sample.isSupported() ? 1 : 0].push_back(sample.position);
  Panel boundary("boundary: " +
                 counted(samples[0].size() + samples[1].size(), "point"));
  addPlan(plan, 1, boundary);
  boundary.addPoints(samples[0], unsupported);
  boundary.addPoints(samples[1], colours::wall);
  Panel fitted;
  addPlan(plan, 2.5, fitted);
  Places corners;
  std::size_t arcs = 0;
  for (const PlanRoom& room : plan.rooms) {
    for (const PlanElement& element : room.boundary.elements) {
      arcs += element.isArc() ? 1 : 0;
      corners.push_back(element.start);
    }
    fitted.addLabel(textSpotIn(room.boundary, room.columns).place,
                    std::to_string(room.id) + ": " + decimalText(room.area(), 1) +
                        " m²");
  }
  fitted.addPoints(corners, colours::ink, 0.08);
  fitted.title = "fitted: " + counted(corners.size() - arcs, "segment") + " and " +
                 counted(arcs, "arc");
  Picture picture("Floor plan of " + counted(plan.rooms.size(), "room"));
  picture.addMaps({boundary, fitted}, viewOf(plan));
  picture.addLegend("boundary point on a wall", colours::wall);
  picture.addLegend("edge of the ceiling, no wall seen", unsupported);
  picture.addLegend("segment", colours::ink);
  picture.addLegend("arc", colours::arc);
  picture.addLegend("column", colours::column);
  picture.addLegend("detail of the ceiling", colours::detail);
  picture.addLegend("step of the floor", colours::floor);
  return picture;
}

Picture
drawRefinement(const RefinedWalls& walls, const Floorplan& plan)
{
  constexpr double size = 0.03; // metres
  Panel before("found");
  Panel after("refined");
  before.addPoints(walls.removed, colours::removed, size);
  addPlan(plan, 1, after); // shows where no point went
  double way = 0;
  for (const auto label :
       {StructureLabel::Wall, StructureLabel::Column, StructureLabel::Detail}) {
    std::array<Places, 2> places;
    for (const auto& point : walls.moved)
      if (point.label == label) {
        places[0].push_back(point.before);
        places[1].push_back(point.after);
        way += (point.after - point.before).norm();
      }
    before.addPoints(places[0], colourOf(label), size);
    after.addPoints(places[1], colourOf(label), size);
  }
  addPlan(plan, 1, before);
  way /= static_cast<double>(std::max<std::size_t>(1, walls.moved.size()));
  Picture picture("Refinement of " + counted(walls.moved.size(), "wall point") +
                  " by " + decimalText(100 * way, 1) + " cm on average, " +
                  std::to_string(walls.removed.size()) + " left out");
  picture.addMaps({before, after}, viewOf(plan));
  picture.addLegend("wall point, from above", colours::wall);
  picture.addLegend("of a column", colours::column);
  picture.addLegend("of a riser of a detail", colours::detail);
  picture.addLegend("too far from its wall: left out", colours::removed);
  picture.addLegend("plan", colours::ink);
  return picture;
}

Picture
drawRepair(const RepairedSurfaces& surfaces, const Floorplan& plan)
{
  constexpr int steps = 5;
  Panel panel("where vertical surfaces were filled");
  std::size_t cells = 0;
  std::size_t filled = 0;
  for (const RepairedStrip& strip : surfaces.strips) {
    const std::size_t count = strip.columns.size();
    const double width = strip.element.length() / static_cast<double>(count);
    const auto shareOf = [&](const RepairedStrip::Column& column) { // filled, rounded
      const auto first =
          surfaces.is_seen.begin() + static_cast<std::ptrdiff_t>(column.first);
      const auto holes =
          std::count(first, first + static_cast<std::ptrdiff_t>(column.cells), false);
      return std::round(static_cast<double>(steps * holes) /
                        static_cast<double>(std::max<std::size_t>(1, column.cells))) /
             steps;
    };
    for (std::size_t from = 0, to = 0; from < count; from = to) {
      const double share = shareOf(strip.columns[from]);
      Places path{strip.element.pointAt(static_cast<double>(from) * width)};
      while (to < count && shareOf(strip.columns[to]) == share)
        path.push_back(strip.element.pointAt(static_cast<double>(++to) * width));
      panel.addPath(path, mixed(colourOf(strip.label), colours::recovered, share), 4);
    }
    for (const RepairedStrip::Column& column : strip.columns)
      for (std::size_t r = 0; r < column.cells; ++r, ++cells)
        filled += surfaces.is_seen[column.first + r] ? 0 : 1;
  }
  Picture picture("Hole repair: " + std::to_string(filled) + " of " +
                  counted(cells, "cell") + " of vertical surfaces filled");
  picture.addMaps({panel}, viewOf(plan));
  picture.addLegend("wall, seen", colours::wall);
  picture.addLegend("column, seen", colours::column);
  picture.addLegend("riser or niche, seen", colours::detail);
  picture.addLegend("filled", colours::recovered);
  return picture;
}

} // namespace pcl::sedr::tools
