// SPDX-License-Identifier: BSD-3-Clause
// What the readers give of good files, against values in closed form.
#include "scan_folder.h"

#include <cmath>
#include <limits>
#include <tuple>

namespace {

using namespace pcl::sedr::tools;
using namespace programs;

class ScanFormats : public ScanFolder {
protected:
  static void
  expectPoint(const ToolCloud& cloud, std::size_t row, double x, double y, double z)
  {
    ASSERT_LT(row, cloud.size());
    const auto& p = (*cloud.points)[row];
    constexpr double tolerance = 1e-6;
    ASSERT_NEAR(p.x, x, tolerance) << row;
    ASSERT_NEAR(p.y, y, tolerance) << row;
    ASSERT_NEAR(p.z, z, tolerance) << row;
  }

  /** Returns red, green, blue and alpha of a row. */
  static std::array<int, 4> colourOf(const ToolCloud& cloud, std::size_t row)
  {
    const auto* field = findField(cloud.blob, "rgb");
    if (!field)
      field = findField(cloud.blob, "rgba");
    if (!field)
      return {-1, -1, -1, -1};
    const auto* bytes = &cloud.blob.data[row * cloud.blob.point_step + field->offset];
    return {bytes[2], bytes[1], bytes[0], bytes[3]};
  }

  ToolCloud text(const std::string& bytes, const std::string& columns = "") const
  {
    ScanSettings settings;
    settings.columns = columns;
    return load(bytes, settings);
  }
};

using Colour = std::array<int, 4>;

TEST_F(ScanFormats, AsciiPcdMayHaveCommentsBlankLinesAndNaN)
{
  const ToolCloud cloud =
      load("# a comment\nVERSION .7\nFIELDS x y z room\nSIZE 4 8 4 1\n"
           "TYPE F F F U\nCOUNT 1 1 1 1\nWIDTH 3\nHEIGHT 1\n"
           "VIEWPOINT 1 2 3 1 0 0 0\nPOINTS 3\nDATA ascii\n"
           "1.5 -2e1 +3 7\r\n\n nan 5 -inf 9\n1e400 1e-400 0 1\n");
  expectPoint(cloud, 0, 1.5, -20, 3);
  EXPECT_TRUE(std::isnan((*cloud.points)[1].x));
  EXPECT_TRUE(std::isinf((*cloud.points)[2].x)); // not 0
  EXPECT_EQ(cloud.room, (std::vector<std::uint32_t>{7, 9, 1}));
  EXPECT_EQ(cloud.points->sensor_origin_.y(), 2.F);
  EXPECT_EQ(findField(cloud.blob, "y")->datatype, pcl::PCLPointField::FLOAT32);
}

TEST_F(ScanFormats, PaddingOfBinaryPcdIsLeftOut)
{
  const float xyz[] = {1, 2, 3};
  const std::uint32_t rest[] = {77, 5};
  const ToolCloud cloud =
      load("FIELDS x y z _ label\nSIZE 4 4 4 1 4\nTYPE F F F U U\nCOUNT 1 1 1 4 1\n"
           "WIDTH 1\nDATA binary\n" +
           std::string(reinterpret_cast<const char*>(xyz), sizeof xyz) +
           std::string(reinterpret_cast<const char*>(rest), sizeof rest));
  EXPECT_EQ(cloud.blob.fields.size(), 4u);
  EXPECT_EQ(cloud.label, (std::vector<std::uint32_t>{5}));
}

TEST_F(ScanFormats, PlyOfAnyByteOrderHasItsVerticesBeforeOtherElements)
{
  const std::string elements =
      "comment made by hand\nelement vertex 2\nproperty double x\n"
      "property double y\nproperty double z\nproperty uchar red\n"
      "property uchar green\nproperty uchar blue\nproperty uchar alpha\n"
      "property float nx\nelement edge 1\nproperty int a\nend_header\n";
  const ToolCloud ascii = load("ply\nformat ascii 1.0\n" + elements +
                               "1 2 3 10 20 30 40 0.5\n\n4 5 6 1 2 3 4 1\n7\n");
  ASSERT_EQ(ascii.size(), 2u);
  expectPoint(ascii, 1, 4, 5, 6);
  EXPECT_EQ(floatField(ascii.blob, "normal_x"), (std::vector<float>{0.5F, 1}));
  EXPECT_EQ(colourOf(ascii, 0), (Colour{10, 20, 30, 40}));
  for (const bool is_big : {false, true}) {
    std::string bytes = std::string("ply\nformat binary_") +
                        (is_big ? "big" : "little") + "_endian 1.0\n" + elements;
    const auto append = [&](auto value) {
      const char* first = reinterpret_cast<const char*>(&value);
      for (std::size_t k = 0; k < sizeof value; ++k)
        bytes += first[is_big ? sizeof value - 1 - k : k];
    };
    for (const double v : {1., 2., 3.})
      append(v);
    bytes += "\x0a\x14\x1e\x28";
    append(0.5F);
    for (const double v : {4., 5., 6.})
      append(v);
    bytes += "\1\2\3\4";
    append(1.F);
    append(7);
    EXPECT_EQ(load(bytes).blob.data, ascii.blob.data);
    EXPECT_TRUE(says(refusal(bytes.substr(0, bytes.size() - 5)), "cut off"));
  }
}

TEST_F(ScanFormats, LasOfEveryPointFormatHasIntensityAndColour)
{
  for (const auto& [format, record, colour] :
       {std::make_tuple(0, 20, 0), std::make_tuple(1, 28, 0),
        std::make_tuple(2, 26, 20), std::make_tuple(3, 34, 28),
        std::make_tuple(4, 57, 0), std::make_tuple(5, 63, 28),
        std::make_tuple(6, 30, 0), std::make_tuple(7, 36, 30),
        std::make_tuple(8, 38, 30), std::make_tuple(9, 59, 0),
        std::make_tuple(10, 67, 30)})
    for (const int extra : {0, 5}) {
      LasSample las = threeLasPoints();
      las.minor = format < 6 ? 2 : 4;
      las.format = static_cast<std::uint8_t>(format);
      las.record = static_cast<std::uint16_t>(record + extra);
      las.colour_offset = static_cast<std::uint16_t>(colour);
      las.colour = {0xff00, 0x8000, 0x0100};
      las.intensity = 517;
      las.before = std::string(54, 'x'); // records of other things
      const ToolCloud cloud = load(las.bytes());
      expectPoint(cloud, 0, 2, 0, 6.5);
      expectPoint(cloud, 2, 0.999, 2.001, 5.147);
      EXPECT_EQ(floatField(cloud.blob, "intensity"),
                (std::vector<float>{517, 517, 517}));
      EXPECT_EQ(colourOf(cloud, 1),
                colour > 0 ? (Colour{255, 128, 1, 255}) : (Colour{-1, -1, -1, -1}));
    }
}

TEST_F(ScanFormats, LasColoursThatWereWrittenAsBytesStayBytes)
{
  LasSample las = threeLasPoints();
  las.format = 2;
  las.record = 26;
  las.colour_offset = 20;
  las.colour = {200, 100, 50};
  EXPECT_EQ(colourOf(load(las.bytes()), 0), (Colour{200, 100, 50, 255}));
  // Every fourth point is dark; a sample of every fourth one would see nothing else.
  las.points.assign(40000, {1, 2, 3});
  std::string bytes = las.bytes();
  for (std::size_t i = 0; i < las.points.size(); ++i)
    if (i % 4 != 0)
      bytes[227 + i * 26 + 21] = 0x75; // the upper byte of red
  const ToolCloud mixed = load(bytes);
  EXPECT_EQ(colourOf(mixed, 0), (Colour{0, 0, 0, 255}));
  EXPECT_EQ(colourOf(mixed, 1), (Colour{0x75, 0, 0, 255}));
}

TEST_F(ScanFormats, E57IntegersOfAnyWidthStraddlePackets)
{
  const std::size_t n = 3001;
  for (const std::int64_t reach : {3LL, 100LL, 70000LL, 5000000LL, 1LL << 40}) {
    const auto xyz = wholeCoordinates(n, std::min<std::int64_t>(reach, 9000000));
    for (const bool is_uneven : {false, true}) {
      E57Writer writer;
      writer.is_uneven = writer.has_index = is_uneven;
      writer.addScan("", integerFields(xyz, reach));
      const ToolCloud cloud = load(writer.file());
      ASSERT_EQ(cloud.size(), n);
      for (std::size_t i = 0; i < n; ++i)
        expectPoint(cloud, i, static_cast<float>(1e-4 * static_cast<double>(xyz[0][i])),
                    static_cast<float>(1e-4 * static_cast<double>(xyz[1][i]) + 1),
                    static_cast<float>(1e-4 * static_cast<double>(xyz[2][i]) + 2));
    }
  }
  E57Writer writer;
  writer.packet_bytes = 37; // values of eight bytes straddle packets
  writer.addScan("",
                 {E57TestField::ofIntegers("cartesianX", {5, 5, 5}, 5, 5), // no bit
                  E57TestField::ofIntegers("cartesianY", {-3, 0, 900},
                                           std::numeric_limits<std::int64_t>::min(),
                                           std::numeric_limits<std::int64_t>::max()),
                  E57TestField::ofIntegers("cartesianZ", {1, -1, 2}, -(1LL << 60),
                                           1LL << 60, "scale=\"0.5\"")});
  const ToolCloud cloud = load(writer.file());
  expectPoint(cloud, 0, 5, -3, 0.5);
  expectPoint(cloud, 1, 5, 0, -0.5);
  expectPoint(cloud, 2, 5, 900, 1);
}

TEST_F(ScanFormats, E57OfSeveralPosesStandsInOneFrame)
{
  // A quarter turn about z, then a shift: range 2 along the scanner's x becomes y.
  const double half = std::sqrt(0.5);
  E57Writer writer;
  writer.addScan("a",
                 {E57TestField::ofReals<double>("sphericalRange", {2, 2, 1}),
                  E57TestField::ofReals<double>("sphericalAzimuth", {0, M_PI / 2, 1}),
                  E57TestField::ofReals<double>("sphericalElevation", {0, 0, M_PI / 2}),
                  E57TestField::ofIntegers("sphericalInvalidState", {0, 0, 0}, 0, 2)},
                 E57Writer::pose(half, 0, 0, half, 10, 20, 1.5));
  writer.addScan("b", realFields({1}, {2}, {3}),
                 E57Writer::pose(1, 0, 0, 0, -1, -1, 0));
  const ToolCloud cloud = load(writer.file());
  ASSERT_EQ(cloud.size(), 4u);
  expectPoint(cloud, 0, 10, 22, 1.5);
  expectPoint(cloud, 1, 8, 20, 1.5);
  expectPoint(cloud, 2, 10, 20, 2.5);
  expectPoint(cloud, 3, 0, 1, 3);
  const auto positions = ScanFile(in("scan")).positions();
  ASSERT_EQ(positions.size(), 2u);
  EXPECT_EQ(positions[1].first_row, 3u);
  EXPECT_EQ(positions[0].place, Eigen::Vector3f(10, 20, 1.5));

  ScanSettings second;
  second.scan = 2;
  const ToolCloud alone = load(writer.file(), second);
  ASSERT_EQ(alone.size(), 1u);
  expectPoint(alone, 0, 0, 1, 3);
  EXPECT_EQ(alone.points->sensor_origin_.head<3>(), Eigen::Vector3f(-1, -1, 0));
}

TEST_F(ScanFormats, E57HasNaNForInvalidPointsAndColoursOfAnyRange)
{
  E57Writer writer;
  auto fields = realFields({1, 2, 3}, {1, 2, 3}, {1, 2, 3});
  fields.insert(fields.begin(),
                {E57TestField::ofIntegers("colorRed", {0, 512, 1023}, 0, 1023),
                 E57TestField::ofIntegers("colorGreen", {255, 0, 9}, 0, 255),
                 E57TestField::ofReals<float>("colorBlue", {0, 0.5F, 1})});
  fields[2].attributes += " minimum=\"0\" maximum=\"1\"";
  fields.push_back(E57TestField::ofIntegers("cartesianInvalidState", {0, 1, 2}, 0, 2));
  fields.push_back({"note", "type=\"String\"", 8, {1, 2, 3}});
  fields.push_back(E57TestField::ofReals<float>("intensity", {0.25F, 0.5F, 1}));
  writer.addScan("", fields);
  const ToolCloud cloud = load(writer.file());
  expectPoint(cloud, 0, 1, 1, 1);
  EXPECT_TRUE(std::isnan((*cloud.points)[1].x));
  EXPECT_TRUE(std::isnan((*cloud.points)[2].z));
  EXPECT_EQ(floatField(cloud.blob, "intensity"), (std::vector<float>{0.25F, 0.5F, 1}));
  EXPECT_EQ(colourOf(cloud, 1), (Colour{128, 0, 128, 255}));
}

TEST_F(ScanFormats, ABrokenScanOfE57IsNamedOrLeftOut)
{
  const auto fields = integerFields(wholeCoordinates(3000, 5000), 5000);
  E57Writer writer;
  writer.addScan("kitchen", fields);
  writer.addScan("\x7f[31mcellar\xe4" + std::string(5000, 'n'), fields, "", 4000);
  writer.addScan("attic", fields);
  EXPECT_TRUE(says(refusal(writer.file()), "scan 2 ('\\x7f[31mcellar\\xe4"));
  ScanSettings settings;
  settings.skip_broken = true;
  EXPECT_EQ(load(writer.file(), settings).size(), 6000u);
  std::string bytes = writer.file(); // damage is found before points are given
  bytes[3000] = static_cast<char>(bytes[3000] ^ 1);
  EXPECT_EQ(load(bytes, settings).size(), 3000u);
}

/** Each text has the points (1.5, 2, 3) and perhaps more behind it. */
TEST_F(ScanFormats, ColumnsOfTextAreDividedByAnySign)
{
  for (const char* const bytes :
       {"1.5 2 3\n4 5 6\n", "# made by hand\n\n1.5\t2\t+3e0\r\n", "x,y,z\n1.5,2,3\n",
        "1.5;2;3; \n4;5;6;\n", "1.5, 2 ,\t3,,\n4, 5, 6,\n", "1.5 2 3 a door\n4 5 6\n",
        "1.5,2,3 255\n4,5,6 255\n", "1,5;2;3\n4;5,25;6\n", "1,5 2,0 +3\n4 5 6\n",
        "1.5 2 3\r4 5 6\r7 8 9", "1.5 2 3\r4 5 6\n7 8 9",
        "\"X\",\"Y\",\"Z\"\n1.5,2,3\n",
        "\xEF\xBB\xBF"
        "1.5 2 3\n",
        "\xEF\xBB\xBFNorth East Elev\n2 1.5 3\n",
        // Names and units of other programs.
        "Z [m], X [m], Y [m]\n3,1.5,2\n", "\"Z(m)\";\"X(m)\";\"Y(m)\"\n3;1.5;2\n",
        "h,e,n\n3,1.5,2\n", "Height;Easting;Northing\n3;1.5;2\n",
        "Höhe;Rechtswert;Hochwert\n3;1,5;2\n", "# z x y\n# by hand\n\n3 1.5 2\n"})
    expectPoint(text(bytes), 0, 1.5, 2, 3);
  expectPoint(text("1;2,5;3\n4;5,25;6\n"), 1, 4, 5.25, 6);
  expectPoint(text("a,b,c\n1.5,2,3\n", "x,y,z"), 0, 1.5, 2, 3);
  expectPoint(text("7 3 2 1.5\n", "_ z y x"), 0, 1.5, 2, 3);
  EXPECT_EQ(text("1 2 3\r4 5 6\r7 8 9").size(), 3u);
  std::string comments;
  for (int k = 0; k < 1000; ++k)
    comments += "# line " + std::to_string(k) + "\n\n";
  expectPoint(text(comments + "1 2 3\n"), 0, 1, 2, 3);
}

TEST_F(ScanFormats, ColumnsOfTextAreNamedByTheFileOrByTheirNumber)
{
  const ToolCloud named = text("//Intensity Z Y X\n9 3 2 1\n8 3 2 1\n");
  expectPoint(named, 0, 1, 2, 3);
  EXPECT_EQ(floatField(named.blob, "intensity"), (std::vector<float>{9, 8}));
  const ToolCloud other = text("PointNo;East;North;Elev;Scalar field\n7;1;2;3;9\n");
  EXPECT_EQ(floatField(other.blob, "scalar_field"), (std::vector<float>{9}));
  const ToolCloud pts = text("2\n1 2 3 -100 255 128 0\n4 5 6 -200 1 2 3\n"
                             "1\n7 8 9 0.5 1 2 3\n"); // two scans, each with its count
  ASSERT_EQ(pts.size(), 3u);
  expectPoint(pts, 2, 7, 8, 9);
  EXPECT_EQ(floatField(pts.blob, "intensity"), (std::vector<float>{-100, -200, 0.5F}));
  EXPECT_EQ(colourOf(pts, 0), (Colour{255, 128, 0, 255}));
  EXPECT_EQ(colourOf(text("1 2 3 0.5 0.5 0.7\n"), 0), (Colour{-1, -1, -1, -1}));
}

} // namespace
