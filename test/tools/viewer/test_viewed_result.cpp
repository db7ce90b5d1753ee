// SPDX-License-Identifier: BSD-3-Clause
#include "scan_file.h"
#include "tool_error.h"
#include "tools/sample_files.h"
#include "viewed_sample.h"

#include <fstream>

namespace {

using namespace programs;
using namespace pcl::sedr;
using namespace pcl::sedr::tools;

/** Returns the layers of a file or folder of the sample. */
std::vector<std::string>
layersOf(const std::filesystem::path& path)
{
  const ViewedResult result = readResult(path.string(), {});
  std::vector<std::string> layers;
  for (const std::string& layer : layer_names)
    if (result.has(layer))
      layers.push_back(layer);
  return layers;
}

using Layers = std::vector<std::string>;

TEST_F(ViewedSample, IsReadWithAllItsLayers)
{
  for (const auto& layer : layer_names)
    EXPECT_EQ(result_.has(layer), layer != "openings") << layer;
  EXPECT_EQ(result_.clouds.at("scan").size(), sample_.scan.points.size());
  EXPECT_TRUE(result_.clouds.at("scan").labels.empty());
  EXPECT_TRUE(result_.notes.empty());
  EXPECT_NEAR(result_.bounds().max().z(), 2.5, 1e-6);
}

TEST_F(ViewedSample, IsReadInPartWhereFilesAreMissing)
{
  const auto model = folder_.path() / "model";
  for (const char* name : {"mesh.ply", "solid.ply", "structure.pcd"})
    std::filesystem::remove(model / name);
  std::filesystem::remove(folder_.path() / "scan.pcd");
  EXPECT_EQ(layersOf(model), Layers{"plan"});
  const ViewedResult rest = readResult(model.string(), {});
  EXPECT_EQ(rest.notes.size(), 1u) << "the scan";
  EXPECT_NEAR(rest.bounds().max().z(), 2.5, 1e-6);
  for (const char* name : {"floorplan.json", "report.json"})
    std::filesystem::remove(model / name);
  EXPECT_THROW(readResult(model.string(), {}), ToolError);
}

TEST_F(ViewedSample, OfOneFileIsWhatItHolds)
{
  const auto model = folder_.path() / "model";
  EXPECT_EQ(layersOf(model / "floorplan.json"), Layers{"plan"});
  EXPECT_EQ(layersOf(model / "mesh.ply"), Layers{"mesh"});
  EXPECT_EQ(layersOf(model / "solid.ply"), Layers{"solid"});
  EXPECT_EQ(layersOf(model / "structure.pcd"), Layers{"structure"});
  EXPECT_EQ(layersOf(folder_.path() / "scan.pcd"), Layers{"scan"});
  EXPECT_THROW(readResult((model / "report.json").string(), {}), ToolError);
  const auto text = folder_.path() / "scan.csv";
  std::ofstream(text) << "1,2,3\n4,5,6\n";
  EXPECT_EQ(readResult(text.string(), {}).bounds().max(), Eigen::Vector3d(4, 5, 6));
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
  const DisplayCloud shown = readResult(path.string(), {}).clouds.at("structure");
  EXPECT_EQ(shown.whole_size, 2002u);
  EXPECT_EQ(shown.size(), 2001u);
  EXPECT_EQ(shown.labels.size(), 2001u);
  SampleResult::write(path, pcdBytes(points));
  EXPECT_NEAR(readResult(path.string(), {}).bounds().max().x(), 20, 1e-6);
}

} // namespace
