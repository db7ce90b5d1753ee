// SPDX-License-Identifier: BSD-3-Clause
#include "stage_pictures.h"

#include "sedr_filters/src/base/field_access.h"
#include "sedr_filters/src/base/number_text.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl::sedr::tools {
namespace {

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

using CellCounts = LabelCounts::mapped_type;

const CellCounts&
countsOf(StructureLabel label, const LabelCounts& counts)
{
  static const CellCounts none;
  const auto found = counts.find(label);
  return found == counts.end() ? none : found->second;
}

/** @brief Adds the cells of a label, coloured by what became of them. */
void
addChanges(StructureLabel label,
           const LabelCounts& before,
           const LabelCounts& after,
           Panel& panel)
{
  constexpr double steps = 5; // of shades
  const CellCounts& was = countsOf(label, before);
  const CellCounts& is = countsOf(label, after);
  std::vector<CellKey> gone;
  for (const auto& cell : was)
    if (is.count(cell.first) == 0)
      gone.push_back(cell.first);
  panel.addCells(CellSet(std::move(gone)), label_cell, colours::removed);
  std::map<double, std::vector<CellKey>> by_share; // of points that came
  for (const auto& [key, count] : is) {
    const auto old = was.find(key);
    const double kept = was.empty()        ? 1
                        : old == was.end() ? 0
                                           : static_cast<double>(old->second) /
                                                 static_cast<double>(count);
    by_share[std::round(steps * std::max(0.0, 1 - kept)) / steps].push_back(key);
  }
  for (auto& [share, keys] : by_share)
    panel.addCells(CellSet(std::move(keys)), label_cell,
                   mixed(colourOf(label), colours::recovered, share));
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

} // namespace

LabelCounts
labelCountsOf(const RowSource& scan)
{
  const CellGrid grid(label_cell);
  const auto* field = findField(scan.fields(), "label");
  RowCoordinates coordinates(scan.fields(), scan.rowSize());
  LabelCounts counts;
  scan.forEachPiece([&](const RowSource::Piece& piece) {
    const PointView points = coordinates.of(piece.rows, piece.size);
    for (std::size_t i = 0; i < piece.size; ++i) {
      const Eigen::Vector3f p = points[i];
      const double label =
          !field ? 0
                 : readField(piece.rows + i * scan.rowSize() + field->offset,
                             field->datatype);
      if (points.isFinite(i) && grid.holds(p.x(), p.y()))
        ++counts[static_cast<StructureLabel>(label >= 0 && label <= 5 ? label : 0)]
                [keyOf(grid.at(p.x(), p.y()))];
    }
    return true;
  });
  return counts;
}

Picture
drawLabels(const LabelCounts& before, const LabelCounts& after)
{
  std::vector<CellKey> keys;
  std::vector<CellKey> labelled;
  std::array<std::size_t, 2> sums{};
  for (const auto* counts : {&before, &after})
    for (const auto& [label, cells] : *counts)
      for (const auto& [key, count] : cells) {
        keys.push_back(key);
        sums[counts == &before ? 0 : 1] += count;
        if (label != StructureLabel::Other && counts == &after)
          labelled.push_back(key);
      }
  const CellSet all(std::move(keys));
  std::vector<Panel> maps;
  Picture picture(counted(sums[0], "point") + " before, " + counted(sums[1], "point") +
                  " after");
  const auto add = [&](StructureLabel label) {
    std::size_t points = 0;
    for (const auto& cell : countsOf(label, after))
      points += cell.second;
    maps.emplace_back(std::string(toString(label)) + ": " + counted(points, "point"));
    maps.back().addCells(all, label_cell, colours::faint);
    addChanges(label, before, after, maps.back());
    picture.addLegend(toString(label), colourOf(label));
  };
  for (const auto label :
       {StructureLabel::Ceiling, StructureLabel::Floor, StructureLabel::Wall,
        StructureLabel::Detail, StructureLabel::Column})
    if (countsOf(label, before) != countsOf(label, after))
      add(label);
  if (maps.empty())
    add(StructureLabel::Other);
  const CellSet structure(std::move(labelled));
  picture.addMaps(maps, viewOf(structure.empty() ? all : structure, label_cell));
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

} // namespace pcl::sedr::tools
