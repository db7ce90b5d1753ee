// SPDX-License-Identifier: BSD-3-Clause
#include "las_writer.h"
#include "tagged_scan.h"
#include "tool_cloud.h"
#include "tool_error.h"
#include "tools/sedr_tool_runs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace {

using namespace programs;
using namespace pcl::sedr::tools;

template <typename T>
T
at(const std::string& bytes, std::size_t place)
{
  T value{};
  std::memcpy(&value, &bytes.at(place), sizeof value);
  return value;
}

/** A scan of a room in a national grid, in steps that floats do not have there. */
LasSample
inGrid(const RoomScan& scan)
{
  LasSample las;
  las.minor = 4;
  las.format = 7;
  las.record = 36;
  las.colour_offset = 30;
  las.colour = {0x1234, 0x5678, 0x9abc};
  las.intensity = 321;
  las.scale = {0.0005, 0.0005, 0.0005};
  las.shift = {691000, 5335000, 500};
  const auto steps = [](double length) {
    return static_cast<std::int32_t>(std::lround(length / 0.0005));
  };
  for (const RoomPoint& p : scan.points)
    las.points.push_back({steps(p.x + 500), steps(p.y + 900), steps(p.z)});
  return las;
}

using ClassifiedScan = SedrTool;

TEST_F(ClassifiedScan, OfLasHasAllPointsInTheirOrderAndPlacesWithClassAndExtraBytes)
{
  const RoomScan scan = scanOf();
  const LasSample las = inGrid(scan);
  writeFile(in("scan.las"), las.bytes());
  const ProgramRun result = run(SEDR, {in("scan.las"), in("model")},
                                {"--no-mesh", "--classified", in("out.las")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string bytes = bytesOf(in("out.las"));
  const auto begin = at<std::uint32_t>(bytes, 96);
  const auto record = at<std::uint16_t>(bytes, 105);
  EXPECT_EQ(bytes.substr(0, 4), "LASF");
  EXPECT_EQ(bytes[25], 4);
  EXPECT_EQ(bytes[104], 7);
  EXPECT_EQ(record, 36 + 1 + 2 + 2);
  EXPECT_EQ(begin, 375u + 54 + 3 * 192);
  EXPECT_EQ(at<std::uint64_t>(bytes, 247), scan.points.size());
  EXPECT_EQ(bytes.size(), begin + record * scan.points.size());
  EXPECT_EQ(bytes.substr(375 + 2, 9), "LASF_Spec");
  EXPECT_EQ(at<std::uint16_t>(bytes, 375 + 18), 4u) << "extra bytes";
  const std::size_t descriptor = 375 + 54;
  for (const auto& [k, name, type] :
       {std::make_tuple(0, "label", 1), {1, "room", 3}, {2, "owner", 3}}) {
    EXPECT_EQ(bytes[descriptor + 192 * k + 2], type);
    EXPECT_STREQ(&bytes[descriptor + 192 * k + 4], name);
  }
  EXPECT_STREQ(&bytes[descriptor + 160], "1ceil 2floor 3wall 4detail 5col");
  std::size_t right = 0;
  std::size_t furniture = 0;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const std::size_t p = begin + i * record;
    ASSERT_EQ((at<std::array<std::int32_t, 3>>(bytes, p)), las.points[i]) << i;
    ASSERT_EQ(at<std::uint16_t>(bytes, p + 12), 321u);
    ASSERT_EQ(bytes[p + 31], 0x12) << "the upper byte of red";
    const auto label = static_cast<Label>(bytes[p + 36]);
    const int of_label = label == Label::Floor ? 2 : label == Label::Other ? 1 : 6;
    ASSERT_EQ(bytes[p + 16], of_label);
    ASSERT_EQ(at<std::uint16_t>(bytes, p + 37), label == Label::Other ? 0 : 1);
    right += label == scan.points[i].label ? 1 : 0;
    if (scan.points[i].label == Label::Other && label == Label::Other)
      furniture += at<std::uint16_t>(bytes, p + 39) == 1 ? 1 : 0;
  }
  EXPECT_GT(static_cast<double>(right), 0.9 * static_cast<double>(scan.points.size()));
  EXPECT_GT(furniture, 1000u) << "stands in the room, which owns it";
  EXPECT_NEAR(at<double>(bytes, 187), 691500.37, 0.01) << "least x";
  EXPECT_EQ(ScanFile(in("out.las")).size(), scan.points.size()) << "is read again";
}

TEST_F(ClassifiedScan, OfPcdHasTheFieldsOfTheScanAndThree)
{
  const RoomScan scan = scanOf();
  writeFile(in("input.pcd"), scan.pcd(true));
  const ProgramRun result = run(SEDR, {in("input.pcd"), in("model")},
                                {"--no-mesh", "--classified", in("out.pcd")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const ToolCloud cloud = loadCloud(in("out.pcd"));
  ASSERT_EQ(cloud.size(), scan.points.size());
  const std::vector<float> numbers = floatField(cloud.blob, "intensity");
  const std::vector<std::uint32_t> owners = wholeField(cloud.blob, "owner");
  std::size_t right = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    ASSERT_EQ(numbers[i], static_cast<float>(i));
    ASSERT_EQ((*cloud.points)[i].x, scan.points[i].x);
    ASSERT_LE(owners[i], 1u);
    right += cloud.label[i] == static_cast<std::uint32_t>(scan.points[i].label) ? 1 : 0;
  }
  EXPECT_GT(static_cast<double>(right), 0.9 * static_cast<double>(cloud.size()));
}

TEST_F(ClassifiedScan, OfSeveralFilesHasThemOneBehindTheOther)
{
  RoomScan first = scanOf();
  RoomScan second = first;
  const std::size_t half = first.points.size() / 2;
  first.points.resize(half);
  second.points.erase(second.points.begin(),
                      second.points.begin() + static_cast<std::ptrdiff_t>(half));
  second.points.front().x = NAN;
  writeFile(in("a.pcd"), first.pcd(false));
  writeFile(in("b.pcd"), second.pcd(false));
  const ProgramRun result = run(SEDR, {in("a.pcd"), in("b.pcd"), in("model")},
                                {"--no-mesh", "--classified", in("out.las")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.err.find("1 points without coordinates"), std::string::npos)
      << result.err;
  const std::string bytes = bytesOf(in("out.las"));
  EXPECT_EQ(bytes[104], 6) << "no colours";
  ASSERT_EQ(at<std::uint64_t>(bytes, 247), half + second.points.size() - 1);
  const ToolCloud cloud = loadCloud(in("out.las"));
  EXPECT_NEAR((*cloud.points)[half - 1].y, first.points.back().y, 6e-5);
  EXPECT_NEAR((*cloud.points)[half].y, second.points[1].y, 6e-5);
}

TEST_F(ClassifiedScan, OfLasRefusesRoomsAndPlacesBeyondItsIntegers)
{
  RoomScan scan = scanOf();
  const auto refusal = [&](std::uint32_t room) -> std::string {
    writeFile(in("input.pcd"), scan.pcd(false));
    const auto tag_of = [&](const Eigen::Vector3f&) { return PointTag{3, 1, room}; };
    try {
      saveTagged(in("out.las"), JointScan({in("input.pcd")}, {}), tag_of, 0);
      return {};
    }
    catch (const ToolError& error) {
      return error.what();
    }
  };
  EXPECT_EQ(refusal(65535), "");
  EXPECT_NE(refusal(65536).find("room 65536 has no number of 16 bits"),
            std::string::npos);
  scan.points.front().x = 0;
  scan.points.back().x = -250000; // in steps of 0.1 mm
  EXPECT_NE(refusal(1).find("in steps of 0.0001 reaches 214748 units of the scan from "
                            "x = 0, but a point is at -250000"),
            std::string::npos)
      << refusal(1);
}

TEST_F(ClassifiedScan, DoesNotReplaceTheScan)
{
  const std::string bytes = scanOf().pcd(false);
  writeFile(in("input.pcd"), bytes);
  for (const char* name : {"input.pcd", "out.laz", "no_folder/out.las"})
    expectFailure(run(SEDR, {in("input.pcd"), in("model")},
                      {"--no-mesh", "--classified", in(name)}),
                  1, "'");
  EXPECT_EQ(bytesOf(in("input.pcd")), bytes);
}

} // namespace
