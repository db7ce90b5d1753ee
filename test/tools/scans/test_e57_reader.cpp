// SPDX-License-Identifier: BSD-3-Clause
#include "e57/crc32c.h"
#include "e57/e57_reader.h"
#include "e57/e57_tree.h"
#include "e57_writer.h"
#include "scan_file.h"
#include "tool_cloud.h"
#include "tool_error.h"
#include "tools/run_program.h"
#include "tools/sample_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace {

using namespace pcl::sedr::tools;
using programs::E57TestField;
using programs::E57Writer;
using programs::TemporaryFolder;
using programs::writeFile;

/** Returns three coordinates of `n` points within `reach` of 0, in 0.1 mm. */
std::vector<std::vector<std::int64_t>>
wholeCoordinates(std::size_t n, std::int64_t reach)
{
  std::mt19937_64 random(7);
  std::uniform_int_distribution<std::int64_t> coordinate(-reach, reach);
  std::vector<std::vector<std::int64_t>> xyz(3);
  for (std::size_t i = 0; i < n; ++i)
    for (auto& axis : xyz)
      axis.push_back(coordinate(random));
  return xyz;
}

std::vector<E57TestField>
integerFields(const std::vector<std::vector<std::int64_t>>& xyz, std::int64_t reach)
{
  std::vector<E57TestField> fields;
  for (std::size_t axis = 0; axis < 3; ++axis)
    fields.push_back(E57TestField::ofIntegers(
        std::string("cartesian") + "XYZ"[axis], xyz[axis], -reach, reach,
        "scale=\"0.0001\" offset=\"" + std::to_string(axis) + "\""));
  return fields;
}

class E57Files : public ::testing::Test {
protected:
  std::string write(const std::string& bytes)
  {
    const auto path = folder_.path() / "scan.e57";
    writeFile(path, bytes);
    return path.string();
  }

  ToolCloud load(const E57Writer& writer, const ScanSettings& settings = {})
  {
    return loadCloud(write(writer.file()), settings);
  }

  /** Returns the error for the bytes; fails the test if they are read. */
  std::string refusal(const std::string& bytes, const ScanSettings& settings = {})
  {
    try {
      loadCloud(write(bytes), settings);
    }
    catch (const ToolError& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      return error.what();
    }
    ADD_FAILURE() << "it was read";
    return {};
  }

  TemporaryFolder folder_;
};

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
  const ScanFile pieces(path, 1, 100000);
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

TEST_F(E57Files, WhatIsBrokenIsToldWithNumbers)
{
  const auto fields = integerFields(wholeCoordinates(500, 5000), 5000);
  E57Writer writer;
  writer.addScan("hall", fields);
  const std::string good = writer.file();
  const auto expect = [&](const std::string& bytes, const std::string& part) {
    const std::string reason = refusal(bytes);
    EXPECT_NE(reason.find(part), std::string::npos) << reason;
    EXPECT_NE(reason.find("scan.e57'"), std::string::npos) << reason;
  };
  std::string bytes = good;
  bytes[1500] = static_cast<char>(bytes[1500] ^ 16);
  expect(bytes, "page 2 of 4 is damaged, its checksum is");
  expect(good.substr(0, good.size() - 1), "cut off, its header promises 4096 bytes");
  expect(good.substr(0, 40), "it has 40 bytes of the 48");
  const auto withNumber = [&](std::size_t at, std::uint64_t number) {
    std::string page = good.substr(0, E57Writer::payload);
    page.replace(at, sizeof number, reinterpret_cast<const char*>(&number),
                 sizeof number);
    return E57Writer::sealed(page) + good.substr(E57Writer::page);
  };
  expect(withNumber(8, 9), "version 9");
  expect(withNumber(40, 5), "pages are said to have 5 bytes");
  expect(withNumber(16, 3000), "its 3000 bytes are no whole number of pages of 1024");
  expect(withNumber(24, 3000000), "its XML is said to begin at byte 3000000");
  expect(withNumber(24, 1021), "its XML is said to begin at byte 1021");
  expect(withNumber(32, 1ull << 40), "its XML is said to have 1099511627776 bytes");

  E57Writer lying;
  lying.addScan("hall", fields, "", 501);
  expect(lying.file(), "scan 1 ('hall'): it is said to have 501 points, its packets "
                       "hold 'cartesianX' of 500");
  E57Writer modest;
  modest.addScan("hall", fields, "", 400);
  expect(modest.file(), "scan 1 ('hall'): it is said to have 400 points, its packets "
                        "hold 'cartesianX' of 500");
  E57Writer floats;
  const std::vector<float> values(500, 1);
  floats.addScan("",
                 {E57TestField::ofFloats("cartesianX", values),
                  E57TestField::ofFloats("cartesianY", values),
                  E57TestField::ofFloats("cartesianZ", values)},
                 "", 499);
  expect(floats.file(),
         "said to have 499 points, its packets hold 'cartesianX' of 500");
  E57Writer bodiless;
  std::vector<E57TestField> constant;
  for (const char* name : {"cartesianX", "cartesianY", "cartesianZ"})
    constant.push_back(E57TestField::ofIntegers(name, {1}, 1, 1));
  bodiless.addScan("", constant, "", 0x7fffffff);
  expect(bodiless.file(),
         "all of its 2147483647 points are one and the same, the whole "
         "file has 8160 bits");
  E57Writer constants;
  constants.addScan("", constant, "", 3000);
  EXPECT_EQ(load(constants).size(), 3000u);
  E57Writer huge;
  huge.addScan("", fields, "", 1ll << 60);
  expect(huge.file(), "scan 1: it is said to have 1152921504606846976 points");
  E57Writer blind;
  blind.addScan("", {fields[0], fields[1]});
  expect(blind.file(), "neither cartesian nor spherical");
  E57Writer negative;
  auto shrunk = fields;
  shrunk[1].attributes =
      "type=\"ScaledInteger\" minimum=\"0\" maximum=\"9\" scale=\"-1\"";
  negative.addScan("", shrunk);
  expect(negative.file(), "the scale of 'cartesianY' is -1.0");
  E57Writer turned;
  turned.addScan("", fields, E57Writer::pose(1, 1, 0, 0, 0, 0, 0));
  expect(turned.file(), "quaternion of its pose has the length 1.41");
  E57Writer empty;
  expect(empty.file(), "it holds no scan");
  E57Writer pointless;
  auto none = fields;
  for (auto& field : none)
    field.stored.clear();
  pointless.addScan("", none);
  expect(pointless.file(), "has 0 points");
  ScanSettings third;
  third.scan = 3;
  EXPECT_NE(refusal(good, third).find("has no scan 3, it holds 1"), std::string::npos);
}

TEST_F(E57Files, XmlThatWouldGrowOrGoTooDeepIsRefused)
{
  E57Writer writer;
  std::string deep;
  for (int k = 0; k < 100000; ++k)
    deep += "<a>";
  EXPECT_NE(refusal(writer.fileWith(deep)).find("deeper than 64"), std::string::npos);
  EXPECT_NE(refusal(writer.fileWith("<!DOCTYPE x [<!ENTITY a \"aaaa\">]><e57Root/>"))
                .find("document type"),
            std::string::npos);
  EXPECT_NE(refusal(writer.fileWith("<!doctype x><e57Root/>")).find("document type"),
            std::string::npos);
  EXPECT_FALSE(shapeOf("<!-- <!DOCTYPE x> --><a><![CDATA[<!DOCTYPE y>]]></a>", 9)
                   .has_document_type);
  EXPECT_NE(refusal(writer.fileWith("<e57Root><data3D></e57Root>")).find("XML"),
            std::string::npos);
  EXPECT_EQ(shapeOf("<a><!-- <b><c> --><b x='>'/><![CDATA[<d><d>]]></a>", 9).nesting,
            2u);
  EXPECT_EQ(shapeOf("<", 9).nesting, 1u);
  // As rapidxml reads them: quotes in names, in closing tags and in declarations.
  EXPECT_EQ(shapeOf("<a\"><b'><c=\">", 9).nesting, 3u);
  EXPECT_EQ(shapeOf("<a></a\"><b><c>", 9).nesting, 2u);
  EXPECT_EQ(shapeOf("<!x '><a><b>", 9).nesting, 2u);
  EXPECT_EQ(shapeOf("<a b\"=\"x\"><c>", 9).nesting, 2u);
  EXPECT_EQ(shapeOf("<a b = '<c>'/><d e=\"'\"><f>", 9).nesting, 2u);
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

TEST_F(E57Files, OneBrokenScanOfSeveralIsNamedOrLeftOut)
{
  const auto fields = integerFields(wholeCoordinates(3000, 5000), 5000);
  E57Writer writer;
  writer.addScan("kitchen", fields);
  writer.addScan("cellar", fields, "", 4000);
  writer.addScan("attic", fields);
  EXPECT_NE(refusal(writer.file()).find("scan 2 ('cellar')"), std::string::npos);
  ScanSettings settings;
  settings.skip_broken = true;
  EXPECT_EQ(load(writer, settings).size(), 6000u);
  // Damaged points are detected before they are returned.
  std::string bytes = writer.file();
  bytes[3000] = static_cast<char>(bytes[3000] ^ 1);
  EXPECT_EQ(loadCloud(write(bytes), settings).size(), 3000u);
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

/** Valid files with changed bytes, with or without correct checksums, or truncated,
 * must be read or rejected. */
TEST_F(E57Files, ChangedBytesAreReadOrRefused)
{
  E57Writer writer;
  writer.packet_bytes = 300;
  writer.has_index = true;
  writer.addScan("a", integerFields(wholeCoordinates(300, 500), 500),
                 E57Writer::pose(1, 0, 0, 0, 1, 2, 3));
  writer.addScan("b", {E57TestField::ofDoubles("sphericalRange", {1, 2, 3}),
                       E57TestField::ofDoubles("sphericalAzimuth", {1, 2, 3}),
                       E57TestField::ofFloats("sphericalElevation", {0, 0, 1})});
  const std::string good = writer.file();
  std::mt19937 random(1);
  std::size_t refused = 0;
  constexpr std::size_t trials = 4000;
  for (std::size_t trial = 0; trial < trials; ++trial) {
    std::string bytes = good;
    for (std::size_t k = 0; k <= trial % 4; ++k) {
      const std::size_t at = random() % (trial % 3 == 0 ? 200 : bytes.size());
      bytes[at] = static_cast<char>(trial % 5 == 0 ? 0xff : random());
    }
    if (trial % 8 != 0) { // correct checksums reach more code
      std::string sealed;
      for (std::size_t p = 0; p + E57Writer::page <= bytes.size(); p += E57Writer::page)
        sealed += E57Writer::sealed(bytes.substr(p, E57Writer::payload));
      bytes = sealed;
    }
    if (trial % 50 == 0)
      bytes.resize(random() % bytes.size() + 1);
    try {
      ScanSettings settings;
      settings.skip_broken = trial % 16 == 1;
      loadCloud(write(bytes), settings);
    }
    catch (const ToolError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, trials / 8);
  EXPECT_LT(refused, trials);
}

} // namespace
