// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/runs/run_list.h"
#include "tool_error.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr::benchmark;
using pcl::sedr::tools::ToolError;

TEST(RunList, reads_lists)
{
  EXPECT_EQ(wordsOf("bls_room,my scene.json", "scenes"),
            (std::vector<std::string>{"bls_room", "my scene.json"}));
  EXPECT_EQ(noisesOf("0,0.001,2e-2", "noise"), (std::vector<double>{0, 0.001, 0.02}));
  EXPECT_EQ(seedsOf("1,42", "seeds"), (std::vector<std::uint64_t>{1, 42}));
}

TEST(RunList, refuses_what_is_no_list)
{
  for (const char* list : {"", "a,,b", "a,"})
    EXPECT_THROW(wordsOf(list, "scenes"), ToolError) << list;
  for (const char* list : {"", "x", "0.001;0.01", "-0.1", "2", "nan", "0.01x"})
    EXPECT_THROW(noisesOf(list, "noise"), ToolError) << list;
  for (const char* list : {"", "1.5", "-1", "one"})
    EXPECT_THROW(seedsOf(list, "seeds"), ToolError) << list;
  for (const char* part : {"", "1", "0/2", "3/2", "1/", "/2", "1/2/3", "a/b"})
    EXPECT_THROW(partOf(part, "part"), ToolError) << part;
}

TEST(RunList, parts_share_the_runs_without_overlap)
{
  for (std::size_t run = 0; run < 20; ++run) {
    int parts = 0;
    for (const char* part : {"1/3", "2/3", "3/3"})
      parts += partOf(part, "part").holds(run) ? 1 : 0;
    EXPECT_EQ(parts, 1) << run;
  }
  EXPECT_TRUE(partOf("1/3", "part").holds(0));
}

} // namespace
