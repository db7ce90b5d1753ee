// SPDX-License-Identifier: BSD-3-Clause
#include "rows_in_pieces.h"

#include "sedr_filters/src/base/field_access.h"
#include <pcl/sedr_filters/parallel_voxel_grid.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <random>

namespace {

/** Builds a blob of points with fields of one value each. */
class BlobMaker {
public:
  void field(const std::string& name, std::uint8_t datatype, unsigned count = 1)
  {
    pcl::PCLPointField f;
    f.name = name;
    f.datatype = datatype;
    f.count = count;
    f.offset = blob_->point_step;
    blob_->fields.push_back(f);
    blob_->point_step += static_cast<unsigned>(pcl::sedr::fieldSize(datatype)) * count;
    blob_->height = 1;
  }

  void point(const std::vector<double>& values)
  {
    const std::size_t begin = blob_->data.size();
    blob_->data.resize(begin + blob_->point_step);
    std::size_t v = 0;
    for (const auto& f : blob_->fields)
      for (unsigned k = 0; k < f.count; ++k)
        pcl::sedr::writeField(
            &blob_->data[begin + f.offset + k * pcl::sedr::fieldSize(f.datatype)],
            f.datatype, values[v++]);
    ++blob_->width;
    blob_->row_step = blob_->width * blob_->point_step;
  }

  pcl::PCLPointCloud2::Ptr get() const { return blob_; }

private:
  pcl::PCLPointCloud2::Ptr blob_ = std::make_shared<pcl::PCLPointCloud2>();
};

double
valueOf(const pcl::PCLPointCloud2& blob,
        std::size_t row,
        std::size_t field,
        std::size_t k = 0)
{
  const auto& f = blob.fields[field];
  return pcl::sedr::readField(&blob.data[row * blob.point_step + f.offset +
                                         k * pcl::sedr::fieldSize(f.datatype)],
                              f.datatype);
}

pcl::PCLPointCloud2
thin(const pcl::PCLPointCloud2::ConstPtr& blob,
     pcl::ParallelVoxelGrid<pcl::PCLPointCloud2>& grid)
{
  grid.setLeafSize(1, 1, 1);
  pcl::PCLPointCloud2 output;
  grid.filter(sedr_test::RowsInPieces(*blob), output);
  return output;
}

TEST(ParallelVoxelGridBlob, GivesWhatTheClassOfPointsGives)
{
  pcl::PointCloud<pcl::PointXYZRGBNormal> cloud;
  std::mt19937 random(1);
  std::uniform_real_distribution<float> coordinate(-3, 3);
  for (int i = 0; i < 3000; ++i) {
    pcl::PointXYZRGBNormal p;
    p.x = coordinate(random);
    p.y = coordinate(random);
    p.z = coordinate(random);
    p.rgba = static_cast<std::uint32_t>(random()) | 0xff000000u;
    p.getNormalVector3fMap() = Eigen::Vector3f(p.x, p.y, 5).normalized();
    p.curvature = p.z;
    cloud.push_back(p);
  }
  auto blob = std::make_shared<pcl::PCLPointCloud2>();
  pcl::toPCLPointCloud2(cloud, *blob);
  pcl::ParallelVoxelGrid<pcl::PCLPointCloud2> blob_grid;
  const auto thinned = thin(blob, blob_grid);
  pcl::PointCloud<pcl::PointXYZRGBNormal> from_blob;
  pcl::fromPCLPointCloud2(thinned, from_blob);

  pcl::ParallelVoxelGrid<pcl::PointXYZRGBNormal> grid;
  grid.setInputCloud(std::make_shared<pcl::PointCloud<pcl::PointXYZRGBNormal>>(cloud));
  grid.setLeafSize(1, 1, 1);
  pcl::PointCloud<pcl::PointXYZRGBNormal> expected;
  grid.filter(expected);
  ASSERT_EQ(from_blob.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(from_blob[i].getVector3fMap(), expected[i].getVector3fMap());
    EXPECT_EQ(from_blob[i].r, expected[i].r);
    EXPECT_EQ(from_blob[i].g, expected[i].g);
    EXPECT_EQ(from_blob[i].b, expected[i].b);
    EXPECT_LT((from_blob[i].getNormalVector3fMap() - expected[i].getNormalVector3fMap())
                  .norm(),
              1e-5);
    EXPECT_NEAR(from_blob[i].curvature, expected[i].curvature, 1e-5);
  }
}

TEST(ParallelVoxelGridBlob, AveragesFieldsOfEveryTypeAndCountAndVotesOnLabels)
{
  using Field = pcl::PCLPointField;
  BlobMaker maker;
  maker.field("x", Field::FLOAT64);
  maker.field("label", Field::INT16);
  maker.field("y", Field::FLOAT64);
  maker.field("z", Field::FLOAT64);
  maker.field("ring", Field::UINT16);
  maker.field("shape", Field::FLOAT32, 2);
  maker.field("room", Field::UINT8);
  maker.field("time", Field::UINT64);
  maker.point({0.125, 3, 0.5, 0.5, 7, 1, 10, 2, 1000});
  maker.point({0.25, 1, 0.5, 0.5, 8, 2, 20, 2, 1001});
  maker.point({0.375, 3, 0.5, 0.5, 8, 6, 60, 1, 1002});
  maker.point({5, 4, 5, 5, 9, 4, 40, 9, 5000});
  pcl::ParallelVoxelGrid<pcl::PCLPointCloud2> grid;
  const auto output = thin(maker.get(), grid);
  ASSERT_EQ(output.width, 2u);
  ASSERT_EQ(output.fields.size(), 8u);
  EXPECT_EQ(valueOf(output, 0, 0), 0.25);
  EXPECT_EQ(valueOf(output, 0, 1), 3);
  EXPECT_EQ(valueOf(output, 0, 4), 8); // 7.67
  EXPECT_EQ(valueOf(output, 0, 5, 0), 3);
  EXPECT_EQ(valueOf(output, 0, 5, 1), 30);
  EXPECT_EQ(valueOf(output, 0, 6), 2);
  EXPECT_EQ(valueOf(output, 0, 7), 1001);
  EXPECT_EQ(valueOf(output, 1, 1), 4);
}

TEST(ParallelVoxelGridBlob, BrokenFieldsAreRefused)
{
  using Field = pcl::PCLPointField;
  const auto errorOf = [](const pcl::PCLPointCloud2::ConstPtr& blob) {
    pcl::ParallelVoxelGrid<pcl::PCLPointCloud2> grid;
    EXPECT_EQ(thin(blob, grid).width, 0u);
    return grid.getErrorMessage();
  };
  BlobMaker flat;
  flat.field("x", Field::FLOAT32);
  flat.field("y", Field::FLOAT32);
  flat.point({1, 2});
  EXPECT_NE(errorOf(flat.get()).find("'z'"), std::string::npos);

  BlobMaker whole;
  for (const char* name : {"x", "y", "z"})
    whole.field(name, Field::FLOAT32);
  whole.point({1, 2, 3});
  const auto beyond = std::make_shared<pcl::PCLPointCloud2>(*whole.get());
  beyond->fields[2].offset = 10;
  EXPECT_NE(errorOf(beyond).find("14"), std::string::npos);
}

} // namespace
