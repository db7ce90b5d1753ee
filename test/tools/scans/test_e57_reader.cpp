// SPDX-License-Identifier: BSD-3-Clause
#include "e57/crc32c.h"
#include "e57/e57_reader.h"
#include "e57_files.h"
#include "scan_file.h"
#include "tools/reading_settings.h"

#include <cmath>
#include <limits>

namespace {

using namespace pcl::sedr::tools;
using namespace programs;

void
expectPoint(const ToolCloud& cloud, std::size_t row, double x, double y, double z)
{
  const auto& p = (*cloud.points)[row];
  const double tolerance = 1e-6;
  ASSERT_NEAR(p.x, x, tolerance) << row;
  ASSERT_NEAR(p.y, y, tolerance) << row;
  ASSERT_NEAR(p.z, z, tolerance) << row;
}

TEST(Crc32c, IsThatOfBoostAndOfTheStandardsExample)
{
  const std::string digits = "123456789"; // RFC 3720, and all catalogues of CRCs
  EXPECT_EQ(crc32c(reinterpret_cast<const std::uint8_t*>(digits.data()), 9),
            0xe3069283u);
  std::mt19937 random(3);
  for (std::size_t size = 0; size < 70; ++size) {
    std::string bytes;
    for (std::size_t i = 0; i < size; ++i)
      bytes += static_cast<char>(random());
    boost::crc_optimal<32, 0x1edc6f41, 0xffffffff, 0xffffffff, true, true> crc;
    crc.process_bytes(bytes.data(), size);
    EXPECT_EQ(crc32c(reinterpret_cast<const std::uint8_t*>(bytes.data()), size),
              crc.checksum());
  }
}

TEST_F(E57Files, IntegersOfAnyWidthThatStraddlePacketsAreExact)
{
  const std::size_t n = 3001;
  for (const std::int64_t reach : {3ll, 100ll, 70000ll, 5000000ll, 1ll << 40}) {
    const auto xyz = wholeCoordinates(n, std::min<std::int64_t>(reach, 9000000));
    for (const bool is_uneven : {false, true}) {
      E57Writer writer;
      writer.is_uneven = writer.has_index = is_uneven;
      writer.addScan("", integerFields(xyz, reach));
      const ToolCloud cloud = load(writer);
      ASSERT_EQ(cloud.size(), n);
      for (std::size_t i = 0; i < n; ++i)
        expectPoint(cloud, i, static_cast<float>(1e-4 * static_cast<double>(xyz[0][i])),
                    static_cast<float>(1e-4 * static_cast<double>(xyz[1][i]) + 1),
                    static_cast<float>(1e-4 * static_cast<double>(xyz[2][i]) + 2));
    }
  }
}

TEST_F(E57Files, WidthsOfNoBitAndOf64AreRead)
{
  constexpr auto lowest = std::numeric_limits<std::int64_t>::min();
  constexpr auto highest = std::numeric_limits<std::int64_t>::max();
  E57Writer writer;
  writer.packet_bytes = 37; // values of eight bytes straddle packets
  writer.addScan(
      "", {E57TestField::ofIntegers("cartesianX", {5, 5, 5, 5}, 5, 5),
           E57TestField::ofIntegers("cartesianY", {-3, 0, 7, 900}, lowest, highest),
           E57TestField::ofIntegers("cartesianZ", {1, -1, 0, 2}, -(1ll << 60),
                                    1ll << 60, "scale=\"0.5\"")});
  const ToolCloud cloud = load(writer);
  ASSERT_EQ(cloud.size(), 4u);
  expectPoint(cloud, 0, 5, -3, 0.5);
  expectPoint(cloud, 1, 5, 0, -0.5);
  expectPoint(cloud, 3, 5, 900, 1);
}

TEST_F(E57Files, SphericalPointsOfSeveralPosesStandInOneFrame)
{
  // A quarter turn about z, then a shift: range 2 along the scanner's x becomes y.
  const double half = std::sqrt(0.5);
  E57Writer writer;
  writer.addScan("a",
                 {E57TestField::ofDoubles("sphericalRange", {2, 2, 1}),
                  E57TestField::ofDoubles("sphericalAzimuth", {0, M_PI / 2, 1}),
                  E57TestField::ofDoubles("sphericalElevation", {0, 0, M_PI / 2}),
                  E57TestField::ofIntegers("sphericalInvalidState", {0, 0, 0}, 0, 2)},
                 E57Writer::pose(half, 0, 0, half, 10, 20, 1.5));
  writer.addScan("b",
                 {E57TestField::ofFloats("cartesianX", {1}),
                  E57TestField::ofFloats("cartesianY", {2}),
                  E57TestField::ofFloats("cartesianZ", {3})},
                 E57Writer::pose(1, 0, 0, 0, -1, -1, 0));
  const ToolCloud cloud = load(writer);
  ASSERT_EQ(cloud.size(), 4u);
  expectPoint(cloud, 0, 10, 22, 1.5);
  expectPoint(cloud, 1, 8, 20, 1.5);
  expectPoint(cloud, 2, 10, 20, 2.5);
  expectPoint(cloud, 3, 0, 1, 3);

  const ScanFile scan(write(writer.file()));
  const auto stations = scan.stations();
  ASSERT_EQ(stations.size(), 2u);
  EXPECT_EQ(stations[1].first_row, 3u);
  EXPECT_EQ(stations[0].position, Eigen::Vector3d(10, 20, 1.5));
  EXPECT_EQ(stations[1].name, "b");

  ScanSettings second;
  second.scan = 2;
  const ToolCloud alone = load(writer, second);
  ASSERT_EQ(alone.size(), 1u);
  expectPoint(alone, 0, 0, 1, 3);
  EXPECT_EQ(alone.points->sensor_origin_.head<3>(), Eigen::Vector3f(-1, -1, 0));
}

TEST_F(E57Files, InvalidPointsAreNaNAndColoursAndIntensitiesStay)
{
  E57Writer writer;
  writer.addScan("",
                 {E57TestField::ofIntegers("colorRed", {0, 512, 1023}, 0, 1023),
                  E57TestField::ofIntegers("colorGreen", {255, 0, 9}, 0, 255),
                  E57TestField::ofIntegers("colorBlue", {1, 2, 3}, 0, 255),
                  E57TestField::ofFloats("cartesianX", {1, 2, 3}),
                  E57TestField::ofFloats("cartesianY", {1, 2, 3}),
                  E57TestField::ofFloats("cartesianZ", {1, 2, 3}),
                  E57TestField::ofIntegers("cartesianInvalidState", {0, 1, 2}, 0, 2),
                  {"note", "type=\"String\"", 8, {1, 2, 3}},
                  E57TestField::ofFloats("intensity", {0.25f, 0.5f, 1})});
  const ToolCloud cloud = load(writer);
  ASSERT_EQ(cloud.size(), 3u);
  expectPoint(cloud, 0, 1, 1, 1);
  EXPECT_TRUE(std::isnan((*cloud.points)[1].x));
  EXPECT_TRUE(std::isnan((*cloud.points)[2].z));
  EXPECT_EQ(floatField(cloud.blob, "intensity"), (std::vector<float>{0.25f, 0.5f, 1}));
  const auto* rgb = findField(cloud.blob, "rgb");
  ASSERT_NE(rgb, nullptr);
  const auto* second = &cloud.blob.data[cloud.blob.point_step + rgb->offset];
  EXPECT_EQ(second[2], 128); // 512 of 1023
  EXPECT_EQ(second[1], 0);
  EXPECT_EQ(second[0], 2);
}

TEST_F(E57Files, ColoursOfFloatsAreScaledByTheRangeOfTheirField)
{
  const std::vector<float> red{0, 0.5F, 1};
  auto fields = integerFields({{0, 1, 2}, {0, 1, 2}, {0, 1, 2}}, 9);
  for (const char* name : {"colorRed", "colorGreen", "colorBlue"})
    fields.push_back(E57TestField::ofFloats(name, red));
  for (std::size_t k = 3; k < fields.size(); ++k)
    fields[k].attributes += " minimum=\"0\" maximum=\"1\"";
  E57Writer writer;
  writer.addScan("", fields);
  const ToolCloud cloud = load(writer);
  const auto* rgb = findField(cloud.blob, "rgb");
  ASSERT_NE(rgb, nullptr);
  const std::size_t at = rgb->offset + 2; // red
  EXPECT_EQ(cloud.blob.data[at], 0);
  EXPECT_EQ(cloud.blob.data[cloud.blob.point_step + at], 128);
  EXPECT_EQ(cloud.blob.data[2 * cloud.blob.point_step + at], 255);
}

TEST_F(E57Files, PiecesAndSingleRowsAreThoseOfTheWhole)
{
  const std::size_t n = 200000; // several remembered packets
  const std::int64_t reach = 90000;
  E57Writer writer;
  writer.packet_bytes = 40000;
  writer.is_uneven = true;
  writer.addScan("one", integerFields(wholeCoordinates(n, reach), reach));
  writer.addScan("two", integerFields(wholeCoordinates(777, reach), reach));
  const std::string path = write(writer.file());
  const ToolCloud whole = loadCloud(path);
  ASSERT_EQ(whole.size(), n + 777);
  const ScanFile pieces(path, inPieces(100000));
  const auto begin = whole.blob.data.begin();
  const auto step = static_cast<std::ptrdiff_t>(pieces.rowSize());
  for (const auto& [from, to] : {std::make_pair<std::size_t>(0, n + 777),
                                 {n - 1, n + 1},
                                 {123456, 123457},
                                 {n + 776, n + 777}}) {
    std::vector<std::uint8_t> rows;
    pieces.forEachPiece(from, to, [&](const pcl::sedr::RowSource::Piece& piece) {
      rows.insert(rows.end(), piece.rows, piece.rows + piece.size * pieces.rowSize());
      return true;
    });
    ASSERT_EQ(rows.size(), (to - from) * pieces.rowSize());
    EXPECT_TRUE(std::equal(rows.begin(), rows.end(),
                           begin + step * static_cast<std::ptrdiff_t>(from)));
  }
}

TEST_F(E57Files, NamesThatCannotBePrintedAreEscapedAndCutShort)
{
  auto fields = integerFields(wholeCoordinates(10, 50), 50);
  E57Writer writer;
  writer.addScan("\x1b[31m" + std::string(5000, 'n'), fields, "", 99);
  const std::string reason = refusal(writer.file());
  EXPECT_NE(reason.find("('\\x1b[31mnnn"), std::string::npos) << reason;
  EXPECT_LT(reason.size(), 300u);
}

TEST_F(E57Files, LargeCoordinatesAreCountedFromWholeMetres)
{
  E57Writer writer;
  writer.addScan("", {E57TestField::ofDoubles("cartesianX", {691600.25, 691601.75}),
                      E57TestField::ofDoubles("cartesianY", {5335900.5, 5335901.125}),
                      E57TestField::ofDoubles("cartesianZ", {520, 523})});
  const std::string path = write(writer.file());
  const ScanFile scan(path);
  const Eigen::Vector3d origin = scan.origin().place;
  EXPECT_EQ(origin, origin.array().round().matrix());
  EXPECT_LT((origin - Eigen::Vector3d(691601, 5335901, 0)).norm(), 1.5);
  const ToolCloud cloud = loadCloud(path);
  expectPoint(cloud, 1, 691601.75 - origin.x(), 5335901.125 - origin.y(), 523);
  ScanSettings settings;
  settings.origin = pcl::sedr::Origin{{691000, 5335000, 500}};
  expectPoint(loadCloud(path, settings), 0, 600.25, 900.5, 20);
  settings.origin.reset();
  settings.shifts = false;
  EXPECT_NE(refusal(writer.file(), settings).find("too large"), std::string::npos);
}

} // namespace
