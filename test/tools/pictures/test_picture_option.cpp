// SPDX-License-Identifier: BSD-3-Clause
#include "pictures.h"
#include "tools/box_room.h"
#include "tools/in_folder.h"
#include "tools/sample_files.h"

#include <pcl/sedr_filters/floorplan_io.h>

#include <gtest/gtest.h>

#include <filesystem>

namespace {

using namespace programs;

/** The program of a stage; its second file may be a plan. */
struct Stage {
  std::string program;
  std::string output;
  bool takes_plan;
};

std::ostream&
operator<<(std::ostream& stream, const Stage& stage)
{
  return stream << std::filesystem::path(stage.program).filename();
}

/** The requirements for --picture of every stage. */
class PictureOption : public InFolder<::testing::TestWithParam<Stage>> {
protected:
  /** Runs the stage on the scan of a room, with labels, rooms and normals. */
  ProgramRun draw(const std::string& picture)
  {
    RoomScan scan = scanOf();
    writeFile(in("input.pcd"), scan.pcd(true));
    writeFile(in("plan.json"), pcl::sedr::floorplanToJson({{planOf(BoxRoom())}}));
    std::vector<std::string> arguments{in("input.pcd")};
    if (GetParam().takes_plan)
      arguments.push_back(in("plan.json"));
    arguments.insert(arguments.end(), {in(GetParam().output), "--picture", picture});
    return run(GetParam().program, arguments);
  }
};

TEST_P(PictureOption, WritesAPngThatIsTheSameEveryTime)
{
  const ProgramRun first = draw(in("picture.png"));
  ASSERT_EQ(first.exit_code, 0) << first.err;
  EXPECT_EQ(first.err, "") << "quiet when piped";
  EXPECT_TRUE(std::filesystem::exists(in(GetParam().output)));
  const std::string bytes = bytesOf(in("picture.png"));
  const Image image = imageOf(bytes);
  EXPECT_GT(image.width, 400);
  EXPECT_LE(image.width, 1200);
  EXPECT_GT(image.height, 200);
  const auto blank =
      std::count(image.pixels.begin(), image.pixels.end(), colours::paper);
  EXPECT_LT(static_cast<double>(blank),
            0.97 * static_cast<double>(image.pixels.size()));
  ASSERT_EQ(draw(in("picture.png")).exit_code, 0);
  EXPECT_TRUE(bytesOf(in("picture.png")) == bytes);
}

TEST_P(PictureOption, IsRefusedBeforeTheWorkWhereItCannotBeWritten)
{
  const std::string path = in("missing/picture.png");
  const ProgramRun result = draw(path);
  expectSentence(result, 1, path);
  EXPECT_FALSE(std::filesystem::exists(in(GetParam().output)));
}

TEST(OpeningPictureOption, IsDrawnOrRefusedBeforeTheWork)
{
  const TemporaryFolder folder;
  const auto in = [&](const std::string& name) {
    return (folder.path() / name).string();
  };
  writeFile(in("scan.pcd"), scanOf().pcd(true));
  writeFile(in("plan.json"), pcl::sedr::floorplanToJson({{planOf(BoxRoom())}}));
  const auto draw = [&](const std::string& output, const std::string& picture) {
    return run(OPENING_DETECTION,
               {in("scan.pcd"), in("plan.json"), in(output), "--picture", in(picture)});
  };
  const ProgramRun drawn = draw("found.json", "maps.png");
  ASSERT_EQ(drawn.exit_code, 0) << drawn.err;
  EXPECT_GT(imageOf(bytesOf(in("maps.png"))).width, 100);
  EXPECT_EQ(draw("other.json", "missing/maps.png").exit_code, 1);
  EXPECT_FALSE(std::filesystem::exists(in("other.json")));
}

INSTANTIATE_TEST_SUITE_P(
    Stages,
    PictureOption,
    ::testing::Values(Stage{PARALLEL_VOXEL_GRID, "output.pcd", false},
                      Stage{ROOM_SEGMENTATION, "output.pcd", false},
                      Stage{HORIZONTAL_PLANE_DETECTION, "output.pcd", false},
                      Stage{GRID_REGION_OUTLIER_REMOVAL, "output.pcd", false},
                      Stage{GRID_SLICE_DETAIL, "output.pcd", false},
                      Stage{FLOOR_PROJECTION_RECOVERY, "output.pcd", false},
                      Stage{CEILING_BOUNDARY_WALL_GROWING, "output.pcd", false},
                      Stage{FLOORPLAN_FITTING, "output.json", false},
                      Stage{STRUCTURE_REFINEMENT, "output.pcd", true},
                      Stage{VERTICAL_HOLE_REPAIR, "output.pcd", true}));

} // namespace
