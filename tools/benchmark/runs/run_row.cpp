// SPDX-License-Identifier: BSD-3-Clause
#include "run_row.h"

#include "benchmark/table/bars.h"
#include "benchmark/table/cells.h"
#include "benchmark/table/csv_line.h"

#include <algorithm>
#include <functional>
#include <stdexcept>

namespace pcl::sedr::benchmark {

namespace {

/** @brief A column: its name, and the functions that write and read its cell. */
struct Column {
  std::string name;
  std::function<std::string(const RunRow&)> write;
  std::function<void(const std::string&, RunRow&)> read;
};

/** @brief The columns of a row, each declared once. */
class Columns {
public:
  /** @brief Adds a column; `part(row)` returns the member it shows. */
  template <typename PartT>
  void add(const std::string& name, PartT part)
  {
    columns_.push_back(
        {name, [part](const RunRow& row) { return cellOf(part(row)); },
         [part](const std::string& cell, RunRow& row) { readCell(cell, part(row)); }});
  }

  /** @brief Adds the column of a member of a row. */
  template <typename ValueT>
  void add(const std::string& name, ValueT RunRow::*member)
  {
    add(
        name, [member](auto& row) -> auto& { return row.*member; });
  }

  /** @brief Returns a function that adds the columns of a part of the row, from their
   * names and the members of the part. */
  template <typename PartT>
  auto adderOf(PartT RunRow::*part)
  {
    return [this, part](const std::string& name, auto member) {
      add(
          name, [ part, member ](auto& row) -> auto& { return row.*part.*member; });
    };
  }

  /** @brief Adds a column computed from others; it is not read back. */
  void addDerived(const std::string& name,
                  const std::function<std::string(const RunRow&)>& write)
  {
    columns_.push_back({name, write, [](const std::string&, RunRow&) {}});
  }

  const std::vector<Column>& all() const { return columns_; }

private:
  std::vector<Column> columns_;
};

void
addRun(Columns& columns)
{
  columns.add("scene", &RunRow::scene);
  columns.add("noise", &RunRow::noise);
  columns.add("seed", &RunRow::seed);
  columns.add("with_mesh", &RunRow::with_mesh);
  columns.add("points", &RunRow::points);
  columns.add("failure", &RunRow::failure);
}

void
addRooms(Columns& columns)
{
  const auto add = columns.adderOf(&RunRow::rooms);
  add("rooms_true", &RoomFigures::rooms_true);
  add("rooms_found", &RoomFigures::rooms_found);
  add("rooms_matched", &RoomFigures::rooms_matched);
  add("area_error", &RoomFigures::area_error);
  add("height_error", &RoomFigures::height_error);
  add("volume_error", &RoomFigures::volume_error);
  add("mesh_volume_error", &RoomFigures::mesh_volume_error);
}

void
addPlan(Columns& columns)
{
  const auto add = columns.adderOf(&RunRow::plan);
  add("corners_true", &PlanFigures::corners_true);
  add("corners_found", &PlanFigures::corners_found);
  add("rooms_with_other_corners", &PlanFigures::rooms_with_other_corners);
  add("corner_distance_max", &PlanFigures::corner_distance_max);
  add("arcs_true", &PlanFigures::arcs_true);
  add("arcs_found", &PlanFigures::arcs_found);
  add("radius_error", &PlanFigures::radius_error);
  add("perimeter_error", &PlanFigures::perimeter_error);
}

void
addSolid(Columns& columns)
{
  const auto add = columns.adderOf(&RunRow::solid);
  add("solid_components", &SolidFigures::components);
  add("solid_closed_manifold", &SolidFigures::closed_manifold);
  add("solid_self_intersections", &SolidFigures::self_intersections);
  add("solid_triangles", &SolidFigures::triangles);
  add("truth_to_solid_mean", &SolidFigures::truth_to_solid_mean);
  add("truth_to_solid_max", &SolidFigures::truth_to_solid_max);
  add("solid_to_truth_mean", &SolidFigures::solid_to_truth_mean);
  add("solid_to_truth_max", &SolidFigures::solid_to_truth_max);
  add("solid_volume_error", &SolidFigures::volume_error);
  add("solid_wall_area_error", &SolidFigures::wall_area_error);
}

void
addModel(Columns& columns)
{
  const auto add = columns.adderOf(&RunRow::mesh);
  add("components", &ModelFigures::components);
  add("closed", &ModelFigures::closed);
  add("edge_manifold", &ModelFigures::edge_manifold);
  add("vertex_manifold", &ModelFigures::vertex_manifold);
  add("closed_manifold", &ModelFigures::closed_manifold);
  add("truth_to_mesh_mean", &ModelFigures::truth_to_mesh_mean);
  add("truth_to_mesh_rms", &ModelFigures::truth_to_mesh_rms);
  add("truth_to_mesh_p95", &ModelFigures::truth_to_mesh_p95);
  add("truth_to_mesh_max", &ModelFigures::truth_to_mesh_max);
  add("truth_within_1cm", &ModelFigures::truth_within_1cm);
  add("truth_within_5cm", &ModelFigures::truth_within_5cm);
  add("mesh_to_truth_mean", &ModelFigures::mesh_to_truth_mean);
  add("mesh_to_truth_p95", &ModelFigures::mesh_to_truth_p95);
  add("mesh_to_truth_max", &ModelFigures::mesh_to_truth_max);
  add("mesh_beyond_5cm", &ModelFigures::mesh_beyond_5cm);
  add("detail_within_1cm", &ModelFigures::detail_within_1cm);
  add("detail_within_5cm", &ModelFigures::detail_within_5cm);
}

void
addStructure(Columns& columns)
{
  const auto add = columns.adderOf(&RunRow::structure);
  add("points_to_truth_mean", &StructureFigures::points_to_truth_mean);
  add("points_to_truth_max", &StructureFigures::points_to_truth_max);
  add("points_beyond_5cm", &StructureFigures::points_beyond_5cm);
  add("truth_covered", &StructureFigures::truth_covered);
}

void
addLabels(Columns& columns)
{
  for (std::size_t k = 0; k < scored_labels.size(); ++k) {
    const std::string label = toString(scored_labels[k]);
    columns.add(
        label + "_recall", [k](auto& row) -> auto& { return row.labels[k].recall; });
    columns.add(
        label + "_precision", [k](auto& row) -> auto& {
          return row.labels[k].precision;
        });
  }
}

std::string
missesOf(const RunRow& row)
{
  std::string text;
  for (const Miss& miss : missedBars(row))
    text += (text.empty() ? "" : "; ") + miss.text;
  return text;
}

std::vector<Column>
makeColumns()
{
  Columns columns;
  addRun(columns);
  addRooms(columns);
  addPlan(columns);
  addSolid(columns);
  addModel(columns);
  addStructure(columns);
  addLabels(columns);
  columns.add("seconds", &RunRow::seconds);
  columns.add("stage_seconds", &RunRow::stage_seconds);
  columns.add("warnings", &RunRow::warnings);
  columns.addDerived("missed", missesOf);
  return columns.all();
}

const std::vector<Column>&
allColumns()
{
  static const std::vector<Column> columns = makeColumns();
  return columns;
}

} // namespace

bool
RunRow::isSameRun(const RunRow& other) const
{
  return scene == other.scene && cellOf(noise) == cellOf(other.noise) &&
         seed == other.seed && with_mesh == other.with_mesh;
}

std::string
csvHeader()
{
  std::vector<std::string> names;
  for (const Column& column : allColumns())
    names.push_back(column.name);
  return joinCells(names);
}

std::string
toCsv(const RunRow& row)
{
  std::vector<std::string> cells;
  for (const Column& column : allColumns())
    cells.push_back(column.write(row));
  return joinCells(cells);
}

RunRow
rowFromCsv(const std::string& header, const std::string& line)
{
  const auto names = splitCells(header);
  const auto cells = splitCells(line);
  if (cells.size() != names.size())
    throw std::invalid_argument("there are " + std::to_string(cells.size()) +
                                " cells for " + std::to_string(names.size()) +
                                " columns");
  RunRow row;
  for (const Column& column : allColumns()) {
    const auto at = std::find(names.begin(), names.end(), column.name);
    if (at == names.end())
      continue;
    try {
      column.read(cells[static_cast<std::size_t>(at - names.begin())], row);
    }
    catch (const std::invalid_argument& error) {
      throw std::invalid_argument("column " + column.name + ": " + error.what());
    }
  }
  return row;
}

} // namespace pcl::sedr::benchmark
