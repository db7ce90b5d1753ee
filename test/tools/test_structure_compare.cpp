// SPDX-License-Identifier: BSD-3-Clause
#include "compare/change_mesh.h"
#include "compare/comparison.h"
#include "compare/plan_alignment.h"
#include "run_program.h"
#include "sample_files.h"

#include <pcl/sedr_filters/floorplan_io.h>

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace {

using namespace programs;
using namespace pcl::sedr;
using namespace pcl::sedr::tools;

PlanLoop
rectangle(double x0, double y0, double x1, double y1, bool clockwise = false)
{
  std::vector<Eigen::Vector2d> corners{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  if (clockwise)
    std::reverse(corners.begin(), corners.end());
  PlanLoop loop;
  for (std::size_t k = 0; k < 4; ++k) {
    PlanElement element;
    element.start = corners[k];
    element.end = corners[(k + 1) % 4];
    loop.elements.push_back(element);
  }
  return loop;
}

PlanSlab
slabAt(double height)
{
  PlanSlab slab;
  slab.plane[3] = -height;
  return slab;
}

PlanRoom
roomOf(std::uint32_t id, double x0, double y0, double x1, double y1)
{
  PlanRoom room;
  room.id = id;
  room.boundary = rectangle(x0, y0, x1, y1);
  room.floor = slabAt(0);
  room.ceiling = slabAt(2.8);
  return room;
}

/** Two rooms 4.5 m deep, 9 m long in total, with a partition of 10 cm between them. */
Floorplan
twoRooms(double partition = 5)
{
  return {{roomOf(1, 0, 0, partition, 4.5), roomOf(2, partition + 0.1, 0, 9, 4.5)}};
}

std::vector<std::string>
told(const Floorplan& before, const Floorplan& after)
{
  std::vector<std::string> lines;
  for (const auto& change : comparePlans(before, after, {}))
    lines.push_back(describe(change));
  return lines;
}

using Lines = std::vector<std::string>;

TEST(StructureCompare, TellsNothingOfWhatIsTheSame)
{
  EXPECT_EQ(told(twoRooms(), twoRooms()), Lines{});
  EXPECT_EQ(told(twoRooms(), twoRooms(5.04)), Lines{}) << "within the tolerance";
  Floorplan renumbered = twoRooms();
  std::swap(renumbered.rooms[0], renumbered.rooms[1]);
  renumbered.rooms[0].id = 1;
  renumbered.rooms[1].id = 2;
  EXPECT_EQ(told(twoRooms(), renumbered), Lines{});
}

TEST(StructureCompare, APartitionThatMovesIsOneThingAndLongerWallsAreNone)
{
  EXPECT_EQ(told(twoRooms(), twoRooms(5.3)),
            Lines{"moved partition by 0.30 m (x +0.30), 4.5 m: room_1_wall_2, "
                  "room_2_wall_4 -> room_1_wall_2, room_2_wall_4"});
}

TEST(StructureCompare, APartitionThatIsTakenOutOrPutIn)
{
  const Floorplan one{{roomOf(1, 0, 0, 9, 4.5)}};
  EXPECT_EQ(told(twoRooms(), one),
            Lines{"vanished partition, 4.5 m: room_1_wall_2, room_2_wall_4"});
  EXPECT_EQ(told(one, twoRooms()),
            Lines{"appeared partition, 4.5 m: room_1_wall_2, room_2_wall_4"});
}

TEST(StructureCompare, ANewPilasterIsOneThing)
{
  Floorplan after = twoRooms();
  auto& walls = after.rooms[0].boundary.elements;
  const std::vector<Eigen::Vector2d> corners{{2, 4.5}, {2, 4}, {1.5, 4}, {1.5, 4.5}};
  PlanElement rest = walls[2];
  rest.start = corners[3];
  walls[2].end = corners[0];
  for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
    PlanElement side;
    side.start = corners[k];
    side.end = corners[k + 1];
    walls.insert(walls.begin() + 3 + static_cast<std::ptrdiff_t>(k), side);
  }
  walls.insert(walls.begin() + 6, rest);
  EXPECT_EQ(
      told(twoRooms(), after),
      Lines{"appeared walls, 1.5 m: room_1_wall_4, room_1_wall_5, room_1_wall_6"});
}

TEST(StructureCompare, AWholeRoomIsToldWithoutItsWalls)
{
  Floorplan one = twoRooms();
  one.rooms.pop_back();
  EXPECT_EQ(told(twoRooms(), one), Lines{"vanished room, 17.55 m2: room_2"});
  EXPECT_EQ(told(one, twoRooms()), Lines{"appeared room, 17.55 m2: room_2"});
}

TEST(StructureCompare, Columns)
{
  Floorplan with = twoRooms();
  with.rooms[1].columns.push_back(rectangle(7, 2, 7.5, 2.4, true));
  EXPECT_EQ(told(twoRooms(), with), Lines{"appeared column, 0.20 m2: room_2_column_1"});
  EXPECT_EQ(told(with, twoRooms()), Lines{"vanished column, 0.20 m2: room_2_column_1"});
  Floorplan moved = twoRooms();
  moved.rooms[1].columns.push_back(rectangle(7.2, 1.9, 7.7, 2.3, true));
  EXPECT_EQ(told(with, moved),
            Lines{"moved column by 0.22 m (x +0.20, y -0.10), 0.20 m2: room_2_column_1 "
                  "-> room_2_column_1"});
  Floorplan grown = twoRooms();
  grown.rooms[1].columns.push_back(rectangle(6.98, 1.98, 7.52, 2.42, true));
  EXPECT_EQ(told(with, grown), Lines{}) << "at its place";
}

TEST(StructureCompare, DetailsOfCeilingAndFloor)
{
  Floorplan with = twoRooms();
  with.rooms[0].details.push_back({rectangle(0, 3.7, 5, 4.5), {}, slabAt(2.4)});
  EXPECT_EQ(told(with, twoRooms()), Lines{"vanished soffit, 4.00 m2: room_1_detail_1"});
  EXPECT_EQ(told(twoRooms(), with), Lines{"appeared soffit, 4.00 m2: room_1_detail_1"});
  Floorplan lower = with;
  lower.rooms[0].details[0].slab = slabAt(2.25);
  EXPECT_EQ(told(with, lower),
            Lines{"moved soffit by 0.15 m (z -0.15), 4.00 m2: room_1_detail_1 -> "
                  "room_1_detail_1"});
  Floorplan aside = twoRooms();
  aside.rooms[0].details.push_back({rectangle(0, 2.9, 5, 3.7), {}, slabAt(2.4)});
  EXPECT_EQ(told(with, aside),
            Lines{"moved soffit by 0.80 m (y -0.80), 4.00 m2: room_1_detail_1 -> "
                  "room_1_detail_1"});
  Floorplan step = twoRooms();
  step.rooms[1].floor_details.push_back({rectangle(7, 0, 9, 4.5), {}, slabAt(0.3)});
  EXPECT_EQ(told(twoRooms(), step),
            Lines{"appeared step, 9.00 m2: room_2_floor_detail_1"});
  Floorplan higher = twoRooms();
  higher.rooms[1].ceiling = slabAt(3);
  EXPECT_EQ(told(twoRooms(), higher),
            Lines{"moved ceiling by 0.20 m (z +0.20), 17.55 m2: room_2_ceiling -> "
                  "room_2_ceiling"});
}

TEST(StructureCompare, ARoundWallThatMoves)
{
  const auto apse = [](double radius) {
    Floorplan plan{{roomOf(1, 0, 0, 5, 4)}};
    auto& wall = plan.rooms[0].boundary.elements[1];
    wall.centre = {5 - std::sqrt(radius * radius - 4), 2};
    wall.radius = radius;
    return plan;
  };
  const auto changes = comparePlans(apse(2.5), apse(2.1), {});
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].what, "wall");
  EXPECT_EQ(changes[0].kind, ChangeKind::Moved);
  // From the depth of one arc, 1 m, to the depth of the other.
  EXPECT_NEAR(changes[0].shift.x(), (2.1 - std::sqrt(2.1 * 2.1 - 4)) - 1, 0.02);
}

TEST(PlanAlignment, FindsTheTurnAndTheShiftThoughThingsHaveChanged)
{
  PlanTransform truth;
  truth.angle = 4 * M_PI / 180;
  truth.shift = {0.25, -0.2, 0.15};
  Floorplan after = twoRooms(5.3);
  after.rooms[1].columns.push_back(rectangle(7, 2, 7.5, 2.4, true));
  const Floorplan rough = transformed(after, truth);
  EXPECT_GT(told(twoRooms(), rough).size(), 4u);
  const auto found = alignPlans(rough, twoRooms());
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->angle, -truth.angle, 1e-3);
  const Floorplan aligned = transformed(rough, *found);
  for (std::size_t r = 0; r < 2; ++r) {
    const Eigen::Vector2d corner =
        aligned.rooms[r].boundary.elements[r == 0 ? 0 : 1].start;
    EXPECT_LT((corner - Eigen::Vector2d(r == 0 ? 0 : 9, 0)).norm(), 0.01);
  }
  EXPECT_NEAR(aligned.rooms[0].ceiling.heightAt({1, 1}), 2.8, 1e-6);
  EXPECT_EQ(told(twoRooms(), aligned).size(), 2u) << "partition and column";
}

TEST(PlanAlignment, IsAsGoodFarFromTheOrigin)
{
  PlanTransform far;
  far.shift = {5000, 4000, 0};
  const Floorplan before = transformed(twoRooms(), far);
  PlanTransform turn;
  turn.angle = 5 * M_PI / 180;
  turn.shift = {5000.15, 3999.8, 0};
  const auto found = alignPlans(transformed(twoRooms(), turn), before);
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->angle, -turn.angle, 1e-6);
  EXPECT_LT(((*found)(turn({9, 0})) - Eigen::Vector2d(5009, 4000)).norm(), 1e-4);
}

TEST(PlanAlignment, OfPlansWithoutCommonWallsThereIsNone)
{
  EXPECT_FALSE(alignPlans(twoRooms(), {}).has_value());
  PlanTransform away;
  away.shift = {100, 0, 0};
  EXPECT_FALSE(alignPlans(transformed(twoRooms(), away), twoRooms()).has_value());
}

/** Runs the program on plans. */
class CompareTool : public ::testing::Test {
protected:
  std::string in(const std::string& name) const
  {
    return (folder_.path() / name).string();
  }

  std::string plan(const std::string& name, const Floorplan& plan) const
  {
    writeFile(in(name), floorplanToJson(plan));
    return in(name);
  }

  TemporaryFolder folder_;
};

TEST_F(CompareTool, WritesJsonAndAColouredMesh)
{
  Floorplan before = twoRooms();
  before.rooms[1].columns.push_back(rectangle(7, 2, 7.5, 2.4, true));
  const ProgramRun result =
      run(STRUCTURE_COMPARE, {plan("a.json", before), plan("b.json", twoRooms(5.3)),
                              "--mesh", in("d.ply"), "--json", in("d.json")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 2);
  const auto json = nlohmann::json::parse(bytesOf(in("d.json")));
  ASSERT_EQ(json.at("changes").size(), 2u);
  EXPECT_EQ(json.at("changes")[0].at("shift")[0], 0.3);
  const std::string ply = bytesOf(in("d.ply"));
  const std::size_t body = ply.find("end_header\n") + 11;
  const std::size_t count = static_cast<std::size_t>(
      std::stoul(ply.substr(ply.find("element vertex ") + 15)));
  std::map<int, std::size_t> reds; // the colours differ in red
  constexpr std::size_t row = 3 * 8 + 3;
  ASSERT_EQ(ply.size(), body + count * row + count / 3 * 13);
  for (std::size_t v = 0; v < count; ++v)
    ++reds[static_cast<unsigned char>(ply[body + v * row + 24])];
  EXPECT_EQ(reds[change_colours::vanished.red], 3u * 8) << "four faces of a column";
  EXPECT_EQ(reds[change_colours::moved.red], 3u * 4) << "both faces of the partition";
  EXPECT_EQ(reds[change_colours::appeared.red], 0u);
  EXPECT_EQ(reds[change_colours::unchanged.red], 3u * (2 * 12 - 4));
}

TEST_F(CompareTool, AStepIsNotPaintedAsTheFloorAroundItThatHasMoved)
{
  constexpr double step = 0.5;
  Floorplan before = twoRooms();
  before.rooms[0].floor_details.push_back({rectangle(1, 1, 3, 3), {}, slabAt(step)});
  Floorplan after = before;
  after.rooms[0].floor = slabAt(0.2);
  ASSERT_EQ(told(before, after),
            Lines{"moved floor by 0.20 m (z +0.20), 18.50 m2: room_1_floor -> "
                  "room_1_floor"});
  saveChangeMesh(in("d.ply"), before, after, comparePlans(before, after, {}));
  const std::string ply = bytesOf(in("d.ply"));
  const char* vertex = ply.data() + ply.find("end_header\n") + 11;
  std::size_t moved = 0;
  for (std::size_t left = std::stoul(ply.substr(ply.find("element vertex ") + 15));
       left > 0; --left, vertex += 3 * 8 + 3) {
    double z = 0;
    std::memcpy(&z, vertex + 2 * 8, sizeof z);
    if (static_cast<unsigned char>(vertex[3 * 8]) != change_colours::moved.red)
      continue;
    ++moved;
    EXPECT_NEAR(z, 0.2, 1e-6) << "on the floor, not on the step";
  }
  EXPECT_GT(moved, 0u);
}

TEST_F(CompareTool, TellsThatModelsFarApartCannotBeAligned)
{
  PlanTransform away;
  away.shift = {100, 0, 0};
  const ProgramRun result =
      run(STRUCTURE_COMPARE,
          {plan("a.json", twoRooms()), plan("b.json", transformed(twoRooms(), away)),
           "--align", "--json", in("d.json")});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_NE(result.err.find("cannot be aligned"), std::string::npos) << result.err;
  EXPECT_FALSE(std::filesystem::exists(in("d.json")));
}

TEST_F(CompareTool, RefusesWhatIsNoModel)
{
  const std::string good = plan("a.json", twoRooms());
  for (const std::string& bad : {in("missing.json"), folder_.path().string()}) {
    const ProgramRun result = run(STRUCTURE_COMPARE, {good, bad});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_TRUE(result.failsInOneSentence()) << result.err;
  }
  const ProgramRun folder = run(STRUCTURE_COMPARE, {good, folder_.path().string()});
  EXPECT_NE(folder.err.find("a scan is named by its file"), std::string::npos)
      << folder.err;
  EXPECT_EQ(run(STRUCTURE_COMPARE, {good}).exit_code, 1);
  EXPECT_EQ(run(STRUCTURE_COMPARE, {good, good, "--mesh", in("d.obj")}).exit_code, 1);
  const ProgramRun same = run(STRUCTURE_COMPARE, {good, good});
  EXPECT_EQ(same.exit_code, 0);
  EXPECT_EQ(same.out, "nothing has changed\n");
}

TEST_F(CompareTool, NamesExactlyWhatChangedBetweenTwoScans)
{
  for (const char* name : {"before", "after"})
    ASSERT_EQ(run(SIMULATE_INDOOR_SCAN,
                  {DOC_FOLDER + std::string("/scenes/office_") + name + ".json",
                   in(name), "--rays", "120000"})
                  .exit_code,
              0);
  const ProgramRun result =
      run(STRUCTURE_COMPARE,
          {in("before/scan.pcd"), in("after/scan.pcd"), "--json", in("changes.json")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto changes = nlohmann::json::parse(bytesOf(in("changes.json"))).at("changes");
  ASSERT_EQ(changes.size(), 3u) << result.out;
  EXPECT_EQ(changes[0].at("what"), "partition");
  EXPECT_EQ(changes[0].at("change"), "moved");
  const double turn = 20 * M_PI / 180;
  EXPECT_NEAR(changes[0].at("shift")[0].get<double>(), 0.3 * std::cos(turn), 0.01);
  EXPECT_NEAR(changes[0].at("shift")[1].get<double>(), 0.3 * std::sin(turn), 0.01);
  EXPECT_EQ(changes[1].at("what"), "column");
  EXPECT_EQ(changes[1].at("change"), "appeared");
  EXPECT_NEAR(changes[1].at("area").get<double>(), 0.35 * 0.35, 0.02);
  EXPECT_EQ(changes[2].at("what"), "soffit");
  EXPECT_EQ(changes[2].at("change"), "vanished");
}

/** The two rooms, and two above them with ids from 3. */
Floorplan
twoStoreys(double lower_partition = 5, double upper_partition = 5, double up = 3)
{
  Floorplan plan = twoRooms(lower_partition);
  for (PlanRoom& room : twoRooms(upper_partition).rooms) {
    room.id += 2;
    room.floor = slabAt(up);
    room.ceiling = slabAt(up + 2.5);
    plan.rooms.push_back(room);
  }
  return plan;
}

TEST(StoreysCompare, TheSameTwoStoreysHaveNoChanges)
{
  EXPECT_EQ(told(twoStoreys(), twoStoreys()), Lines{});
  EXPECT_EQ(told(twoStoreys(5, 4), twoStoreys(5, 4)), Lines{});
}

TEST(StoreysCompare, AWallOfTheOtherStoreyIsNoAnswer)
{
  EXPECT_EQ(told(twoStoreys(5, 4), twoStoreys(4, 4)),
            Lines{"moved partition by 1.00 m (x -1.00), 4.5 m: room_1_wall_2, "
                  "room_2_wall_4 -> room_1_wall_2, room_2_wall_4"});
  const Floorplan one{{roomOf(1, 0, 0, 9, 4.5)}};
  Floorplan before = twoStoreys(5, 4);
  before.rooms.erase(before.rooms.begin(), before.rooms.begin() + 2);
  before.rooms.push_back(one.rooms[0]); // no partition below the upper one
  EXPECT_EQ(told(before, twoStoreys(4, 4)),
            Lines{"appeared partition, 4.5 m: room_1_wall_2, room_2_wall_4"});
}

TEST(StoreysCompare, ARoomIsNotReplacedByOneThatLiesAboveIt)
{
  Floorplan upper = twoStoreys();
  upper.rooms.erase(upper.rooms.begin());
  EXPECT_EQ(told(twoStoreys(), upper), Lines{"vanished room, 22.50 m2: room_1"});
  upper = twoStoreys();
  upper.rooms.erase(upper.rooms.begin() + 2);
  EXPECT_EQ(told(twoStoreys(), upper), Lines{"vanished room, 22.50 m2: room_3"});
}

TEST(StoreysCompare, ColumnsAndSlabsOfEachStorey)
{
  Floorplan before = twoStoreys();
  before.rooms[1].columns.push_back(rectangle(7, 2, 7.5, 2.4, true));
  Floorplan after = twoStoreys();
  after.rooms[3].columns.push_back(rectangle(7, 2, 7.5, 2.4, true));
  EXPECT_EQ(told(before, after), (Lines{"vanished column, 0.20 m2: room_2_column_1",
                                        "appeared column, 0.20 m2: room_4_column_1"}));
  after = twoStoreys();
  after.rooms[2].ceiling = slabAt(5.4);
  EXPECT_EQ(told(twoStoreys(), after),
            Lines{"moved ceiling by 0.10 m (z -0.10), 22.50 m2: room_3_ceiling -> "
                  "room_3_ceiling"});
}

TEST(StoreysCompare, AnAlignmentDoesNotMixThem)
{
  // The walls of the storeys are 0.4 m apart: the wrong one's are within reach.
  const Floorplan plan = twoStoreys(5, 4.6);
  PlanTransform away;
  away.angle = 0.01;
  away.shift = {0.2, -0.1, 0.3};
  const auto found = alignPlans(transformed(plan, away), plan);
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->angle, -0.01, 1e-3);
  EXPECT_NEAR(found->shift.z(), -0.3, 1e-6);
  EXPECT_EQ(told(plan, transformed(transformed(plan, away), *found)), Lines{});
  // The floor of a single storey identifies it.
  Floorplan upper = plan;
  upper.rooms.erase(upper.rooms.begin(), upper.rooms.begin() + 2);
  const auto of_upper = alignPlans(transformed(upper, away), plan);
  ASSERT_TRUE(of_upper.has_value());
  EXPECT_NEAR(of_upper->shift.z(), -0.3, 1e-6);
}

} // namespace
