// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"
#include "sedr_surface/src/schedule/room_row.h"

#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_surface/floorplan_ifc.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(Schedules, HeadroomBelowASlopeIsInClosedForm)
{
  Floorplan plan;
  plan.rooms.push_back(roomOf(rectangle(0, 0, 4, 3), 0, 7));
  plan.rooms[0].name = "attic";
  plan.rooms[0].ceiling = slabAt(1, 0.5); // from 1 m at x = 0 to 3 m at x = 4
  const RoomRow row = roomRow(plan, CeilingFaces(plan.rooms[0]), "top", 24);
  EXPECT_EQ(row.id, 7U);
  EXPECT_EQ(row.name, "attic");
  EXPECT_EQ(row.storey, "top");
  EXPECT_NEAR(row.area, 12, 1e-9);
  EXPECT_NEAR(row.perimeter, 14, 1e-9);
  EXPECT_NEAR(row.area_2_0, 6, 0.1);
  EXPECT_NEAR(row.area_1_5, 9, 0.1);
  EXPECT_NEAR(row.lowest, 1, 1e-6);
  EXPECT_NEAR(row.highest, 3, 1e-6);
  EXPECT_DOUBLE_EQ(row.volume, 24);
  EXPECT_DOUBLE_EQ(row.measured, -1); // nothing was measured
}

TEST(Schedules, OpeningsHaveTheirMarkSizesAndHand)
{
  Floorplan plan;
  plan.rooms.push_back(roomOf(rectangle(0, 0, 4, 3), 2.5, 1));
  PlanOpening door;
  door.kind = OpeningKind::Door;
  door.number = 3;
  door.rooms = {1, 0};
  door.walls = {{1, 0}};
  door.start = {1, 0};
  door.end = {1.9, 0};
  door.bottom = 0.02;
  door.top = 2.05;
  plan.openings.push_back(door);
  PlanOpening window = door;
  window.kind = OpeningKind::Window;
  window.number = 1;
  window.bottom = 0.9;
  plan.openings.push_back(window);
  const std::vector<OpeningRow> rows = openingRows(plan);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].mark, "D3");
  EXPECT_EQ(rows[1].mark, "W1");
  EXPECT_NEAR(rows[0].width, 0.9, 1e-9);
  EXPECT_NEAR(rows[1].sill, 0.9, 1e-9);
  EXPECT_NEAR(rows[1].head(), 2.05, 1e-9);
  EXPECT_EQ(rows[0].rooms[0], 1U);
  EXPECT_EQ(leafOf(door), "");
  for (OpeningHinge hinge : {OpeningHinge::Start, OpeningHinge::End}) {
    PlanOpening hung = door;
    hung.hinge = hinge;
    hung.swing = 1;
    PlanOpening away = hung;
    away.swing = 0;
    EXPECT_NE(leafOf(hung), leafOf(away)); // seen from the other side
  }
}

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

TEST(Schedules, TablesHaveARowForEachOfTheirRows)
{
  Schedules schedules;
  schedules.rooms.resize(3);
  schedules.openings.resize(2);
  schedules.walls.resize(1);
  const std::vector<ScheduleTable> tables = tablesOf(schedules);
  ASSERT_EQ(tables.size(), 3U);
  const std::size_t rows[] = {3, 2, 1};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(tables[k].rows.size(), rows[k]) << tables[k].name;
    for (const auto& row : tables[k].rows)
      EXPECT_EQ(row.size(), tables[k].columns.size()) << tables[k].name;
  }
}

} // namespace
