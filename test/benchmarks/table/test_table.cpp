// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/runs/run_groups.h"
#include "benchmark/table/table.h"
#include "benchmarks/benchmark_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace benchmark_test {
namespace {

/** The lines of a text that begin with `start`. */
std::vector<std::string>
linesWith(const std::string& text, const std::string& start)
{
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    if (line.compare(0, start.size(), start) == 0)
      lines.push_back(line);
  return lines;
}

std::vector<std::string>
cellsOf(const std::string& line)
{
  std::vector<std::string> cells;
  std::istringstream stream(line.substr(2));
  for (std::string cell; std::getline(stream, cell, '|');)
    cells.push_back(cell.substr(cell[0] == ' ' ? 1 : 0));
  for (std::string& cell : cells)
    while (!cell.empty() && cell.back() == ' ')
      cell.pop_back();
  return cells;
}

/** Returns the cell of a column in the first row that begins with `row`. */
std::string
cell(const std::string& table, const std::string& row, const std::string& column)
{
  const auto titles = cellsOf(linesWith(table, "| scene |").at(0));
  const auto cells = cellsOf(linesWith(table, row).at(0));
  for (std::size_t i = 0; i < titles.size(); ++i)
    if (titles[i] == column)
      return cells.at(i);
  return "no such column";
}

TEST(Table, has_a_row_a_scene_and_noise_in_order)
{
  const std::string all = tableOf({goodRow("hall", 0.02), goodRow("attic", 0.001),
                                   goodRow("hall", 0.001), goodRow("hall", 0.001, 2)});
  const std::string table = all.substr(0, all.find("## Plans and solids"));
  EXPECT_EQ(linesWith(table, "| hall | 0.1 |").size(), 1u);
  EXPECT_EQ(linesWith(table, "| hall | 2 |").size(), 1u);
  EXPECT_EQ(linesWith(table, "| attic | 0.1 |").size(), 1u);
  EXPECT_LT(table.find("| hall | 0.1 |"), table.find("| hall | 2 |"));
  EXPECT_LT(table.find("| hall | 2 |"), table.find("| attic | 0.1 |"));
  EXPECT_NE(
      table.find("Scenes: 2. Seeds: 1, 2. Runs: 4. Runs that reach every bar: 4."),
      std::string::npos);
}

TEST(Table, shows_the_worst_seed_and_the_median)
{
  std::vector<RunRow> rows{goodRow("hall", 0.01, 1), goodRow("hall", 0.01, 2),
                           goodRow("hall", 0.01, 3)};
  rows[0].mesh.truth_to_mesh_mean = 0.0012;
  rows[1].mesh.truth_to_mesh_mean = 0.0025;
  rows[2].mesh.truth_to_mesh_mean = 0.0015;
  rows[0].mesh.truth_within_1cm = 0.97;
  const std::string table = tableOf(rows);
  EXPECT_EQ(cell(table, "| hall", "mean, cm"), "0.250 (0.150)");
  EXPECT_EQ(cell(table, "| hall", "≤ 1 cm"), "97.00 (98.00)");
  EXPECT_EQ(cell(table, "| hall", "max, cm"), "3.1"); // the same for all seeds
  EXPECT_EQ(cell(table, "| hall", "rooms"), "4/4");
  EXPECT_EQ(cell(table, "| hall", "closed"), "yes");
  EXPECT_EQ(cell(table, "| hall", "volume"), "0.40");
  EXPECT_EQ(cell(table, "| hall", "wall"), "99.0 / 98.0");
  EXPECT_EQ(cell(table, "| hall", "missed"), "");
}

TEST(Table, marks_what_misses_its_bar)
{
  std::vector<RunRow> rows{goodRow("hall", 0.01, 1), goodRow("hall", 0.01, 2)};
  rows[1].mesh.truth_to_mesh_mean = 0.005;
  rows[1].rooms.rooms_found = 3;
  rows[1].mesh.components = 3;
  rows[1].mesh.closed_manifold = false;
  rows[1].mesh.detail_within_5cm = 0.5;
  const std::string table = tableOf(rows);
  EXPECT_EQ(cell(table, "| hall", "mean, cm"), "**0.500 (0.100)**");
  EXPECT_EQ(cell(table, "| hall", "rooms"), "**3-4/4**");
  EXPECT_EQ(cell(table, "| hall", "closed"), "**no 1**");
  EXPECT_EQ(cell(table, "| hall", "details ≤ 5 cm"), "**50.00**");
  EXPECT_EQ(cell(table, "| hall", "≤ 5 cm"), "99.90");
  EXPECT_EQ(cell(table, "| hall", "missed"),
            "rooms 1/2, closed 1/2, mean 1/2, details 1/2");
  EXPECT_NE(table.find("Runs that reach every bar: 1. Missed: rooms 1/2"),
            std::string::npos);
}

TEST(Table, tells_which_runs_failed_and_why)
{
  RunRow failed;
  failed.scene = "hall";
  failed.noise = 0.01;
  failed.seed = 2;
  failed.rooms.rooms_true = 4;
  failed.failure = "no floor";
  const std::string alone = tableOf({failed});
  EXPECT_EQ(cell(alone, "| hall", "rooms"), "**0/4**");
  EXPECT_EQ(cell(alone, "| hall", "mean, cm"), "-");
  EXPECT_EQ(cell(alone, "| hall", "closed"), "-");
  EXPECT_EQ(cell(alone, "| hall", "missed"), "failed 1/1");
  EXPECT_NE(alone.find("- hall, noise 1 cm, seed 2: no floor"), std::string::npos);

  const std::string mixed = tableOf({goodRow("hall"), failed});
  EXPECT_EQ(cell(mixed, "| hall", "rooms"), "**0-4/4**");
  EXPECT_EQ(cell(mixed, "| hall", "mean, cm"), "0.100"); // of the successful runs
  EXPECT_EQ(cell(mixed, "| hall", "missed"), "failed 1/2");
}

TEST(Table, counts_the_latest_of_equal_runs)
{
  RunRow old = goodRow("hall");
  old.mesh.truth_to_mesh_mean = 0.1;
  const std::string table = tableOf({old, goodRow("hall")});
  EXPECT_EQ(cell(table, "| hall", "mean, cm"), "0.100");
  EXPECT_NE(table.find("Runs: 1."), std::string::npos);
}

TEST(Table, gives_runs_without_mesh_a_table_of_their_own)
{
  RunRow quick = goodRow("hall");
  quick.with_mesh = false;
  quick.mesh = ModelFigures();
  const std::string table = tableOf({quick});
  EXPECT_EQ(table.find("## Models"), std::string::npos);
  EXPECT_EQ(cell(table, "| hall", "mean, cm"), "0.050");
  EXPECT_EQ(cell(table, "| hall", "covered"), "99.90");
  EXPECT_EQ(cell(table, "| hall", "volume"), "0.30"); // of the plan
  const std::string both = tableOf({quick, goodRow("hall")});
  EXPECT_LT(both.find("## Models"), both.find("## Structure alone"));
}

TEST(Table, has_the_seconds_of_each_stage)
{
  std::vector<RunRow> rows{goodRow("hall", 0.01, 1), goodRow("hall", 0.01, 2),
                           goodRow("hall", 0.02, 1)};
  rows[1].stage_seconds[0].second = 0.75;
  rows[2].stage_seconds = {{"ParallelVoxelGrid", 0.5}}; // stopped early
  const std::string table = tableOf(rows);
  const auto titles = linesWith(table, "| scene | points, M |");
  ASSERT_EQ(titles.size(), 1u);
  EXPECT_EQ(cellsOf(titles[0]),
            (std::vector<std::string>{"scene", "points, M", "ParallelVoxelGrid",
                                      "StructuralPoisson", "all"}));
  EXPECT_EQ(cellsOf(linesWith(table, "| hall | 1.23 |").at(0)),
            (std::vector<std::string>{"hall", "1.23", "0.50", "12.25", "12.50"}));
}

TEST(Table, has_plans_and_solids_by_themselves)
{
  std::vector<RunRow> rows{goodRow("hall", 0.01, 1), goodRow("hall", 0.01, 2)};
  rows[1].solid.truth_to_solid_mean = 0.0004;
  rows[1].plan.corners_found = 19;
  rows[1].plan.rooms_with_other_corners = 1;
  const std::string all = tableOf(rows);
  EXPECT_EQ(cell(all, "| hall", "missed"), ""); // of the models
  const std::string table = all.substr(all.find("## Plans and solids"));
  EXPECT_EQ(cell(table, "| hall", "closed"), "yes");
  EXPECT_EQ(cell(table, "| hall", "mean, cm"), "**0.0400 (0.0100)**");
  EXPECT_EQ(cell(table, "| hall", "corners"), "**18-19/18**");
  EXPECT_EQ(cell(table, "| hall", "triangles"), "120");
  EXPECT_EQ(cell(table, "| hall", "missed"), "solid mean 1/2, corners 1/2");
}

TEST(RunGroups, median_is_the_middle_one_or_the_lower_of_two)
{
  EXPECT_EQ(medianOf({1, 2, 9}), 2);
  EXPECT_EQ(medianOf({1, 2, 3, 9}), 2);
  EXPECT_TRUE(std::isnan(medianOf({})));
}

} // namespace
} // namespace benchmark_test
