// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include <pcl/conversions.h>
#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_surface/indoor_structure_reconstruction.h>

#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <memory>
#include <utility>

namespace {

using namespace sedr_test;
using pcl::sedr::RowSource;

/** A cloud that is read in pieces of some thousand points. */
class CloudInPieces : public RowSource {
public:
  CloudInPieces(const pcl::PointCloud<pcl::PointXYZ>& cloud, std::size_t piece)
      : piece_(piece)
  {
    pcl::toPCLPointCloud2(cloud, blob_);
  }

  const std::vector<pcl::PCLPointField>& fields() const override
  {
    return blob_.fields;
  }
  std::size_t rowSize() const override { return blob_.point_step; }
  std::size_t size() const override { return blob_.width; }

  void forEachPiece(const std::function<bool(const Piece&)>& see) const override
  {
    for (std::size_t first = 0; first < size(); first += piece_)
      if (!see({&blob_.data[first * rowSize()], first,
                std::min(piece_, size() - first)}))
        return;
  }

private:
  pcl::PCLPointCloud2 blob_;
  std::size_t piece_;
};

/** Passes the rows of another source to `beside` as they are read. */
class RowsShown : public RowSource {
public:
  RowsShown(const RowSource& source, SeeRun beside)
      : source_(source)
      , beside_(std::move(beside))
  {}

  const std::vector<pcl::PCLPointField>& fields() const override
  {
    return source_.fields();
  }
  std::size_t rowSize() const override { return source_.rowSize(); }
  std::size_t size() const override { return source_.size(); }

  void forEachPiece(const std::function<bool(const Piece&)>& see) const override
  {
    source_.forEachPiece([&](Piece piece) {
      piece.beside = beside_;
      return see(piece);
    });
  }

private:
  const RowSource& source_;
  SeeRun beside_;
};

TEST(InputSource, GivesWhatTheCloudGives)
{
  RoomPoints points;
  points.room(rectangle(0.01, 0.01, 4.01, 3.01), 0, 2.5);
  const auto cloud = points.cloud();
  pcl::IndoorStructureReconstruction<pcl::PointXYZ> reconstruction;
  reconstruction.setInputCloud(cloud);
  ASSERT_TRUE(reconstruction.findStructure()) << reconstruction.getErrorMessage();
  const std::string expected =
      pcl::sedr::floorplanToJson(*reconstruction.getFloorplan());
  pcl::PointCloud<pcl::PointStructure> structure = *reconstruction.getStructure();

  pcl::IndoorStructureReconstruction<pcl::PointXYZ> streamed;
  streamed.setInputSource(std::make_shared<CloudInPieces>(*cloud, 3000));
  ASSERT_TRUE(streamed.findStructure()) << streamed.getErrorMessage();
  EXPECT_EQ(pcl::sedr::floorplanToJson(*streamed.getFloorplan()), expected);
  ASSERT_EQ(streamed.getStructure()->size(), structure.size());
  for (std::size_t i = 0; i < structure.size(); ++i)
    ASSERT_EQ((*streamed.getStructure())[i].getVector3fMap(),
              structure[i].getVector3fMap());
  EXPECT_EQ(streamed.getStageReports().front().points_in, cloud->size());
}

TEST(InputSource, ShowsItsRowsWhileTheyAreThinned)
{
  RoomPoints points;
  points.room(rectangle(0.01, 0.01, 4.01, 3.01), 0, 2.5);
  const CloudInPieces cloud(*points.cloud(), 3000);
  std::atomic<std::size_t> shown{0};
  const RowsShown source(
      cloud, [&](std::size_t begin, std::size_t end) { shown += end - begin; });
  pcl::ParallelVoxelGrid<pcl::PointXYZ> grid;
  pcl::PointCloud<pcl::PointXYZ> thinned;
  grid.filter(source, thinned);
  EXPECT_FALSE(thinned.empty());
  EXPECT_EQ(shown, cloud.size());
}

TEST(Thinning, ElsewhereGivesWhatThisObjectGives)
{
  RoomPoints points;
  points.room(rectangle(0.01, 0.01, 4.01, 3.01), 0, 2.5);
  const auto cloud = points.cloud();
  pcl::IndoorStructureReconstruction<pcl::PointXYZ> reconstruction;
  reconstruction.setInputCloud(cloud);
  ASSERT_TRUE(reconstruction.findStructure()) << reconstruction.getErrorMessage();

  pcl::IndoorStructureReconstruction<pcl::PointXYZ> other;
  std::string problem;
  other.setThinning([&] {
    pcl::sedr::ThinnedScan scan;
    scan.problem = problem;
    scan.size = cloud->size();
    for (const auto& p : *cloud)
      scan.excerpt->push_back(p.getVector3fMap());
    pcl::ParallelVoxelGrid<pcl::PointXYZ> grid;
    grid.setInputCloud(cloud);
    grid.filter(*scan.points);
    return scan;
  });
  ASSERT_TRUE(other.findStructure()) << other.getErrorMessage();
  EXPECT_EQ(pcl::sedr::floorplanToJson(*other.getFloorplan()),
            pcl::sedr::floorplanToJson(*reconstruction.getFloorplan()));
  EXPECT_EQ(other.getStageReports().front().points_in, cloud->size());
  EXPECT_EQ(other.getStageReports().front().points_out,
            reconstruction.getStageReports().front().points_out);

  problem = "the scan is upside down";
  EXPECT_FALSE(other.findStructure());
  EXPECT_EQ(other.getFailedStage(), "input");
  EXPECT_NE(other.getErrorMessage().find(problem), std::string::npos);
}

TEST(InputSource, IsRefusedWithTheSentenceOfTheCloud)
{
  RoomPoints points;
  points.room(rectangle(0.01, 0.01, 4.01, 3.01), 0, 2.5);
  for (const float scale : {1000.f, 0.01f}) {
    auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>(*points.cloud());
    for (auto& p : *cloud)
      p.getVector3fMap() *= scale;
    pcl::IndoorStructureReconstruction<pcl::PointXYZ> reconstruction;
    reconstruction.setInputCloud(cloud);
    EXPECT_FALSE(reconstruction.findStructure());
    pcl::IndoorStructureReconstruction<pcl::PointXYZ> streamed;
    streamed.setInputSource(std::make_shared<CloudInPieces>(*cloud, 3000));
    EXPECT_FALSE(streamed.findStructure());
    EXPECT_EQ(streamed.getErrorMessage(), reconstruction.getErrorMessage());
    EXPECT_EQ(streamed.getFailedStage(), "input");
  }
}

} // namespace
