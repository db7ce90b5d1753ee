// SPDX-License-Identifier: BSD-3-Clause
#include "counted.h"
#include "stage_pictures.h"

#include "sedr_surface/src/formats/decimal_text.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <unordered_map>

namespace pcl::sedr::tools {
namespace {

constexpr Colour hidden_colour = lightened(colours::other, 0.5);
constexpr Colour ceiling_colour = lightened(colours::ceiling, 0.35);

/** @brief Adds cells, and a text, if any, at the one nearest to their mean. */
void
addNamed(const CellSet& cells,
         double cell_size,
         Colour colour,
         const std::string& name,
         Panel& panel)
{
  panel.addCells(cells, cell_size, colour);
  const CellGrid grid(cell_size);
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < cells.size(); ++i)
    mean += grid.centre(cells[i]) / static_cast<double>(cells.size());
  Eigen::Vector2d nearest = mean;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (i == 0 || (grid.centre(cells[i]) - mean).norm() < (nearest - mean).norm())
      nearest = grid.centre(cells[i]);
  if (!cells.empty() && !name.empty())
    panel.addLabel(nearest, name);
}

/** @brief Returns a shade of the ceiling's colour; those of neighbouring numbers
 * differ. */
Colour
ceilingShade(std::size_t number)
{
  return lightened(colours::ceiling, 0.2 * static_cast<double>(number % 4));
}

/** @brief The shade of cells with a minimum number of points. */
struct Shade {
  std::size_t least;
  Colour colour;
  const char* meaning;
};

constexpr std::array<Shade, 7> shades{{{1, {198, 219, 239}, "1 point a cell"},
                                       {2, {158, 202, 225}, "2"},
                                       {4, {107, 174, 214}, "4"},
                                       {10, {49, 130, 189}, "10"},
                                       {50, {8, 81, 156}, "50"},
                                       {250, {8, 48, 107}, "250"},
                                       {1000, {3, 19, 43}, "1000 or more"}}};

using CellCounts = std::unordered_map<CellKey, std::size_t>;

void
count(const PointView& points, const CellGrid& grid, CellCounts& counts)
{
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f p = points[i];
    if (points.isFinite(i) && grid.holds(p.x(), p.y()))
      ++counts[keyOf(grid.at(p.x(), p.y()))];
  }
}

Panel
densityPanel(const std::string& title, const CellCounts& counts, double cell_size)
{
  Panel panel(title);
  std::array<std::vector<CellKey>, shades.size()> keys;
  for (const auto& [key, count] : counts) {
    std::size_t shade = 0;
    while (shade + 1 < shades.size() && count >= shades[shade + 1].least)
      ++shade;
    keys[shade].push_back(key);
  }
  for (std::size_t s = 0; s < shades.size(); ++s)
    panel.addCells(CellSet(std::move(keys[s])), cell_size, shades[s].colour);
  return panel;
}

/** @brief Returns the cells of a room, all or those not completely seen. */
CellSet
cellsOf(const BuildingRoom& room, bool hidden_only)
{
  std::vector<CellKey> keys;
  for (const RoomColumn& column : room.columns)
    if (!hidden_only || !column.floor_seen || !column.ceiling_seen)
      keys.push_back(keyOf(column.cell));
  return CellSet(std::move(keys));
}

/** @brief Adds the heights of a room's ceiling above the floor of its storey. */
void
addHeights(const BuildingRoom& room, double floor, double cell_size, Panel& panel)
{
  constexpr double step = 0.1; // metres
  constexpr int levels = 40;
  std::map<int, std::vector<CellKey>> keys;
  for (const RoomColumn& column : room.columns)
    keys[std::clamp(static_cast<int>((column.ceiling - floor - 1.5) / step), 0,
                    levels - 1)]
        .push_back(keyOf(column.cell));
  for (auto& [level, cells] : keys)
    panel.addCells(CellSet(std::move(cells)), cell_size,
                   lightened(darkened(colours::ceiling, 0.5),
                             level / static_cast<double>(levels)));
}

/** @brief Draws all rooms in one trial; rooms with details from earlier trials are
 * faint. */
Panel
trialPanel(const std::vector<SliceDetails>& rooms, int number, double cell_size)
{
  std::string slices;
  std::size_t accepted = 0;
  Panel panel;
  for (const SliceDetails& room : rooms) {
    const auto trial = std::find_if(room.trials.begin(), room.trials.end(),
                                    [&](const auto& t) { return t.number == number; });
    panel.addCells(room.ceiling, cell_size,
                   trial == room.trials.end() ? colours::faint : ceiling_colour);
    if (trial == room.trials.end())
      continue;
    slices.clear();
    for (const double fraction : trial->fractions)
      slices += (slices.empty() ? "" : " and ") + shortDecimalText(fraction, 4);
    accepted += trial->accepted.size();
    panel.addCells(trial->slice, cell_size, colours::wall);
    for (const auto& [regions, colour] :
         {std::pair(&trial->accepted, colours::detail),
          std::pair(&trial->rejected, colours::removed)})
      for (const CellSet& region : *regions)
        addNamed(region, cell_size, colour, std::to_string(region.size()), panel);
  }
  panel.title = "trial " + std::to_string(number) + ", slice at " + slices + ": " +
                (accepted > 0 ? counted(accepted, "region") : "nothing");
  return panel;
}

} // namespace

Picture
drawThinning(const RowSource& before, const PointView& after, double leaf)
{
  constexpr double most = 4000; // cells a side
  pcl::Indices all(after.size());
  std::iota(all.begin(), all.end(), 0);
  double size = leaf;
  Box view = viewOf(CellSet(CellGrid(size), after, all), size);
  while (!view.isEmpty() && view.sizes().maxCoeff() / size > most)
    size *= 2;
  const CellGrid grid(size);
  std::array<CellCounts, 2> counts;
  RowCoordinates coordinates(before.fields(), before.rowSize());
  before.forEachPiece([&](const RowSource::Piece& piece) {
    count(coordinates.of(piece.rows, piece.size), grid, counts[0]);
    return true;
  });
  count(after, grid, counts[1]);
  Picture picture("Thinning: the mean of the points of each voxel, seen from above");
  picture.addMaps(
      {densityPanel("scan: " + counted(before.size(), "point"), counts[0], size),
       densityPanel("thinned: " + counted(after.size(), "point"), counts[1], size)},
      view);
  for (const auto& shade : shades)
    picture.addLegend(shade.meaning, shade.colour);
  return picture;
}

Picture
drawRooms(const Building& building)
{
  const double cell_size = building.grid.size();
  Picture picture("Rooms: " + std::to_string(building.rooms.size()) + " on " +
                  counted(building.storeys.size(), "storey"));
  CellSet all;
  for (const BuildingRoom& room : building.rooms)
    all = unite(all, cellsOf(room, false));
  for (const PlanStorey& storey : building.storeys) {
    Panel rooms(storey.name);
    Panel heights("height of " + storey.name);
    for (const BuildingRoom& room : building.rooms) {
      if (room.storey != storey.number)
        continue;
      const Colour colour = roomColour(room.id);
      addNamed(cellsOf(room, false), cell_size, colour,
               std::to_string(room.id) + ": " + decimalText(room.area, 1) + " m²",
               rooms);
      rooms.addCells(cellsOf(room, true), cell_size, darkened(colour, 0.25));
      addHeights(room, storey.floor, cell_size, heights);
    }
    picture.addMaps({rooms, heights}, viewOf(all, cell_size));
  }
  picture.addLegend("ceiling, the lighter the higher above the storey's floor",
                    colours::ceiling);
  return picture;
}

Picture
drawPlanes(const std::vector<pcl::HorizontalPlane>& planes,
           const PointView& points,
           double cell_size)
{
  Panel above("ceilings");
  Panel below("floors, and what is neither");
  CellSet all;
  std::array<std::size_t, 3> count{}; // by kind
  std::vector<const pcl::HorizontalPlane*> by_size;
  for (const auto& plane : planes)
    by_size.push_back(&plane);
  std::stable_sort(by_size.begin(), by_size.end(),
                   [](const auto* a, const auto* b) { return a->area > b->area; });
  for (const auto* plane : by_size) {
    const CellSet cells(CellGrid(cell_size), points, plane->inliers.indices);
    if (cells.empty())
      continue;
    const bool is_ceiling = plane->kind == LevelKind::Ceiling;
    const bool is_floor = plane->kind == LevelKind::Floor;
    const std::size_t number = count[is_ceiling ? 0 : is_floor ? 1 : 2]++;
    const Colour colour =
        is_ceiling ? ceilingShade(number)
        : is_floor ? lightened(colours::floor, 0.35 * static_cast<double>(number % 3))
                   : colours::other;
    addNamed(cells, cell_size, colour, decimalText(plane->height, 2) + " m",
             is_ceiling ? above : below);
    all = unite(all, cells);
  }
  Picture picture("Horizontal planes: " + counted(count[0], "ceiling") + ", " +
                  counted(count[1], "floor") + ", " + std::to_string(count[2]) +
                  " neither");
  picture.addMaps({above, below}, viewOf(all, cell_size));
  picture.addLegend("ceiling", colours::ceiling);
  picture.addLegend("floor", colours::floor);
  picture.addLegend("neither", colours::other);
  return picture;
}

Picture
drawRegions(const RegionMap& map)
{
  const auto kept = std::count_if(map.number.begin(), map.number.end(),
                                  [](int number) { return number > 0; });
  const std::size_t min_named = std::max<std::size_t>(12, map.cells.size() / 1500);
  const std::vector<CellSet> regions = map.regionCells();
  Panel binary("binary map: " + counted(map.cells.size(), "cell"));
  Panel sizes("regions: " + std::to_string(regions.size()) + ", sizes in cells");
  Panel decision("kept (C): " + std::to_string(kept) + " of " +
                 std::to_string(regions.size()));
  binary.addCells(map.cells, map.cell_size, colours::other);
  for (std::size_t r = 0; r < regions.size(); ++r) {
    const bool is_kept = map.number[r] > 0;
    const bool is_named = regions[r].size() >= min_named;
    const Colour colour = is_kept ? ceilingShade(r) : colours::removed;
    const std::string size = std::to_string(regions[r].size());
    addNamed(regions[r], map.cell_size, colourNumber(r), is_named ? size : "", sizes);
    addNamed(regions[r], map.cell_size, colour,
             !is_named ? ""
             : is_kept ? "C"
                       : "O",
             decision);
  }
  Picture picture("Outlier removal by grid regions: " + std::to_string(kept) + " of " +
                  counted(regions.size(), "region") + " kept");
  picture.addMaps({binary, sizes, decision}, viewOf(map.cells, map.cell_size));
  picture.addLegend("occupied cell", colours::other);
  picture.addLegend("kept, a shade a region", colours::ceiling);
  picture.addLegend("removed", colours::removed);
  picture.addNote("Regions above the largest gap of the sizes are kept: above " +
                  counted(map.threshold, "cell") + ".");
  return picture;
}

Picture
drawSlices(const std::vector<SliceDetails>& rooms, double cell_size)
{
  CellSet all;
  int trials = 0;
  std::size_t details = 0;
  Panel found;
  for (const SliceDetails& room : rooms) {
    all = unite(all, unite(room.ceiling, room.cells));
    details += room.sizes.size();
    for (const SliceTrial& trial : room.trials)
      trials = std::max(trials, trial.number);
    found.addCells(room.ceiling, cell_size, ceiling_colour);
    found.addCells(room.cells, cell_size, colours::detail);
  }
  found.title = "found: " + (details > 0 ? counted(details, "detail") : "no detail");
  std::vector<Panel> maps;
  for (int number = 1; number <= trials; ++number)
    maps.push_back(trialPanel(rooms, number, cell_size));
  maps.push_back(found);
  Picture picture("Grid-slices analysis of " + counted(rooms.size(), "room") + ": " +
                  (details > 0 ? counted(details, "detail") : "no details"));
  picture.addMaps(maps, grown(viewOf(all, cell_size), 0.3));
  picture.addLegend("ceiling", ceiling_colour);
  picture.addLegend("slice", colours::wall);
  picture.addLegend("zero-valued region taken, its cells; detail", colours::detail);
  picture.addLegend("rejected: too small, or nothing above", colours::removed);
  return picture;
}

FloorCells
floorCellsOf(const pcl::FloorProjectionRecovery<pcl::PointXYZ>& recovery)
{
  const CellGrid grid(recovery.getGridSize());
  const PointView points(*recovery.getInputCloud());
  const pcl::Indices& sources = recovery.getProjectedIndices();
  const auto projected =
      sources.end() - static_cast<std::ptrdiff_t>(recovery.getNumberOfProjected());
  return {grid.size(), CellSet(grid, points, pcl::Indices(sources.begin(), projected)),
          CellSet(grid, points, pcl::Indices(projected, sources.end())),
          CellSet(grid, points, *recovery.getRemovedIndices())};
}

Picture
drawFloor(const std::vector<FloorCells>& rooms)
{
  Panel before("floor as detected");
  Panel after("floor completed");
  CellSet all;
  std::size_t recovered = 0;
  std::size_t removed = 0;
  for (const auto& room : rooms) {
    before.addCells(room.recovered, room.cell_size, hidden_colour);
    before.addCells(room.removed, room.cell_size, colours::removed);
    before.addCells(room.seen, room.cell_size, colours::floor);
    after.addCells(room.seen, room.cell_size, colours::floor);
    after.addCells(room.recovered, room.cell_size, colours::recovered);
    all = unite(all, unite(room.seen, unite(room.recovered, room.removed)));
    recovered += room.recovered.size();
    removed += room.removed.size();
  }
  Picture picture("Floor recovery: " + counted(recovered, "cell") +
                  " projected from the ceiling, " + counted(removed, "cell") +
                  " removed");
  picture.addMaps({before, after}, viewOf(all, rooms.empty() ? 1 : rooms[0].cell_size));
  picture.addLegend("seen", colours::floor);
  picture.addLegend("hidden below the ceiling", hidden_colour);
  picture.addLegend("outside the rooms: removed", colours::removed);
  picture.addLegend("recovered", colours::recovered);
  return picture;
}

} // namespace pcl::sedr::tools
