// SPDX-License-Identifier: BSD-3-Clause
#include "stage_pictures.h"
#include "scan_file.h"
#include "sedr_filters/src/base/field_access.h"
#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/plan/plan_geometry.h"
#include "sedr_segmentation/src/openings/opening_search.h"
#include "sedr_surface/src/sheet/text_places.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl::sedr::tools {

namespace {

/** In the order of WallCell. */
constexpr std::array<std::pair<const char*, Colour>, wallCellStates()> states{
    {{"no room", colours::paper},
     {"seen on the wall", colours::other},
     {"within the wall", colours::detail},
     {"rays through", lightened(colours::detail, 0.5)},
     {"hidden", lightened(colours::floor, 0.5)},
     {"a leaf ajar", lightened(colours::wall, 0.5)},
     {"nothing", 0xfae28c},
     {"nothing, beside something", lightened(0xfae28c, 0.5)}}};
static_assert(states.back().first != nullptr);

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

/** @brief Returns the middle of the cell of a room that is nearest to their mean. */
Eigen::Vector2d
middleOf(const BuildingRoom& room, const CellGrid& grid)
{
  Places centres;
  Eigen::Vector2d mean(0, 0);
  for (const RoomColumn& column : room.columns) {
    centres.push_back(grid.centre(column.cell));
    mean += centres.back() / static_cast<double>(room.columns.size());
  }
  return *std::min_element(centres.begin(), centres.end(),
                           [&](const auto& a, const auto& b) {
                             return (a - mean).norm() < (b - mean).norm();
                           });
}

/** @brief Returns a map of a label's cells, coloured by what became of them. */
Panel
changesOf(std::size_t label,
          const CellChanges& changes,
          const LabelCounts& sums,
          const Box& view)
{
  constexpr double shades = 5;
  const auto meaning = static_cast<StructureLabel>(label);
  ColouredCells cells;
  for (const auto& [key, counts] : changes) {
    const auto was = static_cast<double>(counts[0][label]);
    const auto is = static_cast<double>(counts[1][label]);
    const double came = sums[0][label] == 0 ? 0 : std::max(0.0, 1 - was / is);
    cells[is > 0    ? mixed(colourOf(meaning), colours::recovered,
                            std::round(shades * came) / shades)
          : was > 0 ? colours::removed
                    : colours::faint]
        .push_back(key);
  }
  Panel map(std::string(toString(meaning)) + ": " + counted(sums[1][label], "point"),
            view);
  map.addCells(cells, label_cell);
  return map;
}

/** @brief Returns the colour of a ceiling, the lighter the higher it is, in steps. */
Colour
heightColour(double height)
{
  constexpr double step = 0.1; // metres
  constexpr double levels = 40;
  return lightened(darkened(colours::ceiling, 0.5),
                   std::clamp(std::trunc((height - 1.5) / step), 0.0, levels - 1) /
                       levels);
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

void
countLabels(const RowSource& scan, std::size_t when, CellChanges& changes)
{
  const CellGrid grid(label_cell);
  const auto* field = pcl::sedr::findField(scan.fields(), "label");
  RowCoordinates coordinates(scan.fields(), scan.rowSize());
  scan.forEachPiece([&](const RowSource::Piece& piece) {
    const PointView points = coordinates.of(piece.rows, piece.size);
    for (std::size_t i = 0; i < piece.size; ++i) {
      const Eigen::Vector3f p = points[i];
      const double label =
          !field ? 0
                 : readField(piece.rows + i * scan.rowSize() + field->offset,
                             field->datatype);
      if (points.isFinite(i) && grid.holds(p.x(), p.y()))
        ++changes[keyOf(grid.at(p.x(), p.y()))][when]
                 [static_cast<std::size_t>(label >= 0 && label <= 5 ? label : 0)];
    }
    return true;
  });
}

Picture
drawLabels(const CellChanges& changes)
{
  LabelCounts sums{};
  std::array<bool, 6> is_changed{};
  std::vector<CellKey> all;
  std::vector<CellKey> structure;
  for (const auto& [key, counts] : changes) {
    all.push_back(key);
    std::size_t labelled = 0;
    for (std::size_t label = 0; label < 6; ++label) {
      for (const std::size_t when : {0, 1})
        sums[when][label] += counts[when][label];
      is_changed[label] = is_changed[label] || counts[0][label] != counts[1][label];
      labelled += label > 0 ? counts[1][label] : 0;
    }
    if (labelled > 0)
      structure.push_back(key);
  }
  const auto sumOf = [](const std::array<std::size_t, 6>& counts) {
    return counted(std::accumulate(counts.begin(), counts.end(), std::size_t{0}),
                   "point");
  };
  Picture picture{sumOf(sums[0]) + " before, " + sumOf(sums[1]) + " after"};
  const Box view = viewOf(CellSet(structure.empty() ? all : structure), label_cell);
  for (const std::size_t label : {1, 2, 3, 4, 5, 0})
    if (label == 0 ? picture.maps.empty() : is_changed[label]) {
      picture.maps.push_back(changesOf(label, changes, sums, view));
      const auto meaning = static_cast<StructureLabel>(label);
      picture.legend.emplace_back(toString(meaning), colourOf(meaning));
    }
  picture.legend.insert(picture.legend.end(), {{"came", colours::recovered},
                                               {"gone", colours::removed},
                                               {"other points", colours::faint}});
  return picture;
}

Picture
drawRooms(const Building& building)
{
  const double cell_size = building.grid.size();
  Picture picture{"Rooms: " + std::to_string(building.rooms.size()) + " on " +
                  counted(building.storeys.size(), "storey")};
  picture.legend = {
      {"ceiling, the lighter the higher above the storey's floor", colours::ceiling}};
  std::vector<CellKey> all;
  for (const BuildingRoom& room : building.rooms)
    for (const RoomColumn& column : room.columns)
      all.push_back(keyOf(column.cell));
  const Box view = viewOf(CellSet(std::move(all)), cell_size);
  for (const PlanStorey& storey : building.storeys) {
    Panel rooms(storey.name, view);
    ColouredCells areas;
    ColouredCells heights;
    for (const BuildingRoom& room : building.rooms) {
      if (room.storey != storey.number || room.columns.empty())
        continue;
      for (const RoomColumn& column : room.columns) {
        const double dark = column.floor_seen && column.ceiling_seen ? 0 : 0.25;
        areas[darkened(roomColour(room.id), dark)].push_back(keyOf(column.cell));
        heights[heightColour(column.ceiling - storey.floor)].push_back(
            keyOf(column.cell));
      }
      rooms.labels.emplace_back(middleOf(room, building.grid),
                                std::to_string(room.id) + ": " +
                                    decimalText(room.area, 1) + " m²");
    }
    rooms.addCells(areas, cell_size);
    Panel ceilings("height of " + storey.name, view);
    ceilings.addCells(heights, cell_size);
    picture.maps.insert(picture.maps.end(), {rooms, ceilings});
  }
  return picture;
}

void
PictureFile::check() const
{
  if (!path.empty())
    checkOutput(path, "a picture", {".png"});
}

void
StageFiles::declare(Options& options, const std::string& help, std::string* plan)
{
  options.file("INPUT", input, "PCD or PLY file" + help);
  if (plan)
    options.file("PLAN.json", *plan,
                 "floor plan, as pcl_floorplan_fitting and pcl_sedr write it");
  options.file("OUTPUT", output, "PCD or PLY file to write");
  picture.declare(options);
}

void
StageFiles::check() const
{
  checkCloudOutput(output);
  picture.check();
}

void
StageFiles::save(const ToolCloud& cloud, const ScanSettings& reading) const
{
  CellChanges changes;
  if (!picture.path.empty()) // first, as the output may be the input
    countLabels(ScanFile(input, reading), 0, changes);
  saveCloud(output, cloud);
  picture.write([&] {
    countLabels(ScanFile(output), 1, changes);
    return drawLabels(changes);
  });
}

} // namespace pcl::sedr::tools
