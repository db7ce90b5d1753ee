// SPDX-License-Identifier: BSD-3-Clause
#include "las_writer.h"
#include "tagged_scan.h"
#include "tool_cloud.h"
#include "tool_error.h"
#include "tools/sedr_tool_runs.h"

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
  done(run(SEDR, {in("scan.las"), in("model")},
           {"--no-mesh", "--classified", in("out.las")}));
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

/** A record that describes the points of a LAS file. */
std::string
lasRecord(const std::string& user, std::uint16_t id, const std::string& data)
{
  std::string bytes(54, '\0');
  bytes.replace(2, user.size(), user);
  const std::array<std::uint16_t, 2> numbers{id,
                                             static_cast<std::uint16_t>(data.size())};
  bytes.replace(18, 4, reinterpret_cast<const char*>(numbers.data()), 4);
  return bytes + data;
}

/** A LAS file with times, returns, flags, a coordinate system and two bytes a point
 * that nothing describes. */
std::string
fullLas(std::uint8_t minor, std::uint8_t format, std::uint16_t record)
{
  LasSample las;
  las.minor = minor;
  las.format = format;
  las.record = static_cast<std::uint16_t>(record + 2);
  las.before = lasRecord("LASF_Projection", 34735, "keys") +
               lasRecord("LASF_Projection", 2112, "PROJCS[]");
  for (int i = 0; i < 5000; ++i)
    las.points.push_back({i, 2 * i, -i});
  std::string bytes = las.bytes();
  bytes.replace(6, 2, {17, 0}); // times since 1980, and WKT
  bytes.replace(100, 1, {2});
  const std::size_t begin = at<std::uint32_t>(bytes, 96);
  for (std::size_t k = begin; k < bytes.size(); ++k)
    if ((k - begin) % las.record >= 12)
      bytes[k] = static_cast<char>((k * 2654435761U) >> 7);
  if (minor == 4) { // a record behind the points
    const std::uint64_t end = bytes.size();
    bytes.replace(235, 8, reinterpret_cast<const char*>(&end), 8);
    bytes.replace(243, 1, {1});
    bytes += "behind";
  }
  return bytes;
}

TEST_F(ClassifiedScan, OfLasKeepsAllThatTheScanHas)
{
  const auto tag_of = [](const Eigen::Vector3f& p) {
    return PointTag{p.z() > -1 ? 2U : 3U, 7, 8};
  };
  for (const auto& [minor, format, record] :
       {std::make_tuple(2, 1, 28), {2, 3, 34}, {4, 6, 30}, {4, 7, 36}}) {
    const std::string in_bytes = fullLas(minor, format, record);
    writeFile(in("scan.las"), in_bytes);
    saveTagged(in("out.las"), JointScan({in("scan.las")}, {}), tag_of, 0);
    const std::string bytes = bytesOf(in("out.las"));
    EXPECT_EQ(bytes.substr(0, 94), in_bytes.substr(0, 94)) << "version, encoding";
    EXPECT_EQ(bytes[104], format);
    const std::size_t first = at<std::uint16_t>(bytes, 94);
    const std::size_t described = 54 + 4 + 54 + 8;
    EXPECT_EQ(bytes.substr(first, described), in_bytes.substr(first, described));
    EXPECT_EQ(at<std::uint32_t>(bytes, 100), 3u);
    EXPECT_EQ(bytes[first + described + 54 + 2], 0) << "two bytes without a name";
    EXPECT_EQ(bytes[first + described + 54 + 3], 2);
    EXPECT_STREQ(&bytes[first + described + 54 + 192 + 4], "label");
    const std::size_t size = record + 2;
    const std::size_t from = at<std::uint32_t>(in_bytes, 96);
    const std::size_t to = at<std::uint32_t>(bytes, 96);
    std::array<std::uint64_t, 15> returns{};
    for (std::size_t i = 0; i < 5000; ++i) {
      std::string point = in_bytes.substr(from + i * size, size);
      const int kind = i < 1000 ? 2 : 6;
      ++returns[std::max(1, point[14] & (format < 6 ? 7 : 15)) - 1];
      point[format < 6 ? 15 : 16] =
          static_cast<char>(kind | (format < 6 ? point[15] & 0xe0 : 0));
      ASSERT_EQ(bytes.substr(to + i * (size + 5), size + 5),
                point + (kind == 2 ? "\2" : "\3") + std::string("\7\0\10\0", 4))
          << i;
    }
    EXPECT_EQ(at<double>(bytes, 179 + 8), 0) << "least x";
    EXPECT_NEAR(at<double>(bytes, 179), 4.999, 1e-9);
    EXPECT_NEAR(at<double>(bytes, 179 + 5 * 8), -4.999, 1e-9) << "least z";
    if (format < 6) {
      EXPECT_EQ(at<std::uint32_t>(bytes, 107), 5000u);
      EXPECT_EQ(at<std::uint32_t>(bytes, 115), returns[1]);
    }
    else {
      EXPECT_EQ((at<std::array<std::uint64_t, 15>>(bytes, 255)), returns);
      EXPECT_EQ(bytes.substr(at<std::uint64_t>(bytes, 235)), "behind");
    }
    // Once more: the tags are replaced; two files: one behind the other.
    saveTagged(in("again.las"), JointScan({in("out.las")}, {}), tag_of, 0);
    EXPECT_EQ(bytesOf(in("again.las")), bytes);
    saveTagged(in("both.las"), JointScan({in("scan.las"), in("scan.las")}, {}), tag_of,
               0);
    const std::string both = bytesOf(in("both.las"));
    EXPECT_EQ(both.substr(to, 10000 * (size + 5)),
              bytes.substr(to, 5000 * (size + 5)) +
                  bytes.substr(to, 5000 * (size + 5)));
    EXPECT_EQ(ScanFile(in("both.las")).size(), 10000u);
  }
}

TEST_F(ClassifiedScan, OfLasKeepsDescriptionsOfExtraBytesThatPointsHave)
{
  for (const auto& [type, described, stored] : // of bytes
       {std::make_tuple(3, 2, 2), {9, 4, 4}, {10, 8, 8}, {23, 6, 6}, {10, 8, 0}}) {
    std::string field(192, '\0');
    field[2] = static_cast<char>(type);
    LasSample las;
    las.minor = 4;
    las.format = 6;
    las.record = static_cast<std::uint16_t>(30 + stored);
    las.before = lasRecord("LASF_Spec", 4, field);
    las.points = {{1, 2, 3}};
    writeFile(in("scan.las"), las.bytes().replace(100, 1, {1}));
    saveTagged(
        in("out.las"), JointScan({in("scan.las")}, {}),
        [](const Eigen::Vector3f&) { return PointTag{}; }, 0);
    const std::string bytes = bytesOf(in("out.las"));
    EXPECT_EQ(at<std::uint32_t>(bytes, 100), 1u);
    EXPECT_EQ(at<std::uint16_t>(bytes, 375 + 20), (described == stored ? 4 : 3) * 192)
        << type;
    EXPECT_EQ(bytes.substr(375 + 54, 192) == field, described == stored);
    EXPECT_EQ(at<std::uint16_t>(bytes, 105), 30 + stored + 5);
  }
}

TEST_F(ClassifiedScan, OfLasFilesOfSeveralLayoutsLosesWhatTheyDoNotShare)
{
  writeFile(in("a.las"), fullLas(2, 1, 28));
  writeFile(in("b.las"), fullLas(4, 7, 36));
  testing::internal::CaptureStderr();
  saveTagged(
      in("out.las"), JointScan({in("a.las"), in("b.las")}, {}),
      [](const Eigen::Vector3f&) { return PointTag{}; }, 0);
  EXPECT_TRUE(says(testing::internal::GetCapturedStderr(),
                   "have another layout than those of"));
  const ToolCloud cloud = loadCloud(in("out.las"));
  ASSERT_EQ(cloud.size(), 10000u);
  EXPECT_NEAR((*cloud.points)[9999].y, 9.998, 1e-4);
}

TEST_F(ClassifiedScan, OfPcdHasTheFieldsOfTheScanAndThree)
{
  const RoomScan scan = scanOf();
  done(onFile(scan.pcd(true), {"--no-mesh", "--classified", in("out.pcd")}));
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

TEST_F(ClassifiedScan, TellsSoffitsAndColumnsFromCeilingsAndWalls)
{
  BoxRoom room;
  room.width = 6;
  room.depth = 5;
  room.has_soffit = true;
  RoomScan scan;
  scan.addRoom(room);
  const Eigen::Vector3d low(room.x + 3.5, room.y + 2.2, 0);
  const Eigen::Vector3d high = low + Eigen::Vector3d(0.5, 0.5, room.height);
  auto& points = scan.points;
  points.erase(std::remove_if(points.begin(), points.end(),
                              [&](const RoomPoint& p) {
                                return p.x > low.x() && p.x < high.x() &&
                                       p.y > low.y() && p.y < high.y();
                              }),
               points.end());
  for (const int across : {0, 1})
    for (const double at : {low[across], high[across]}) {
      Eigen::Vector3d from = low, to = high;
      from[across] = to[across] = at;
      scan.addPiece(from, to, Label::Column, 1);
    }
  done(onFile(scan.pcd(false), {"--no-mesh", "--classified", in("out.pcd")}));
  const ToolCloud cloud = loadCloud(in("out.pcd"));
  ASSERT_EQ(cloud.size(), scan.points.size());
  for (const Label label : {Label::Detail, Label::Column}) {
    double all = 0;
    double right = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i)
      if (scan.points[i].label == label) {
        ++all;
        right += cloud.label[i] == static_cast<std::uint32_t>(label) ? 1 : 0;
      }
    EXPECT_GT(right, 0.8 * all) << pcl::sedr::toString(label);
  }
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
  const ProgramRun result = done(run(SEDR, {in("a.pcd"), in("b.pcd"), in("model")},
                                     {"--no-mesh", "--classified", in("out.las")}));
  EXPECT_TRUE(says(result.err, "1 points without coordinates"));
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
  EXPECT_TRUE(says(refusal(65536), "room 65536 has no number of 16 bits"));
  scan.points.front().x = 0;
  scan.points.back().x = -250000; // in steps of 0.1 mm
  EXPECT_TRUE(says(refusal(1),
                   "in steps of 0.0001 reaches 214748 units of the scan from "
                   "x = 0, but a point is at -250000"));
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
