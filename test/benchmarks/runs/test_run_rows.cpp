// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/table/cells.h"
#include "benchmark/table/csv_file.h"
#include "benchmark/table/csv_line.h"
#include "benchmarks/benchmark_samples.h"
#include "simulator/temporary_folder.h"
#include "tool_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

namespace benchmark_test {
namespace {

using pcl::sedr::tools::ToolError;
using sim::test::bytesOf;

RunRow
failedRow()
{
  RunRow row;
  row.scene = "dark, \"cold\" room";
  row.with_mesh = false;
  row.rooms.rooms_true = 1;
  row.failure = "no floor,\nbut 2 \"ceilings\"";
  return row;
}

class RunRows : public ::testing::Test {
protected:
  std::string path() const { return (folder_.path() / "runs.csv").string(); }

  void append(const std::string& text) const
  {
    std::ofstream(path(), std::ios::app) << text;
  }

  sim::test::TemporaryFolder folder_;
};

TEST(CsvLine, keeps_commas_and_quotes_and_stays_a_line)
{
  const std::vector<std::string> cells{"a", "", "b,c", "say \"no\"", " d ", ","};
  EXPECT_EQ(splitCells(joinCells(cells)), cells);
  EXPECT_EQ(joinCells({"a", "b,c", "\"d\""}), "a,\"b,c\",\"\"\"d\"\"\"");
  EXPECT_EQ(joinCells({"two\nlines\r"}), "two lines ");
  EXPECT_THROW(splitCells("a,\"b"), std::invalid_argument);
}

TEST(Cells, read_back_as_they_were_written)
{
  double number = 0;
  readCell(cellOf(0.00123456), number);
  EXPECT_EQ(number, 0.00123456);
  readCell(cellOf(not_known), number);
  EXPECT_TRUE(std::isnan(number));
  StageSeconds stages;
  readCell("A=0.5;B=2", stages);
  EXPECT_EQ(stages, (StageSeconds{{"A", 0.5}, {"B", 2}}));
  EXPECT_EQ(cellOf(stages), "A=0.5;B=2");
  bool flag = false;
  EXPECT_THROW(readCell("yes", flag), std::invalid_argument);
  EXPECT_THROW(readCell("0.1x", number), std::invalid_argument);
  std::size_t count = 0;
  EXPECT_THROW(readCell("-1", count), std::invalid_argument);
}

TEST(RunRow, reads_back_with_every_column)
{
  for (const RunRow& row : {goodRow(), failedRow(), RunRow()}) {
    const std::string line = toCsv(row);
    EXPECT_EQ(line.find('\n'), std::string::npos);
    EXPECT_EQ(toCsv(rowFromCsv(csvHeader(), line)), line);
  }
  const RunRow row = rowFromCsv(csvHeader(), toCsv(goodRow()));
  EXPECT_EQ(row.mesh.truth_to_mesh_p95, 0.004);
  EXPECT_EQ(row.mesh.detail_within_5cm, 0.99);
  EXPECT_EQ(row.labels[3].precision, 0.98);
  EXPECT_EQ(row.rooms.mesh_volume_error, 0.004);
  EXPECT_EQ(row.stage_seconds.back().first, "StructuralPoisson");
  EXPECT_EQ(rowFromCsv(csvHeader(), toCsv(failedRow())).scene, "dark, \"cold\" room");
}

TEST(RunRow, has_a_column_for_every_figure)
{
  // All figures differ, so a missing one would shift the others.
  const std::string line = toCsv(goodRow());
  const auto names = splitCells(csvHeader());
  EXPECT_EQ(splitCells(line).size(), names.size());
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
  const std::vector<std::string> known{"failure", "warnings", "missed"};
  const auto cells = splitCells(line);
  for (std::size_t i = 0; i < names.size(); ++i)
    EXPECT_NE(cells[i].empty(),
              std::find(known.begin(), known.end(), names[i]) == known.end())
        << names[i];
}

TEST(RunRow, reads_files_of_fewer_more_and_reordered_columns)
{
  const RunRow row = rowFromCsv("seed,wind,scene", "7,north,attic");
  EXPECT_EQ(row.scene, "attic");
  EXPECT_EQ(row.seed, 7u);
  EXPECT_FALSE(row.mesh.isMeasured());
}

TEST(RunRow, says_what_cannot_be_read)
{
  EXPECT_THROW(rowFromCsv("scene,seed", "attic"), std::invalid_argument);
  try {
    rowFromCsv("scene,seed", "attic,one");
    FAIL();
  }
  catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()), "column seed: 'one' is no whole number");
  }
}

TEST(RunRow, is_known_by_scene_noise_seed_and_kind)
{
  const RunRow row = goodRow();
  EXPECT_TRUE(row.isSameRun(rowFromCsv(csvHeader(), toCsv(row))));
  EXPECT_FALSE(row.isSameRun(goodRow("other")));
  EXPECT_FALSE(row.isSameRun(goodRow("sample", 0.02)));
  EXPECT_FALSE(row.isSameRun(goodRow("sample", 0.01, 2)));
  RunRow structure = row;
  structure.with_mesh = false;
  EXPECT_FALSE(row.isSameRun(structure));
}

TEST_F(RunRows, grow_row_by_row)
{
  EXPECT_TRUE(rowsToContinue(path()).empty());
  appendRow(path(), goodRow());
  EXPECT_EQ(bytesOf(path()), csvHeader() + "\n" + toCsv(goodRow()) + "\n");
  appendRow(path(), failedRow());
  ASSERT_EQ(readRows(path()).size(), 2u);
  EXPECT_EQ(readRows(path())[0].scene, "sample");
  EXPECT_EQ(rowsToContinue(path())[1].failure, "no floor, but 2 \"ceilings\"");
}

TEST_F(RunRows, lose_only_the_line_that_was_interrupted)
{
  appendRow(path(), goodRow());
  append("sample,0.02,1,1,12");
  EXPECT_EQ(readRows(path()).size(), 1u);
  EXPECT_EQ(rowsToContinue(path()).size(), 1u);
  appendRow(path(), goodRow("sample", 0.02));
  ASSERT_EQ(readRows(path()).size(), 2u);
  EXPECT_EQ(readRows(path())[1].noise, 0.02);
}

TEST_F(RunRows, begin_anew_where_even_the_header_was_interrupted)
{
  append("scene,noi");
  EXPECT_TRUE(rowsToContinue(path()).empty());
  appendRow(path(), goodRow());
  EXPECT_EQ(readRows(path()).size(), 1u);
}

TEST_F(RunRows, are_not_added_to_a_file_of_other_columns)
{
  append("scene,noise,seed\nattic,0.01,1\n");
  EXPECT_THROW(rowsToContinue(path()), ToolError);
  EXPECT_EQ(readRows(path()).size(), 1u); // but it can be read
}

TEST_F(RunRows, are_not_read_from_anything_else)
{
  EXPECT_THROW(readRows(path()), ToolError);
  EXPECT_THROW(readRows(folder_.path().string()), ToolError);
  append("x y z\n1 2 3\n");
  EXPECT_THROW(readRows(path()), ToolError);
  const std::string other = (folder_.path() / "other.csv").string();
  std::ofstream(other) << "scene,seed\nattic,1\nattic,two\n";
  try {
    readRows(other);
    FAIL();
  }
  catch (const ToolError& error) {
    EXPECT_NE(std::string(error.what()).find("line 3"), std::string::npos)
        << error.what();
  }
}

} // namespace
} // namespace benchmark_test
