// SPDX-License-Identifier: BSD-3-Clause
#include "mpi/scan_parts.h"
#include "tool_error.h"
#include "tools/run_program.h"
#include "tools/sample_files.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr::tools;
using programs::pcdBytes;
using programs::TemporaryFolder;
using programs::writeFile;

std::vector<ScanInput>
inputsOf(const std::vector<std::pair<std::size_t, bool>>& files)
{
  std::vector<ScanInput> inputs;
  std::size_t first = 0;
  for (const auto& [rows, is_in_pieces] : files) {
    inputs.push_back({std::string(1, static_cast<char>('a' + inputs.size())),
                      {rows, is_in_pieces},
                      first});
    first += rows;
  }
  return inputs;
}

TEST(ScanParts, EveryRowGoesToOneRankInOrderAndEvenly)
{
  const auto inputs = inputsOf({{1000, true}, {1, true}, {499, true}, {2503, true}});
  ASSERT_EQ(rowsOf(inputs), 4003u);
  for (const std::size_t ranks : {1u, 2u, 3u, 7u}) {
    const auto parts = dealRows(inputs, ranks);
    ASSERT_EQ(parts.size(), ranks);
    std::size_t next = 0;
    for (const auto& ranges : parts) {
      std::size_t size = 0;
      for (const RowRange& range : ranges) {
        EXPECT_EQ(range.first, next);
        const ScanInput& input = inputs[static_cast<std::size_t>(range.path[0] - 'a')];
        EXPECT_EQ(range.first, input.first + range.begin);
        EXPECT_LE(range.end, input.head.rows);
        next += range.size();
        size += range.size();
      }
      EXPECT_NEAR(static_cast<double>(size), 4003. / static_cast<double>(ranks), 1);
    }
    EXPECT_EQ(next, 4003u);
  }
}

TEST(ScanParts, AFileThatHasToBeUnpackedGoesToOneRank)
{
  const auto inputs = inputsOf({{10, true}, {100, false}, {10, true}});
  for (const std::size_t ranks : {1u, 2u, 3u, 5u}) {
    std::size_t holders = 0;
    std::size_t next = 0;
    for (const auto& ranges : dealRows(inputs, ranks))
      for (const RowRange& range : ranges) {
        EXPECT_EQ(range.first, next);
        next += range.size();
        if (range.path == "b") {
          ++holders;
          EXPECT_EQ(range.size(), 100u);
        }
      }
    EXPECT_EQ(holders, 1u);
    EXPECT_EQ(next, 120u);
  }
}

TEST(ScanParts, MoreRanksThanRowsLeaveSomeWithout)
{
  const auto parts = dealRows(inputsOf({{2, true}}), 4);
  std::size_t rows = 0;
  for (const auto& ranges : parts)
    for (const RowRange& range : ranges)
      rows += range.size();
  EXPECT_EQ(rows, 2u);
  EXPECT_EQ(textOf({}), "no rows");
}

TEST(ScanParts, AreNamedByFileAndRows)
{
  EXPECT_EQ(textOf({{"a.pcd", 5, 10, 5}}), "rows 5 to 9 of 'a.pcd'");
  EXPECT_EQ(textOf({{"a.pcd", 5, 10, 5}, {"b.pcd", 0, 1, 10}}),
            "rows 5 to 9 of 'a.pcd' and rows 0 to 0 of 'b.pcd'");
  EXPECT_EQ(textOf({{"a", 0, 1, 0}, {"b", 0, 1, 0}, {"c", 0, 1, 0}, {"d", 0, 1, 0}}),
            "rows 0 to 0 of 'a', rows 0 to 0 of 'b' and those of 2 more files");
}

TEST(ScanParts, FilesOfAFolderComeByNameAndOthersAsTheyAreGiven)
{
  const TemporaryFolder folder;
  const auto in = [&](const std::string& name) {
    return (folder.path() / name).string();
  };
  writeFile(in("b.pcd"), pcdBytes({{1, 2, 3}}));
  writeFile(in("a.PCD"), pcdBytes({{1, 2, 3}, {1, 2, 4}}));
  writeFile(in("notes.txt"), "nothing");
  std::filesystem::create_directory(in("empty"));
  const auto inputs = findInputs({folder.path().string()});
  ASSERT_EQ(inputs.size(), 2u);
  EXPECT_EQ(inputs[0].path, in("a.PCD"));
  EXPECT_EQ(inputs[0].head.rows, 2u);
  EXPECT_TRUE(inputs[0].head.is_in_pieces);
  EXPECT_EQ(inputs[1].first, 2u);
  EXPECT_EQ(findInputs({in("b.pcd"), in("a.PCD")})[0].path, in("b.pcd"));
  EXPECT_THROW(findInputs({in("empty")}), ToolError);
  EXPECT_THROW(findInputs({in("c.pcd")}), ToolError);
  EXPECT_THROW(findInputs({in("notes.txt")}), ToolError);
}

} // namespace
