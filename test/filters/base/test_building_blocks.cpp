// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include <pcl/sedr_filters/cell_mask.h>
#include <pcl/sedr_filters/plane_fit.h>

#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_filters/plan_surfaces.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

// The examples of doc/building_blocks.md, word for word.

namespace {

using namespace sedr_test;

TEST(BuildingBlocks, TheLargestRoomAndThePlaneOfItsCeiling)
{
  RoomPoints scan;
  const auto hasNoLamp = [](double x, double y) {
    return std::abs(x - 2) > 0.2 || std::abs(y - 1.5) > 0.2;
  };
  std::vector<int> ceiling = scan.slab(rectangle(0, 0, 4, 3), 2.5, hasNoLamp);
  ceiling = joined(ceiling, scan.slab(rectangle(5, 0, 7, 3), 2.7));
  const auto shared = scan.cloud();
  const auto& cloud = *shared;
  // clang-format off
const pcl::sedr::PointView points(cloud); // any point type
const pcl::sedr::CellGrid grid(0.05);
const pcl::sedr::CellSet cells(grid, points, ceiling);
const pcl::sedr::CellRegions rooms = pcl::sedr::labelRegions(cells);

// The cells of the largest region, and those that are enclosed by it.
pcl::sedr::CellMask room(pcl::sedr::grown(pcl::sedr::boxOf(cells), 1));
for (std::size_t i = 0; i < cells.size(); ++i)
  if (rooms.label[i] == 0)
    room.set(cells[i], 1);
room = pcl::sedr::unite(room, pcl::sedr::enclosedCells(room));
const double area = static_cast<double>(room.count()) * grid.size() * grid.size();

std::vector<int> own;
for (const int i : ceiling)
  if (room.at(grid.at(cloud[i].x, cloud[i].y)) != 0)
    own.push_back(i);
const pcl::sedr::PlanSlab slab =
    pcl::sedr::findSlab(points, own, 0.07, M_PI / 60, 1); // leans 3 degrees at most
const double height = slab.heightAt(grid.centre(room.toSet()[0]));
  // clang-format on
  EXPECT_EQ(rooms.sizes.size(), 2u);
  EXPECT_NEAR(area, 12, 0.4);
  EXPECT_NEAR(height, 2.5, 1e-5);
}

TEST(BuildingBlocks, APlaceOnThePlan)
{
  const std::string json =
      pcl::sedr::floorplanToJson({{roomOf(rectangle(0, 0, 4, 3), 2.5)}});
  const Eigen::Vector3d scanned(4.05, 1, 1.2);
  std::ostringstream told;
  std::streambuf* const was = std::cout.rdbuf(told.rdbuf());
  // clang-format off
std::string problem; // why the plan was refused, if it was
const pcl::sedr::Floorplan plan = pcl::sedr::floorplanFromJson(json, problem);
for (const auto& room : plan.rooms) {
  pcl::sedr::SurfacePoint snapped;
  if (pcl::sedr::snapToRoom(room, pcl::sedr::uprightSurfaces(room), scanned,
                            pcl::sedr::StructureLabel::Wall, 0.2, snapped))
    std::cout << room.id << ": " << snapped.position.transpose() << '\n';
}
  // clang-format on
  std::cout.rdbuf(was);
  EXPECT_EQ(problem, "");
  EXPECT_EQ(told.str(), "1:   4   1 1.2\n");
}

std::string
textOf(const std::string& path)
{
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

TEST(BuildingBlocks, ThePageShowsWhatIsCompiledHere)
{
  const std::string page = textOf(BUILDING_BLOCKS_PAGE);
  const std::string source = textOf(BUILDING_BLOCKS_SOURCE);
  std::size_t examples = 0;
  const std::string fence = "```cpp\n";
  for (auto at = page.find(fence); at != std::string::npos; at = page.find(fence, at)) {
    at += fence.size();
    const std::string code = page.substr(at, page.find("```", at) - at);
    const auto body = code.find("\n\n") + 2; // after the #include lines
    EXPECT_NE(source.find(code.substr(0, body - 1)), std::string::npos) << code;
    EXPECT_NE(source.find(code.substr(body)), std::string::npos) << code;
    ++examples;
  }
  EXPECT_EQ(examples, 2u);
}

TEST(BuildingBlocks, EveryPublicHeaderHasARowOrAPage)
{
  namespace fs = std::filesystem;
  const fs::path root(PROJECT_FOLDER);
  const std::string page = textOf(BUILDING_BLOCKS_PAGE);
  for (const std::string module : {"filters", "segmentation", "surface"}) {
    const std::string name = "sedr_" + module;
    std::size_t headers = 0;
    for (const auto& entry :
         fs::directory_iterator(root / name / "include" / "pcl" / name)) {
      const fs::path header = entry.path().filename();
      if (header.extension() != ".h") // folders: the insides of classes
        continue;
      ++headers;
      const fs::path own_page = root / "doc" / (header.stem().string() + ".md");
      EXPECT_TRUE(fs::exists(own_page) ||
                  page.find('`' + header.string() + '`') != std::string::npos)
          << name << '/' << header.string();
    }
    EXPECT_GT(headers, 20u) << name;
  }
}

} // namespace
