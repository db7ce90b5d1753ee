// SPDX-License-Identifier: BSD-3-Clause
#include "las_writer.h"
#include "tool_cloud.h"
#include "tool_error.h"
#include "tools/run_program.h"
#include "tools/sample_files.h"

#include <gtest/gtest.h>

#include <random>
#include <tuple>

namespace {

using namespace pcl::sedr::tools;
using programs::LasSample;
using programs::TemporaryFolder;
using programs::writeFile;

class LasFiles : public ::testing::Test {
protected:
  ToolCloud load(const std::string& bytes, const ScanSettings& settings = {})
  {
    writeFile(folder_.path() / "scan.las", bytes);
    return loadCloud((folder_.path() / "scan.las").string(), settings);
  }

  /** Returns the error for the bytes; fails the test if they are read. */
  std::string refusal(const std::string& bytes)
  {
    try {
      load(bytes);
    }
    catch (const ToolError& error) {
      return error.what();
    }
    ADD_FAILURE() << "it was read";
    return {};
  }

  TemporaryFolder folder_;
};

LasSample
threePoints()
{
  LasSample las;
  las.points = {{1000, -2000, 3500}, {0, 0, 0}, {-1, 1, 2147}};
  las.shift = {1, 2, 3};
  return las;
}

TEST_F(LasFiles, EveryFormatGivesPointsIntensityAndColour)
{
  for (const auto& [format, record, colour] :
       {std::make_tuple(0, 20, 0), std::make_tuple(1, 28, 0),
        std::make_tuple(2, 26, 20), std::make_tuple(3, 34, 28),
        std::make_tuple(4, 57, 0), std::make_tuple(5, 63, 28),
        std::make_tuple(6, 30, 0), std::make_tuple(7, 36, 30),
        std::make_tuple(8, 38, 30), std::make_tuple(9, 59, 0),
        std::make_tuple(10, 67, 30)})
    for (const int extra : {0, 5}) {
      LasSample las = threePoints();
      las.minor = format < 6 ? 2 : 4;
      las.format = static_cast<std::uint8_t>(format);
      las.record = static_cast<std::uint16_t>(record + extra);
      las.colour_offset = static_cast<std::uint16_t>(colour);
      las.colour = {0xff00, 0x8000, 0x0100};
      las.intensity = 517;
      las.before = std::string(54, 'x'); // records of other things
      const ToolCloud cloud = load(las.bytes());
      ASSERT_EQ(cloud.size(), 3u);
      EXPECT_EQ((*cloud.points)[0].x, 2.f);
      EXPECT_EQ((*cloud.points)[0].y, 0.f);
      EXPECT_EQ((*cloud.points)[0].z, 6.5f);
      EXPECT_FLOAT_EQ((*cloud.points)[2].z, 5.147f);
      EXPECT_EQ(floatField(cloud.blob, "intensity"),
                (std::vector<float>{517, 517, 517}));
      const auto* rgb = findField(cloud.blob, "rgb");
      ASSERT_EQ(rgb != nullptr, colour > 0);
      if (!rgb)
        continue;
      const auto* bytes = &cloud.blob.data[cloud.blob.point_step + rgb->offset];
      EXPECT_EQ(bytes[2], 255);
      EXPECT_EQ(bytes[1], 128);
      EXPECT_EQ(bytes[0], 1);
    }
}

TEST_F(LasFiles, ColoursThatWereWrittenAsBytesStayBytes)
{
  LasSample las = threePoints();
  las.format = 2;
  las.record = 26;
  las.colour_offset = 20;
  las.colour = {200, 100, 50};
  const ToolCloud cloud = load(las.bytes());
  EXPECT_EQ(cloud.blob.data[findField(cloud.blob, "rgb")->offset + 2], 200);
}

TEST_F(LasFiles, ColoursOfMixedDepthDoNotDependOnTheirOrder)
{
  // Every fourth point is dark; a sample of every fourth one would see nothing else.
  LasSample las = threePoints();
  las.format = 2;
  las.record = 26;
  las.colour_offset = 20;
  las.points.assign(40000, {1, 2, 3});
  las.colour = {100, 100, 100};
  std::string bytes = las.bytes();
  for (std::size_t i = 0; i < las.points.size(); ++i)
    if (i % 4 != 0)
      bytes[227 + i * 26 + 21] = 0x75; // the upper byte of red
  const ToolCloud cloud = load(bytes);
  const std::size_t red = findField(cloud.blob, "rgb")->offset + 2;
  EXPECT_EQ(cloud.blob.data[red], 0);
  EXPECT_EQ(cloud.blob.data[cloud.blob.point_step + red], 0x75);
}

TEST_F(LasFiles, CoordinatesOfAGridLoseNothing)
{
  LasSample las;
  las.scale = {0.0001, 0.0001, 0.0001};
  las.shift = {691600, 5335900, 0};
  las.points = {{1, 2, 3}, {10000, 20000, 30000}};
  const ToolCloud cloud = load(las.bytes());
  const Eigen::Vector3d origin = cloud.origin.place;
  EXPECT_EQ(origin, origin.array().round().matrix());
  EXPECT_LE((origin - Eigen::Vector3d(691600, 5335900, 0)).norm(), 3);
  EXPECT_NEAR((*cloud.points)[0].x, 691600.0001 - origin.x(), 1e-6);
  EXPECT_NEAR((*cloud.points)[1].y, 5335902 - origin.y(), 1e-6);
  EXPECT_NEAR((*cloud.points)[1].z, 3, 1e-6);
}

TEST_F(LasFiles, WhatIsBrokenIsToldWithNumbers)
{
  const LasSample good = threePoints();
  const auto expect = [&](const LasSample& las, const std::string& part) {
    const std::string reason = refusal(las.bytes());
    EXPECT_NE(reason.find(part), std::string::npos) << reason;
  };
  LasSample las = good;
  las.claimed_points = 4;
  expect(las, "promises 4 points of 20 bytes, but 60 bytes follow");
  las.claimed_points = 2;
  expect(las, "promises 2 points of 20 bytes, but 60 bytes are there for them");
  las = good;
  las.minor = 4;
  las.format = 6;
  las.record = 30;
  std::string followed = las.bytes(); // by records that LAS 1.4 tells
  const std::uint64_t after = followed.size();
  followed.replace(235, sizeof after, reinterpret_cast<const char*>(&after),
                   sizeof after);
  followed[243] = 1;
  EXPECT_EQ(load(followed + std::string(100, 'x')).size(), 3u);
  followed[243] = 0;
  EXPECT_NE(refusal(followed + std::string(120, 'x')).find("210 bytes are there"),
            std::string::npos);
  EXPECT_EQ(load(followed + std::string(100, 'x')).size(), 3u); // no points
  las.claimed_points = 1ll << 62;
  expect(las, "promises 4611686018427387904 points");
  las = good;
  las.minor = 7;
  expect(las, "of version 1.7");
  las = good;
  las.format = 11;
  expect(las, "of the format 11");
  las = good;
  las.format = 3;
  expect(las, "said to have 20 bytes, format 3 takes 34");
  las = good;
  las.scale[1] = -0.001;
  expect(las, "the scale of y is -0.001");
  las.scale[1] = 0;
  expect(las, "the scale of y is 0.0");
  las = good;
  las.before.assign(60, '\0');
  las.claimed_records = 1; // of 54 bytes and none of its own
  EXPECT_EQ(load(las.bytes()).size(), 3u);
  las.claimed_records = 2;
  expect(las, "2 records before its points, but number 2, from byte 281 on, does not "
              "end before byte 287");
  las.claimed_records = 1;
  las.before[20] = 7; // its length
  expect(las, "1 records before its points, but number 1, from byte 227 on");
  las = good;
  las.points.clear();
  expect(las, "has 0 points");
  las = good;
  las.format = 0x80;
  expect(las, "laszip -i");
  ScanSettings second;
  second.scan = 2;
  EXPECT_THROW(load(good.bytes(), second), ToolError);
  second.scan = 1;
  EXPECT_EQ(load(good.bytes(), second).size(), 3u);
  EXPECT_NE(refusal(good.bytes().substr(0, 100)).find("100 bytes of the 227"),
            std::string::npos);
}

TEST_F(LasFiles, ChangedBytesAreReadOrRefused)
{
  LasSample las = threePoints();
  las.minor = 4;
  las.format = 7;
  las.record = 36;
  las.colour_offset = 30;
  const std::string good = las.bytes();
  std::mt19937 random(5);
  std::size_t refused = 0;
  constexpr std::size_t trials = 4000;
  for (std::size_t trial = 0; trial < trials; ++trial) {
    std::string bytes = good;
    for (std::size_t k = 0; k <= trial % 4; ++k)
      bytes[random() % bytes.size()] =
          static_cast<char>(trial % 5 == 0 ? 0xff : random());
    if (trial % 20 == 0)
      bytes.resize(random() % bytes.size() + 1);
    try {
      load(bytes);
    }
    catch (const ToolError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, trials / 20);
  EXPECT_LT(refused, trials);
}

} // namespace
