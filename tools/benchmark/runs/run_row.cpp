// SPDX-License-Identifier: BSD-3-Clause
#include "run_row.h"

#include "benchmark/table/bars.h"
#include "benchmark/table/cells.h"
#include "benchmark/table/csv_line.h"

#include <algorithm>

namespace pcl::sedr::benchmark {

namespace {

/** @brief The names of the columns and the cells of a row, each column named once. */
struct Cells {
  std::vector<std::string> names;
  std::vector<std::string> cells;

  template <typename ValueT>
  void add(const std::string& name, const ValueT& value)
  {
    names.push_back(name);
    cells.push_back(cellOf(value));
  }
};

void
addRun(const RunRow& row, Cells& all)
{
  all.add("scene", row.scene);
  all.add("noise", row.noise);
  all.add("seed", row.seed);
  all.add("with_mesh", row.with_mesh);
  all.add("points", row.points);
  all.add("failure", row.failure);
}

void
addRooms(const RunRow& row, Cells& all)
{
  const auto& of = row.rooms;
  all.add("rooms_true", of.rooms_true);
  all.add("rooms_found", of.rooms_found);
  all.add("rooms_matched", of.rooms_matched);
  all.add("area_error", of.area_error);
  all.add("height_error", of.height_error);
  all.add("volume_error", of.volume_error);
  all.add("mesh_volume_error", of.mesh_volume_error);
}

void
addPlan(const RunRow& row, Cells& all)
{
  const auto& of = row.plan;
  all.add("corners_true", of.corners_true);
  all.add("corners_found", of.corners_found);
  all.add("rooms_with_other_corners", of.rooms_with_other_corners);
  all.add("corner_distance_max", of.corner_distance_max);
  all.add("arcs_true", of.arcs_true);
  all.add("arcs_found", of.arcs_found);
  all.add("radius_error", of.radius_error);
  all.add("perimeter_error", of.perimeter_error);
}

void
addSolid(const RunRow& row, Cells& all)
{
  const auto& of = row.solid;
  all.add("solid_components", of.components);
  all.add("solid_closed_manifold", of.closed_manifold);
  all.add("solid_self_intersections", of.self_intersections);
  all.add("solid_triangles", of.triangles);
  all.add("truth_to_solid_mean", of.truth_to_solid_mean);
  all.add("truth_to_solid_max", of.truth_to_solid_max);
  all.add("solid_to_truth_mean", of.solid_to_truth_mean);
  all.add("solid_to_truth_max", of.solid_to_truth_max);
  all.add("solid_volume_error", of.volume_error);
  all.add("solid_wall_area_error", of.wall_area_error);
}

void
addModel(const RunRow& row, Cells& all)
{
  const auto& of = row.mesh;
  all.add("components", of.components);
  all.add("closed", of.closed);
  all.add("edge_manifold", of.edge_manifold);
  all.add("vertex_manifold", of.vertex_manifold);
  all.add("closed_manifold", of.closed_manifold);
  all.add("truth_to_mesh_mean", of.truth_to_mesh_mean);
  all.add("truth_to_mesh_rms", of.truth_to_mesh_rms);
  all.add("truth_to_mesh_p95", of.truth_to_mesh_p95);
  all.add("truth_to_mesh_max", of.truth_to_mesh_max);
  all.add("truth_within_1cm", of.truth_within_1cm);
  all.add("truth_within_5cm", of.truth_within_5cm);
  all.add("mesh_to_truth_mean", of.mesh_to_truth_mean);
  all.add("mesh_to_truth_p95", of.mesh_to_truth_p95);
  all.add("mesh_to_truth_max", of.mesh_to_truth_max);
  all.add("mesh_beyond_5cm", of.mesh_beyond_5cm);
  all.add("detail_within_1cm", of.detail_within_1cm);
  all.add("detail_within_5cm", of.detail_within_5cm);
}

void
addStructure(const RunRow& row, Cells& all)
{
  const auto& of = row.structure;
  all.add("points_to_truth_mean", of.points_to_truth_mean);
  all.add("points_to_truth_max", of.points_to_truth_max);
  all.add("points_beyond_5cm", of.points_beyond_5cm);
  all.add("truth_covered", of.truth_covered);
}

void
addLabels(const RunRow& row, Cells& all)
{
  for (std::size_t k = 0; k < scored_labels.size(); ++k) {
    const std::string label = toString(scored_labels[k]);
    all.add(label + "_recall", row.labels[k].recall);
    all.add(label + "_precision", row.labels[k].precision);
  }
}

/** @brief Adds the missed bars by name, for tables, and by figure, for readers. */
void
addMisses(const RunRow& row, Cells& all)
{
  std::string names;
  std::string text;
  for (const Miss& miss : missedBars(row)) {
    names += (names.empty() ? "" : ";") + nameOf(miss.bar);
    text += (text.empty() ? "" : "; ") + miss.text;
  }
  all.add("missed_bars", names);
  all.add("missed", text);
}

Cells
cellsOf(const RunRow& row)
{
  Cells all;
  addRun(row, all);
  addRooms(row, all);
  addPlan(row, all);
  addSolid(row, all);
  addModel(row, all);
  addStructure(row, all);
  addLabels(row, all);
  all.add("seconds", row.seconds);
  all.add("stage_seconds", row.stage_seconds);
  all.add("warnings", row.warnings);
  addMisses(row, all);
  return all;
}

} // namespace

bool
RunRow::isIn(const std::vector<std::string>& lines) const
{
  const std::string start =
      joinCells({scene, cellOf(noise), cellOf(seed), cellOf(with_mesh)}) + ",";
  return std::any_of(lines.begin(), lines.end(), [&start](const std::string& line) {
    return line.compare(0, start.size(), start) == 0;
  });
}

std::string
csvHeader()
{
  return joinCells(cellsOf(RunRow()).names);
}

std::string
toCsv(const RunRow& row)
{
  return joinCells(cellsOf(row).cells);
}

} // namespace pcl::sedr::benchmark
