// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/table/cells.h"
#include "benchmark/table/csv_file.h"
#include "benchmark/table/csv_line.h"
#include "benchmarks/benchmark_samples.h"
#include "simulator/temporary_folder.h"
#include "tool_error.h"

#include <gtest/gtest.h>

#include <fstream>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>

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

TEST(CsvLine, quotes_commas_and_quotes_and_stays_a_line)
{
  EXPECT_EQ(joinCells({"a", "b,c", "\"d\""}), "a,\"b,c\",\"\"\"d\"\"\"");
  EXPECT_EQ(joinCells({"two\nlines\r"}), "two lines ");
}

TEST(Cells, are_empty_where_nothing_is_known)
{
  EXPECT_EQ(cellOf(0.00123456), "0.00123456");
  EXPECT_EQ(cellOf(not_known), "");
  EXPECT_EQ(cellOf(std::optional<bool>()), "");
  EXPECT_EQ(cellOf(StageSeconds{{"A", 0.5}, {"B", 2}}), "A=0.5;B=2");
  double number = 0;
  EXPECT_THROW(readCell("0.1x", number), std::invalid_argument);
  std::size_t count = 0;
  EXPECT_THROW(readCell("-1", count), std::invalid_argument);
}

TEST(RunRow, has_a_column_for_every_figure)
{
  std::istringstream names(csvHeader());
  std::istringstream cells(toCsv(goodRow()));
  const std::set<std::string> empty{"failure", "warnings", "missed_bars", "missed"};
  std::set<std::string> known;
  std::string cell;
  for (std::string name; std::getline(names, name, ',');) {
    cell.clear();
    std::getline(cells, cell, ',');
    EXPECT_EQ(cell.empty(), empty.count(name) == 1) << name;
    EXPECT_TRUE(known.insert(name).second) << name;
  }
  EXPECT_FALSE(std::getline(cells, cell, ','));
}

TEST(RunRow, names_the_bars_that_it_missed)
{
  RunRow row = goodRow();
  row.rooms.rooms_found = 3;
  row.mesh.components = 3;
  row.plan.rooms_with_other_corners = 1;
  const std::string line = toCsv(row);
  EXPECT_NE(line.find(",rooms;corners,3 rooms of 4; 18 corners of 18"),
            std::string::npos)
      << line;
}

TEST(RunRow, is_known_by_scene_noise_seed_and_kind)
{
  const RunRow row = goodRow("a, b");
  const std::vector<std::string> lines{toCsv(goodRow("other")), toCsv(row)};
  EXPECT_TRUE(row.isIn(lines));
  EXPECT_FALSE(row.isIn({}));
  EXPECT_FALSE(goodRow("b").isIn(lines));
  EXPECT_FALSE(goodRow("a, b", 0.02).isIn(lines));
  EXPECT_FALSE(goodRow("a, b", 0.01, 2).isIn(lines));
  RunRow structure = row;
  structure.with_mesh = false;
  EXPECT_FALSE(structure.isIn(lines));
}

TEST_F(RunRows, grow_row_by_row)
{
  EXPECT_TRUE(linesToContinue(path()).empty());
  appendRow(path(), goodRow());
  EXPECT_EQ(bytesOf(path()), csvHeader() + "\n" + toCsv(goodRow()) + "\n");
  appendRow(path(), failedRow());
  EXPECT_EQ(linesToContinue(path()),
            (std::vector<std::string>{toCsv(goodRow()), toCsv(failedRow())}));
}

TEST_F(RunRows, lose_only_the_line_that_was_interrupted)
{
  appendRow(path(), goodRow());
  append("sample,0.02,1,1,12");
  EXPECT_EQ(linesToContinue(path()).size(), 1u);
  appendRow(path(), goodRow("sample", 0.02));
  ASSERT_EQ(linesToContinue(path()).size(), 2u);
  EXPECT_EQ(linesToContinue(path())[1], toCsv(goodRow("sample", 0.02)));
}

TEST_F(RunRows, begin_anew_where_even_the_header_was_interrupted)
{
  append("scene,noi");
  EXPECT_TRUE(linesToContinue(path()).empty());
  appendRow(path(), goodRow());
  EXPECT_EQ(linesToContinue(path()).size(), 1u);
}

TEST_F(RunRows, are_not_added_to_anything_else)
{
  EXPECT_THROW(linesToContinue(folder_.path().string()), ToolError);
  append("scene,noise,seed\nattic,0.01,1\n");
  EXPECT_THROW(linesToContinue(path()), ToolError);
}

} // namespace
} // namespace benchmark_test
