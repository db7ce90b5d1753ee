// SPDX-License-Identifier: BSD-3-Clause
// What the program of a stage does beyond its class: rooms, options, and what it tells.
// The results of whole rooms are those of the stages one after another.
#include "plan_file.h"
#include "stage_tools.h"
#include "tool_error.h"

#include <utility>

namespace {

using namespace programs;
using pcl::sedr::tools::floatField;
using pcl::sedr::tools::ToolCloud;

using Numbers = std::vector<float>;
using Whole = std::vector<std::uint32_t>;

class StageTools : public StageToolRuns<> {
protected:
  /** Runs a tool on an ASCII PCD with the fields x y z label room intensity, and
   * expects it to succeed silently. */
  ToolCloud
  onPoints(const std::string& tool, const Strings& lines, const Strings& options = {})
  {
    std::string bytes =
        "FIELDS x y z label room intensity\nSIZE 4 4 4 1 2 8\nTYPE F F F U U F\n"
        "WIDTH " +
        std::to_string(lines.size()) + "\nDATA ascii\n";
    for (const auto& line : lines)
      bytes += line + "\n";
    const ProgramRun result = done(runOn({tool}, bytes, options));
    EXPECT_EQ(result.out + result.err, "") << "quiet when piped";
    return output();
  }

  pcl::sedr::PlanRoom fittedRoom(const Strings& options)
  {
    done(runOn({FLOORPLAN_FITTING, "output.json"}, scanOf().pcd(true), options));
    return pcl::sedr::tools::loadPlan(in("output.json")).plan.rooms.at(0);
  }
};

TEST_F(StageTools, TellWhatIsMissingOrLeavesNothing)
{
  const RoomScan scan = scanOf();
  RoomScan millimetres = scan;
  for (auto& p : millimetres.points) {
    p.x *= 1000;
    p.y *= 1000;
    p.z *= 1000;
  }
  const RoomScan walls =
      scan.without([](const auto& p) { return p.label != Label::Wall; });
  const RoomScan beside = scanOf({100, 0});
  const Tool planes{HORIZONTAL_PLANE_DETECTION};
  const Tool fitting{FLOORPLAN_FITTING, "output.json"};
  const Tool refinement{STRUCTURE_REFINEMENT, "output.pcd", true};
  const Tool repair{VERTICAL_HOLE_REPAIR, "output.pcd", true};
  const auto without = [&](Label label) { return scan.withoutLabel(label).pcd(true); };
  struct Case {
    Tool tool;
    std::string scan;
    std::string words;
    Strings options{};
  };
  for (const Case& c : std::vector<Case>{
           {{PARALLEL_VOXEL_GRID}, scan.pcd(true), "", {"--min-points", "100000"}},
           {{ROOM_SEGMENTATION},
            scan.pcd(false),
            "50.0 square metres",
            {"--min-area", "50"}},
           {planes, without(Label::Ceiling), "0 are ceilings"},
           {planes, without(Label::Floor), "0 floors"},
           {planes, walls.pcd(false), "horizontal plane"},
           {planes, scan.pcd(false), "50", {"--min-area", "50"}},
           {planes, millimetres.pcd(false), "millimetre"},
           {{GRID_SLICE_DETAIL}, without(Label::Ceiling), "label 1, ceiling"},
           {{GRID_SLICE_DETAIL}, without(Label::Floor), "label 2, floor"},
           {{CEILING_BOUNDARY_WALL_GROWING}, without(Label::Ceiling), "ceiling"},
           {{CEILING_BOUNDARY_WALL_GROWING},
            scan.withoutLabel(Label::Wall).withoutLabel(Label::Other).pcd(true),
            ""},
           {fitting, without(Label::Ceiling), "label 1, ceiling"},
           {fitting, without(Label::Floor), "label 2, floor"},
           {fitting, without(Label::Wall), "label 3, wall"},
           {refinement, beside.pcd(true), "none of the"},
           {refinement, scan.pcd(false), "none of the"},
           {repair, beside.pcd(true), "none of the"},
           {repair, scan.pcd(false), "none of the"},
           {{STRUCTURAL_POISSON, "output.ply"}, scan.pcd(true), "has no normals"}}) {
    SCOPED_TRACE(::testing::Message() << c.tool << ": " << c.words);
    expectFailure(runOn(c.tool, c.scan, c.options), 2, c.words);
  }
}

TEST_F(StageTools, RefusePlansThatAreNone)
{
  const std::string good = pcl::sedr::floorplanToJson({{planOf(BoxRoom())}});
  for (const auto& [bytes, words] :
       {std::pair<std::string, std::string>("no plan at all", "plan.json"),
        {std::string(1000, '\0'), "plan.json"},
        {"{}", "plan.json"},
        {"[1, 2]", "plan.json"},
        {good.substr(0, good.size() / 2), "plan.json"},
        {"", "plan.json"},
        {"VERSION .7\nFIELDS x y z\n", "a floor plan is asked for"},
        {pcl::sedr::floorplanToJson({}), "no rooms"}}) {
    writeFile(in("input_plan.json"), bytes);
    for (const Tool& tool : stageTools())
      if (tool.takes_plan && (tool.program == VERTICAL_HOLE_REPAIR || bytes.empty()))
        expectFailure(runOn(tool, scanOf().pcd(true)), words == "no rooms" ? 2 : 1,
                      words);
  }
}

TEST_F(StageTools, KeepTheFieldsOfAllPoints)
{
  const RoomScan scan = scanOf();
  for (const char* tool :
       {ROOM_SEGMENTATION, HORIZONTAL_PLANE_DETECTION, GRID_REGION_OUTLIER_REMOVAL,
        GRID_SLICE_DETAIL, FLOOR_PROJECTION_RECOVERY, CEILING_BOUNDARY_WALL_GROWING}) {
    done(runOn({tool}, scan.pcd(true)));
    const Numbers intensity = floatField(output().blob, "intensity");
    ASSERT_GE(intensity.size(), scan.points.size()) << tool;
    for (std::size_t i = 0; i < scan.points.size(); ++i)
      ASSERT_EQ(intensity[i], static_cast<float>(i)) << tool;
  }
}

TEST_F(StageTools, VoxelGridTakesItsOptions)
{
  const Strings points{"0.01 0 0 1 0 1", "0.2 0 0 1 0 2", "0.3 0 0 2 0 3",
                       "5 0 0 1 0 4"};
  const ToolCloud cloud =
      onPoints(PARALLEL_VOXEL_GRID, points, {"--leaf", "1", "--min-points", "2"});
  EXPECT_EQ(floatField(cloud.blob, "intensity"), (Numbers{2}));
}

TEST_F(StageTools, PlaneDetectionListsPlanesForgetsRoomsAndDoubtsTheAxis)
{
  RoomScan scan = scanOfRooms({{0, 0, 6, 5}, {0, 5.11, 4, 3}, {4.13, 5.11, 5, 4.27}});
  const auto detect = [&](const Strings& options = {}) {
    return runOn({HORIZONTAL_PLANE_DETECTION}, scan.pcd(true), options);
  };
  const ProgramRun result = detect();
  EXPECT_EQ(result.out.rfind("kind ", 0), 0u) << "a heading:\n" << result.out;
  EXPECT_TRUE(says(result.out, "ceiling     2.500", "floor       0.000"));
  EXPECT_EQ(output().room[0], 0u);
  for (auto& p : scan.points)
    std::swap(p.y, p.z);
  EXPECT_TRUE(says(detect().err, "y seems to be up"));
  EXPECT_FALSE(says(detect({"--z-up"}).err, "y seems to be up"));
}

TEST_F(StageTools, OutlierRemovalNumbersRoomsAndRemovesRowsIfAsked)
{
  // Ceilings of 6 x 6 and 5 x 5 cells of 1 m, an outlier, and a floor point, which this
  // tool ignores.
  Strings lines{"40.5 40.5 2.5 1 9 0"};
  for (const auto& [start, size] : {std::pair(0, 6), {10, 5}})
    for (int k = 0; k < size * size; ++k)
      lines.push_back(std::to_string(start + k % size) + ".5 " +
                      std::to_string(k / size) + ".5 2.5 1 9 " +
                      std::to_string(lines.size()));
  lines.push_back("40.5 40.5 0 2 8 100");
  const ToolCloud cloud = onPoints(GRID_REGION_OUTLIER_REMOVAL, lines, {"--grid", "1"});
  ASSERT_EQ(cloud.size(), 63u);
  for (const auto& [row, label, room] :
       {std::tuple(0u, 0u, 0u), {1u, 1u, 1u}, {61u, 1u, 2u}, {62u, 2u, 8u}}) {
    EXPECT_EQ(cloud.label[row], label) << row;
    EXPECT_EQ(cloud.room[row], room) << row;
  }
  const ToolCloud kept =
      onPoints(GRID_REGION_OUTLIER_REMOVAL, lines, {"--grid", "1", "--remove"});
  ASSERT_EQ(kept.size(), 62u);
  EXPECT_EQ(floatField(kept.blob, "intensity")[0], 1.f);
}

TEST_F(StageTools, FloorRecoveryFillsEveryRoomAtItsOwnHeight)
{
  const ToolCloud cloud =
      onPoints(FLOOR_PROJECTION_RECOVERY,
               {"0.5 0.5 2.5 1 1 11", // room 1: three cells of ceiling, of floor two
                "1.5 0.5 2.5 1 1 12", "2.5 0.5 2.5 1 1 13", "0.5 0.4 0.1 2 0 14",
                "1.5 0.4 0.3 2 0 15",
                "10.5 0.5 3 1 2 21", // room 2, lower, and a soffit beside its ceiling
                "11.5 0.5 2 4 0 22", "10.5 0.4 -1 2 2 23",
                "30.5 0.5 0 2 0 31", // outside
                "5.5 0.5 1 3 0 41"}, // a wall
               {"--grid", "1"});
  ASSERT_EQ(cloud.size(), 12u);
  EXPECT_EQ(cloud.label, (Whole{1, 1, 1, 2, 2, 1, 4, 2, 0, 3, 2, 2}));
  EXPECT_EQ(cloud.room, (Whole{1, 1, 1, 1, 1, 2, 2, 2, 0, 0, 1, 2}));
  EXPECT_EQ(floatField(cloud.blob, "intensity")[10], 13.f)
      << "fields of the source survive";
  EXPECT_EQ(floatField(cloud.blob, "intensity")[11], 22.f);
  EXPECT_FLOAT_EQ((*cloud.points)[10].z, 0.2f);
  EXPECT_EQ((*cloud.points)[11].z, -1.f);
  EXPECT_EQ((*cloud.points)[11].x, 11.5f);
  const ToolCloud other =
      onPoints(FLOOR_PROJECTION_RECOVERY, {"0.5 0.5 2.5 1 0 1", "30.5 0.5 -0.5 2 0 2"},
               {"--grid", "1", "--remove"});
  EXPECT_EQ(other.label, (Whole{1, 2}));
  EXPECT_EQ((*other.points)[1].z, -0.5f) << "at the height of other floors";
  EXPECT_EQ(floatField(other.blob, "intensity"), (Numbers{1, 1}));
}

TEST_F(StageTools, SliceDetailLeavesATableThatIsLabelledFloor)
{
  const RoomScan scan = scanOf();
  RoomScan input = scan;
  for (auto& p : input.points)
    if (p.label == Label::Other && p.z < 0.76f && p.z > 0.74f)
      p.label = Label::Floor;
  done(runOn({GRID_SLICE_DETAIL}, input.pcd(true)));
  const std::vector<std::uint32_t> labels = output().label;
  for (std::size_t i = 0; i < labels.size(); ++i)
    ASSERT_FALSE(labels[i] == 2 && scan.points[i].label == Label::Other) << i;
}

/** Lines of 21 x 21 points over 2 m x 2 m. */
Strings
slab(double x, double z, const std::string& label_and_room)
{
  Strings lines;
  for (int i = 0; i < 441; ++i)
    lines.push_back(std::to_string(x + 0.1 * (i % 21)) + ' ' +
                    std::to_string(0.1 * (i / 21)) + ' ' + std::to_string(z) + ' ' +
                    label_and_room + " 0");
  return lines;
}

TEST_F(StageTools, WallGrowingGivesSharedPointsToTheNearerRoomAndSlicesBelowDetails)
{
  const auto grown = [&](std::initializer_list<Strings> parts) {
    Strings lines;
    for (const Strings& part : parts)
      lines.insert(lines.end(), part.begin(), part.end());
    const ToolCloud cloud = onPoints(CEILING_BOUNDARY_WALL_GROWING, lines);
    const auto first =
        static_cast<std::ptrdiff_t>(lines.size() - parts.end()[-1].size());
    return std::pair(Whole(cloud.label.begin() + first, cloud.label.end()),
                     Whole(cloud.room.begin() + first, cloud.room.end()));
  };
  const auto [labels, rooms] =
      grown({slab(0, 2.5, "1 1"),
             slab(2.1, 2.5, "1 2"),             // behind a wall of 10 cm
             {"2.03 1 1 0 0 0",                 // its face in room 1
              "2.07 1 1 0 0 0",                 // its face in room 2
              "2.03 1 2 0 2 0",                 // said to be of room 2
              "-0.05 1 1 3 1 0", "1 1 1 3 1 0", // labelled wall
              "-0.05 1 2 5 1 0"}});
  EXPECT_EQ(labels, (Whole{3, 3, 3, 3, 0, 5}));
  EXPECT_EQ(rooms, (Whole{1, 2, 1, 1, 1, 1}));
  const Whole below = grown({slab(0, 2.5, "1 0"),
                             slab(2.1, 2, "4 0"),
                             slab(0, 0, "2 0"),
                             slab(2.1, 0, "2 0"),
                             {"2.05 1 2.2 0 0 0", // at the riser of the soffit
                              "2.05 1 1.9 0 0 0", // below the riser is air, not wall
                              "4.15 1 1.9 0 0 0"}})
                          .first;
  EXPECT_EQ(below, (Whole{3, 0, 3}));
}

TEST_F(StageTools, FloorplanFittingFollowsTheRawScan)
{
  // A raw scan 6 mm higher and 5 mm aside of the labelled points.
  RoomScan raw = scanOf();
  for (auto& p : raw.points) {
    p.x += 0.005F;
    p.z += 0.006F;
  }
  writeFile(in("raw.pcd"), raw.pcd(false));
  const pcl::sedr::PlanRoom found = fittedRoom({});
  const pcl::sedr::PlanRoom fitted = fittedRoom({"--raw", in("raw.pcd")});
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(fitted.boundary.elements[i].start.x(),
                found.boundary.elements[i].start.x() + 0.005, 0.001);
  const Eigen::Vector2d middle(2, 0);
  EXPECT_NEAR(fitted.floor.heightAt(middle), 0.006, 0.0005);
  EXPECT_NEAR(fitted.ceiling.heightAt(middle), 2.506, 0.0005);
  expectSentence(runOn({FLOORPLAN_FITTING, "output.json"}, scanOf().pcd(true),
                       {"--raw", in("none.pcd")}),
                 1, "none.pcd");
}

TEST_F(StageTools, RefinementLeavesPointsOutThatAreTooFarFromTheirSurface)
{
  RoomScan scan =
      scanOf().without([](const RoomPoint& p) { return p.label != Label::Wall; });
  const std::size_t walls = scan.points.size();
  const auto y = static_cast<float>(BoxRoom().y);
  scan.points.push_back({1.5f, y + 0.1f, 1.f, Label::Wall, 1});
  scan.points.push_back({1.5f, y + 0.2f, 1.f, Label::Wall, 1});
  scan.points.push_back({1.5f, y, 1.f, Label::Wall, 2}); // the plan has no room 2
  scan.points.push_back({1.5f, std::nanf(""), 1.f, Label::Wall, 1});
  const auto size = [&](const Strings& options) {
    const Tool tool{STRUCTURE_REFINEMENT, "output.pcd", true};
    done(runOn(tool, scan.pcd(true), options));
    return output().size();
  };
  EXPECT_EQ(size({}), walls + 1);
  EXPECT_EQ(size({"--max-distance", "0.05"}), walls);
}

} // namespace
