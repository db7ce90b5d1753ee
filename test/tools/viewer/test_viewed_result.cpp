// SPDX-License-Identifier: BSD-3-Clause
#include "scan_file.h"
#include "tool_error.h"
#include "tools/reading_settings.h"
#include "tools/sample_files.h"
#include "viewed_sample.h"

#include <fstream>

namespace {

using namespace programs;
using namespace pcl::sedr;
using namespace pcl::sedr::tools;

TEST_F(ViewedSample, IsReadWithAllItsLayers)
{
  for (const auto layer : all_layers)
    EXPECT_TRUE(result_.has(layer)) << toString(layer);
  EXPECT_EQ(result_.raw.size(), sample_.scan.points.size());
  EXPECT_TRUE(result_.raw.labels.empty());
  EXPECT_LT(result_.thinned.size(), result_.raw.size() / 2)
      << "voxels of report.json: 0.1 m, points 0.05 m apart";
  EXPECT_TRUE(result_.notes.empty());
  EXPECT_TRUE(result_.firstLayers() == LayerSet{Layer::Mesh});
  EXPECT_NEAR(result_.bounds().max().z(), 2.5, 1e-6);
}

TEST_F(ViewedSample, IsReadInPartWhereFilesAreMissing)
{
  const auto model = folder_.path() / "model";
  for (const char* name : {"mesh.ply", "solid.ply", "structure.pcd"})
    std::filesystem::remove(model / name);
  std::filesystem::remove(folder_.path() / "scan.pcd");
  const ViewedResult rest = readResult(model.string(), {});
  EXPECT_TRUE(rest.firstLayers() == LayerSet{Layer::Plan});
  EXPECT_EQ(rest.notes.size(), 1u) << "the scan";
  EXPECT_FALSE(rest.has(Layer::Raw));
  EXPECT_NEAR(rest.bounds().max().z(), 2.5, 1e-6);
  for (const char* name : {"floorplan.json", "report.json"})
    std::filesystem::remove(model / name);
  EXPECT_THROW(readResult(model.string(), {}), ToolError);
}

TEST_F(ViewedSample, OfOneCloudIsStructureWhereItHasLabels)
{
  const ViewedResult one =
      readResult((folder_.path() / "model/structure.pcd").string(), {});
  EXPECT_TRUE(one.firstLayers() == LayerSet{Layer::Structure});
  ReadSettings few;
  few.max_points = 500;
  const ViewedResult raw = readResult((folder_.path() / "scan.pcd").string(), few);
  EXPECT_TRUE(raw.firstLayers() == LayerSet{Layer::Raw});
  EXPECT_EQ(raw.raw.size(), 500u);
  EXPECT_EQ(raw.raw.whole_size, sample_.scan.points.size());
}

TEST_F(ViewedSample, OfOneTextIsReadByItsColumns)
{
  const auto path = folder_.path() / "scan.csv";
  std::ofstream(path) << "7,1,2,3\n7,4,5,6\n";
  ReadSettings settings;
  settings.file.columns = "_,x,y,z";
  const ViewedResult text = readResult(path.string(), settings);
  EXPECT_EQ(text.raw.size(), 2u);
  EXPECT_EQ(text.bounds().max(), Eigen::Vector3d(4, 5, 6));
}

TEST_F(ViewedSample, OfOneFileIsThePlanOrTheMeshThatItHolds)
{
  const auto model = folder_.path() / "model";
  const ViewedResult plan = readResult((model / "floorplan.json").string(), {});
  EXPECT_TRUE(plan.firstLayers() == LayerSet{Layer::Plan});
  EXPECT_EQ(plan.plan.rooms.size(), 2u);
  const ViewedResult mesh = readResult((model / "mesh.ply").string(), {});
  EXPECT_TRUE(mesh.firstLayers() == LayerSet{Layer::Mesh});
  EXPECT_EQ(mesh.mesh.triangles.size(), sample_.mesh.triangles.size());
  const ViewedResult solid = readResult((model / "solid.ply").string(), {});
  EXPECT_TRUE(solid.firstLayers() == LayerSet{Layer::Solid});
  EXPECT_EQ(solid.solid_names.size(), sample_.elements.size());
  EXPECT_THROW(readResult((model / "report.json").string(), {}), ToolError);
}

TEST_F(ViewedSample, OfACloudReadInPiecesTheSamePointsAreShown)
{
  const std::string path = (folder_.path() / "scan.pcd").string();
  constexpr std::size_t most = 700;
  const DisplayCloud whole = displayCloudOf(ScanFile(path), most);
  const DisplayCloud pieces = displayCloudOf(ScanFile(path, inPieces(100)), most);
  ASSERT_EQ(whole.size(), most);
  EXPECT_EQ(whole.points[0].x(), sample_.scan.points[0].x);
  EXPECT_EQ(pieces.points, whole.points);
  EXPECT_EQ(pieces.labels, whole.labels);
  EXPECT_EQ(pieces.whole_size, sample_.scan.points.size());
  EXPECT_EQ(thinnedCloudOf(ScanFile(path, inPieces(100)), 0.1).points,
            result_.thinned.points);
}

/** A point at 1e6 m would reduce the room to a dot. */
TEST_F(ViewedSample, OfAScanWithAStrayPointTheRoomFillsTheView)
{
  std::vector<std::vector<float>> points;
  for (int k = 0; k < 2000; ++k)
    points.push_back({0.1F * static_cast<float>(k % 50),
                      0.1F * static_cast<float>(k / 50), k % 2 == 0 ? 0 : 2.5F});
  points.push_back({20, 2, 1}); // seen through a window
  points.push_back({1e6F, 3e38F, -1e6F});
  const auto path = folder_.path() / "stray.pcd";
  SampleResult::write(path, pcdBytes(points, std::vector<std::uint32_t>(2002, 3)));
  const DisplayCloud shown = readResult(path.string(), {}).structure;
  EXPECT_EQ(shown.whole_size, 2002u);
  EXPECT_EQ(shown.size(), 2001u);
  EXPECT_EQ(shown.labels.size(), 2001u);
  SampleResult::write(path, pcdBytes(points));
  const Eigen::AlignedBox3d bounds = readResult(path.string(), {}).bounds();
  EXPECT_NEAR(bounds.max().x(), 20, 1e-6);
  EXPECT_NEAR(bounds.max().y(), 3.9, 1e-6);
  SampleResult::write(folder_.path() / "scan.pcd", pcdBytes(points));
  const auto model = readResult((folder_.path() / "model").string(), {});
  EXPECT_GT(model.thinned.size(), 1000u);
  for (const auto& p : model.thinned.points)
    EXPECT_LT(p.cwiseAbs().maxCoeff(), 21);
}

} // namespace
