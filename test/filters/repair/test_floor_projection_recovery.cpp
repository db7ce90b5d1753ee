// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/floor_projection_recovery.h>
#include <pcl/sedr_filters/point_types.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <limits>

namespace {

using pcl::sedr::StructureLabel;
using Point = pcl::PointStructure;
using Cloud = pcl::PointCloud<Point>;
using Recovery = pcl::FloorProjectionRecovery<Point>;

constexpr float cell = 0.05f;

/** A ceiling of 20 x 20 cells at z = 2.5, two points per cell. A floor of 20 x 20 cells
 * about z = 0 without the 6 x 4 cells of a cupboard, and a piece outside. */
struct Scene {
  Cloud::Ptr cloud = std::make_shared<Cloud>();
  pcl::Indices ceiling, floor, outside, hidden;

  Scene()
  {
    for (int y = 0; y < 20; ++y)
      for (int x = 0; x < 20; ++x) {
        const bool is_hidden = x >= 3 && x < 9 && y >= 5 && y < 9;
        for (const float part : {0.3f, 0.6f}) {
          const int i =
              add(static_cast<float>(x) + part, static_cast<float>(y) + 0.5f, 2.5f);
          ceiling.push_back(i);
          if (is_hidden)
            hidden.push_back(i);
        }
        if (!is_hidden)
          floor.push_back(add(static_cast<float>(x) + 0.4f,
                              static_cast<float>(y) + 0.4f,
                              (x + y) % 2 == 0 ? -0.01f : 0.01f));
      }
    for (int x = 30; x < 35; ++x)
      outside.push_back(add(static_cast<float>(x) + 0.5f, 3.5f, 0.5f));
  }

  /** A point at (x, y) in cells. */
  int add(float x, float y, float z)
  {
    Point p;
    p.x = x * cell;
    p.y = y * cell;
    p.z = z;
    p.normal_z = -1;
    p.label = static_cast<std::uint32_t>(StructureLabel::Ceiling);
    p.room = 3;
    cloud->push_back(p);
    return static_cast<int>(cloud->size()) - 1;
  }

  pcl::IndicesPtr floorAndOutside() const
  {
    auto all = std::make_shared<pcl::Indices>(floor);
    all->insert(all->end(), outside.begin(), outside.end());
    return all;
  }
};

pcl::IndicesPtr
shared(const pcl::Indices& indices)
{
  return std::make_shared<pcl::Indices>(indices);
}

TEST(FloorProjectionRecovery, FillsCellsWithoutFloorFromTheCeilingAndDropsTheOutside)
{
  const Scene scene;
  Recovery recovery(true);
  recovery.setInputCloud(scene.cloud);
  recovery.setIndices(scene.floorAndOutside());
  recovery.setCeilingIndices(shared(scene.ceiling));
  Cloud output;
  recovery.filter(output);
  EXPECT_EQ(recovery.getErrorMessage(), "");
  ASSERT_EQ(output.size(), scene.floor.size() + 2 * 24);
  EXPECT_EQ(recovery.getNumberOfProjected(), 48u);
  EXPECT_EQ(*recovery.getRemovedIndices(), scene.outside);
  pcl::Indices expected = scene.floor; // ceiling points are ordered by cell and row
  expected.insert(expected.end(), scene.hidden.begin(), scene.hidden.end());
  EXPECT_EQ(recovery.getProjectedIndices(), expected);
  for (std::size_t i = 0; i < scene.floor.size(); ++i)
    ASSERT_EQ(output[i].z, (*scene.cloud)[static_cast<std::size_t>(scene.floor[i])].z);
  for (std::size_t i = scene.floor.size(); i < output.size(); ++i) {
    const auto& source = (*scene.cloud)[static_cast<std::size_t>(expected[i])];
    EXPECT_EQ(output[i].x, source.x);
    EXPECT_EQ(output[i].y, source.y);
    EXPECT_NEAR(output[i].z, 0, 1e-8);
    EXPECT_EQ(output[i].normal_z, 1.f);
    EXPECT_EQ(output[i].room, 3u);
    EXPECT_EQ(output[i].label, static_cast<std::uint32_t>(StructureLabel::Floor));
  }
}

TEST(FloorProjectionRecovery, DetailsWidenTheScopeAndFillOnlyWhereThereIsNoCeiling)
{
  Scene scene;
  pcl::Indices detail;
  detail.push_back(scene.add(5.5f, 6.5f, 2.2f));   // under the ceiling
  const int soffit = scene.add(20.5f, 6.5f, 2.2f); // beside it
  detail.push_back(soffit);
  detail.push_back(scene.add(30.5f, 3.5f, 2.2f)); // over the first outside point
  detail.push_back(scene.add(std::numeric_limits<float>::quiet_NaN(), 1.f, 1.f));
  Recovery recovery(true);
  recovery.setInputCloud(scene.cloud);
  recovery.setIndices(scene.floorAndOutside());
  recovery.setCeilingIndices(shared(scene.ceiling));
  recovery.setDetailIndices(shared(detail));
  Cloud output;
  recovery.filter(output);
  EXPECT_EQ(recovery.getNumberOfProjected(), 49u);
  const auto& sources = recovery.getProjectedIndices();
  EXPECT_EQ(std::count(sources.begin(), sources.end(), soffit), 1);
  EXPECT_EQ(std::count(sources.begin(), sources.end(), detail[0]), 0);
  EXPECT_EQ(recovery.getRemovedIndices()->size(), 4u);
}

TEST(FloorProjectionRecovery, WithoutFloorItNeedsAPlane)
{
  const Scene scene;
  Recovery recovery;
  recovery.setInputCloud(scene.cloud);
  recovery.setIndices(shared(scene.outside));
  recovery.setCeilingIndices(shared(scene.ceiling));
  Cloud output;
  recovery.filter(output);
  EXPECT_TRUE(output.empty());
  EXPECT_NE(recovery.getErrorMessage().find("none of the 5 floor points"),
            std::string::npos);
  auto plane = std::make_shared<pcl::ModelCoefficients>();
  plane->values = {0, 0, 1, 0.25f};
  recovery.setFloorCoefficients(plane);
  recovery.filter(output);
  EXPECT_EQ(recovery.getErrorMessage(), "");
  ASSERT_EQ(output.size(), scene.ceiling.size());
  EXPECT_EQ(output[0].z, -0.25f);
}

} // namespace
