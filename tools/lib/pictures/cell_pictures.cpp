// SPDX-License-Identifier: BSD-3-Clause
#include "stage_pictures.h"

#include "sedr_filters/src/base/field_access.h"
#include "sedr_filters/src/base/number_text.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace pcl::sedr::tools {
namespace {

/** @brief Returns the cell nearest to the mean of some. */
Eigen::Vector2d
middleOf(const CellSet& cells, const CellGrid& grid)
{
  Places centres;
  Eigen::Vector2d mean(0, 0);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    centres.push_back(grid.centre(cells[i]));
    mean += centres.back() / static_cast<double>(cells.size());
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
          LabelCounts sums,
          const Box& view)
{
  constexpr double steps = 5; // of shades
  constexpr double absent = -2;
  constexpr double gone = -1;
  std::map<double, std::vector<CellKey>> keys; // by the share of points that came
  for (const auto& [key, counts] : changes) {
    const auto was = static_cast<double>(counts[0][label]);
    const auto is = static_cast<double>(counts[1][label]);
    keys[is == 0 ? was == 0 ? absent : gone
                 : std::round(steps * std::max(0.0, 1 - was / is)) / steps]
        .push_back(key);
  }
  const auto meaning = static_cast<StructureLabel>(label);
  Panel map(std::string(toString(meaning)) + ": " + counted(sums[1][label], "point"),
            view);
  for (auto& [share, cells] : keys)
    map.addCells(CellSet(std::move(cells)), label_cell,
                 share == absent ? colours::faint
                 : share == gone ? colours::removed
                                 : mixed(colourOf(meaning), colours::recovered,
                                         sums[0][label] == 0 ? 0 : share));
  return map;
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

} // namespace

void
countLabels(const RowSource& scan, std::size_t when, CellChanges& changes)
{
  const CellGrid grid(label_cell);
  const auto* field = findField(scan.fields(), "label");
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
  Picture picture(sumOf(sums[0]) + " before, " + sumOf(sums[1]) + " after");
  const Box view = viewOf(CellSet(structure.empty() ? all : structure), label_cell);
  std::vector<Panel> maps;
  for (const std::size_t label : {1, 2, 3, 4, 5, 0})
    if (label == 0 ? maps.empty() : is_changed[label]) {
      maps.push_back(changesOf(label, changes, sums, view));
      const auto meaning = static_cast<StructureLabel>(label);
      picture.addLegend(toString(meaning), colourOf(meaning));
    }
  picture.addMaps(std::move(maps));
  picture.addLegend("came", colours::recovered);
  picture.addLegend("gone", colours::removed);
  picture.addLegend("other points", colours::faint);
  return picture;
}

Picture
drawRooms(const Building& building)
{
  const double cell_size = building.grid.size();
  Picture picture("Rooms: " + std::to_string(building.rooms.size()) + " on " +
                  counted(building.storeys.size(), "storey"));
  std::vector<CellKey> all;
  for (const BuildingRoom& room : building.rooms)
    for (const RoomColumn& column : room.columns)
      all.push_back(keyOf(column.cell));
  const Box view = viewOf(CellSet(std::move(all)), cell_size);
  for (const PlanStorey& storey : building.storeys) {
    Panel rooms(storey.name, view);
    Panel heights("height of " + storey.name, view);
    for (const BuildingRoom& room : building.rooms) {
      if (room.storey != storey.number || room.columns.empty())
        continue;
      std::vector<CellKey> keys;
      std::vector<CellKey> hidden; // not completely seen
      for (const RoomColumn& column : room.columns) {
        keys.push_back(keyOf(column.cell));
        if (!column.floor_seen || !column.ceiling_seen)
          hidden.push_back(keys.back());
      }
      const CellSet cells(std::move(keys));
      rooms.addCells(cells, cell_size, roomColour(room.id));
      rooms.addCells(CellSet(std::move(hidden)), cell_size,
                     darkened(roomColour(room.id), 0.25));
      rooms.addLabel(middleOf(cells, building.grid), std::to_string(room.id) + ": " +
                                                         decimalText(room.area, 1) +
                                                         " m²");
      addHeights(room, storey.floor, cell_size, heights);
    }
    picture.addMaps({rooms, heights});
  }
  picture.addLegend("ceiling, the lighter the higher above the storey's floor",
                    colours::ceiling);
  return picture;
}

} // namespace pcl::sedr::tools
