// SPDX-License-Identifier: BSD-3-Clause

#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_surface/floorplan_ifc.h>

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;

TEST(Schedules, CsvQuotesWhatNeedsIt)
{
  const ScheduleTable table{"rooms",
                            {"id", "name"},
                            {{"1", "hall"}, {"2", "Bad, \"blau\""}}};
  EXPECT_EQ(csvOf(table), "id,name\r\n1,hall\r\n2,\"Bad, \"\"blau\"\"\"\r\n");
  const ScheduleTable formulas{"rooms",
                               {"a", "b"},
                               {{"=1+2", "-0.250"}, {"@SUM(A1)", ""}}};
  EXPECT_EQ(csvOf(formulas), "a,b\r\n'=1+2,-0.250\r\n'@SUM(A1),\r\n");
}

} // namespace
