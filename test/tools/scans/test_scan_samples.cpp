// SPDX-License-Identifier: BSD-3-Clause
#include "scan_file.h"
#include "tool_cloud.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

namespace {

using namespace pcl::sedr::tools;

/** Files of other programs, in the folder formats/ of SEDR_DATA. */
class ScanSamples : public ::testing::Test {
protected:
  void SetUp() override
  {
    const char* data = std::getenv("SEDR_DATA");
    if (!data || !std::filesystem::is_directory(std::string(data) + "/formats"))
      GTEST_SKIP() << "SEDR_DATA names no folder that holds formats/";
    folder_ = std::string(data) + "/formats/";
  }

  ToolCloud load(const std::string& name, const ScanSettings& settings = {}) const
  {
    return loadCloud(folder_ + name, settings);
  }

  std::string folder_;
};

Eigen::AlignedBox3f
boxOf(const ToolCloud& cloud)
{
  Eigen::AlignedBox3f box;
  for (const auto& p : *cloud.points)
    if (std::isfinite(p.x))
      box.extend(p.getVector3fMap());
  return box;
}

TEST_F(ScanSamples, E57OfTheSamePointsAsIntegersAndAsDoublesAgree)
{
  const ToolCloud whole = load("bunnyInt32.e57");
  const ToolCloud real = load("bunnyDouble.e57");
  ASSERT_EQ(whole.size(), 30571u);
  ASSERT_EQ(real.size(), whole.size());
  for (std::size_t i = 0; i < real.size(); ++i)
    ASSERT_LT(((*real.points)[i].getVector3fMap() - (*whole.points)[i].getVector3fMap())
                  .norm(),
              1e-6f);
  // The bounding box according to the file.
  const Eigen::AlignedBox3f box = boxOf(real);
  EXPECT_NEAR(box.min().x(), -0.094689, 1e-6);
  EXPECT_NEAR(box.max().y(), 0.187321, 1e-6);
  EXPECT_NEAR(box.max().z(), 0.058799, 1e-6);
}

TEST_F(ScanSamples, E57OfOtherWritersHaveTheirPointsInTheirBoxes)
{
  const ToolCloud cube = load("ColouredCubeFloat.e57");
  EXPECT_EQ(cube.size(), 7680u);
  EXPECT_NEAR((boxOf(cube).sizes() - Eigen::Vector3f(1, 1, 1)).norm(), 0, 1e-6);
  EXPECT_NE(findField(cube.blob, "rgb"), nullptr);
  const ToolCloud colours = load("ColourRepresentation.e57");
  EXPECT_EQ(colours.size(), 153u);
  EXPECT_NEAR((boxOf(colours).sizes() - Eigen::Vector3f(1, 1, 1)).norm(), 0, 1e-6);
  const ToolCloud moved = load("translation_without_rotation.e57");
  ASSERT_EQ(moved.size(), 4u);
  EXPECT_EQ(boxOf(moved).min(), Eigen::Vector3f(4, 5, 6));
  EXPECT_EQ(boxOf(moved).max(), Eigen::Vector3f(5, 6, 6));
  const ToolCloud sphere = load("tiny_spherical.e57");
  EXPECT_EQ(sphere.size(), 360u);
  for (const auto& p : *sphere.points)
    if (std::isfinite(p.x)) {
      EXPECT_NEAR(p.getVector3fMap().norm(), 1, 1e-6);
    }
  EXPECT_EQ(load("two_scans.e57").size(), 6u);
  ScanSettings second;
  second.scan = 2;
  EXPECT_EQ(load("two_scans.e57", second).size(), 4u);
}

TEST_F(ScanSamples, LasFilesFillTheBoxesOfTheirHeaders)
{
  struct Sample {
    const char* name;
    std::size_t points;
    Eigen::Vector3d low, high; ///< according to its header
  };
  const std::vector<Sample> samples{
      {"1.0_0.las", 1, {470692.44, 4602888.9, 16}, {470692.44, 4602888.9, 16}},
      {"1.2_3.las", 1, {470692.44, 4602888.9, 16}, {470692.44, 4602888.9, 16}},
      {"1.2-with-color.las",
       1065,
       {635619.85, 848899.7, 406.59},
       {638982.55, 853535.43, 586.38}},
      {"extrabytes.las",
       1065,
       {635619.85, 848899.7, 406.59},
       {638982.55, 853535.43, 586.38}},
      {"sample_c.las",
       14408,
       {674521.92, 1206740.08, 627.529},
       {674605.32, 1206814.96, 656.2299}},
      {"test1_4.las",
       1000,
       {1694038.4456, 1816492.7063, 5592.7499},
       {1694539.677, 1816497.9763, 5599.0697}}};
  for (const Sample& sample : samples) {
    const ToolCloud cloud = load(sample.name);
    EXPECT_EQ(cloud.size(), sample.points) << sample.name;
    const Eigen::AlignedBox3f box = boxOf(cloud);
    // Kilometres from the origin, a float is off by 0.25 mm.
    EXPECT_LT((cloud.origin.toGiven(box.min().cast<double>()) - sample.low).norm(),
              0.002)
        << sample.name;
    EXPECT_LT((cloud.origin.toGiven(box.max().cast<double>()) - sample.high).norm(),
              0.002)
        << sample.name;
  }
}

} // namespace
