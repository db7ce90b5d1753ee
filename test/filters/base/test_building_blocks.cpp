// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include <pcl/sedr_filters/cell_grid.h>
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/scan_frame.h>

#include <pcl/conversions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

// The examples of doc/building_blocks.md, verbatim.

namespace {

using namespace sedr_test;

TEST(BuildingBlocks, TheAreaOfTheLargestRoom)
{
  RoomPoints scan;
  std::vector<int> ceiling = scan.slab(rectangle(0, 0, 4, 3), 2.5);
  ceiling = joined(ceiling, scan.slab(rectangle(5, 0, 7, 3), 2.7));
  const auto shared = scan.cloud();
  const auto& cloud = *shared;
  // clang-format off
const pcl::sedr::PointView points(cloud); // any point type
const pcl::sedr::CellGrid grid(0.05);
const pcl::sedr::CellSet cells(grid, points, ceiling);
const pcl::sedr::CellRegions rooms = pcl::sedr::labelRegions(cells);
const double area = static_cast<double>(rooms.sizes[0]) * grid.size() * grid.size();
  // clang-format on
  EXPECT_EQ(rooms.sizes.size(), 2u);
  EXPECT_NEAR(area, 12, 0.4);
}

TEST(BuildingBlocks, TheStoreysOfAPlan)
{
  pcl::sedr::Floorplan two{
      {roomOf(rectangle(0, 0, 4, 3), 2.5), roomOf(rectangle(5, 0, 7, 3), 2.7)}};
  two.rooms[1].id = 2;
  const std::string json = pcl::sedr::floorplanToJson(two);
  std::ostringstream told;
  std::streambuf* const was = std::cout.rdbuf(told.rdbuf());
  // clang-format off
std::string problem; // why the plan was refused, if it was
const pcl::sedr::Floorplan plan = pcl::sedr::floorplanFromJson(json, problem);
for (const auto& storey : pcl::sedr::storeysOf(plan)) {
  std::cout << pcl::sedr::storeyName(storey.number) << ": "
            << pcl::sedr::partOf(plan, storey).rooms.size() << " rooms\n";
}
  // clang-format on
  std::cout.rdbuf(was);
  EXPECT_EQ(problem, "");
  EXPECT_EQ(told.str(), "storey 1: 2 rooms\n");
}

TEST(BuildingBlocks, APlaceOfATiltedScanFarFromTheOrigin)
{
  const Eigen::Vector3d up = Eigen::Vector3d(0.01, 0, 1).normalized();
  // clang-format off
const pcl::sedr::Origin origin{{691600, 5335900, 0}};
const Eigen::Vector3d place = origin.toLocal({691612.25, 5335907.5, 1.2});
const auto levelling = pcl::sedr::Levelling::of(up, Eigen::Vector3d::Zero());
const Eigen::Vector3d level = levelling.level(place);
  // clang-format on
  EXPECT_EQ(place, Eigen::Vector3d(12.25, 7.5, 1.2));
  EXPECT_NEAR(level.z(), up.dot(place), 1e-12);
  EXPECT_NEAR(level.norm(), place.norm(), 1e-12);
}

TEST(BuildingBlocks, TheHeightOfAVault)
{
  // clang-format off
pcl::sedr::SlabCurve vault; // a barrel of 2 m radius, its axis along x, 1 m up
vault.base = 1;
vault.across = vault.up = 2;
const double top = vault.heightAt({5, 0});
const double off = vault.distanceAbove({5, 0, 2.9}); // below the surface: negative
  // clang-format on
  EXPECT_NEAR(top, 3, 1e-12);
  EXPECT_NEAR(off, -0.1, 1e-12);
}

TEST(BuildingBlocks, ACloudInPieces)
{
  // clang-format off
class Rows : public pcl::sedr::RowSource {
public:
  explicit Rows(const pcl::PCLPointCloud2& blob) : blob_(blob) {}

  const std::vector<pcl::PCLPointField>& fields() const override { return blob_.fields; }
  std::size_t rowSize() const override { return blob_.point_step; }
  std::size_t size() const override { return blob_.data.size() / rowSize(); }

  void forEachPiece(const std::function<bool(const Piece&)>& see) const override
  {
    constexpr std::size_t most = 1000; // rows a piece
    for (std::size_t first = 0; first < size(); first += most)
      if (!see({&blob_.data[first * rowSize()], first, std::min(most, size() - first)}))
        return;
  }

private:
  const pcl::PCLPointCloud2& blob_;
};
  // clang-format on
  RoomPoints scan;
  scan.slab(rectangle(0, 0, 4, 3), 2.5);
  pcl::PCLPointCloud2 blob;
  pcl::toPCLPointCloud2(*scan.cloud(), blob);
  const Rows rows(blob);
  std::size_t seen = 0;
  rows.forEachPiece([&](const Rows::Piece& piece) {
    EXPECT_EQ(piece.first, seen);
    seen += piece.size;
    return true;
  });
  EXPECT_EQ(seen, scan.size());
}

TEST(BuildingBlocks, APointOfTheStructure)
{
  // clang-format off
pcl::PointStructure point;
point.label = static_cast<std::uint32_t>(pcl::sedr::StructureLabel::Wall);
point.room = 2;
pcl::PointCloud<pcl::PointStructure> structure;
structure.push_back(point);
const pcl::sedr::PointView coordinates(structure); // no copy, whatever the type
  // clang-format on
  EXPECT_EQ(coordinates.size(), 1u);
  EXPECT_EQ(coordinates[0], Eigen::Vector3f::Zero());
  EXPECT_EQ(structure[0].label, 3u);
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
  EXPECT_EQ(examples, 6u);
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
      if (header.extension() != ".h") // folders contain the implementation
        continue;
      ++headers;
      const fs::path own_page = root / "doc" / (header.stem().string() + ".md");
      EXPECT_TRUE(fs::exists(own_page) ||
                  page.find('`' + header.string() + '`') != std::string::npos)
          << name << '/' << header.string();
    }
    EXPECT_GT(headers, 4u) << name;
  }
}

TEST(BuildingBlocks, WhatIsInstalledIncludesOnlyWhatIsInstalled)
{
  namespace fs = std::filesystem;
  const fs::path root(PROJECT_FOLDER);
  std::size_t includes = 0;
  for (const std::string name : {"sedr_filters", "sedr_segmentation", "sedr_surface"})
    for (const auto& entry :
         fs::recursive_directory_iterator(root / name / "include")) {
      if (!entry.is_regular_file())
        continue;
      std::ifstream file(entry.path());
      for (std::string line; std::getline(file, line);) {
        if (line.rfind("#include", 0) != 0)
          continue;
        EXPECT_EQ(line.find('"'), std::string::npos) << entry.path() << ": " << line;
        const auto own = line.find("<pcl/sedr_");
        if (own == std::string::npos)
          continue;
        const std::string header = line.substr(own + 1, line.find('>') - own - 1);
        const std::string module = header.substr(4, header.find('/', 4) - 4);
        EXPECT_TRUE(fs::exists(root / module / "include" / header)) << header;
        ++includes;
      }
    }
  EXPECT_GT(includes, 50u);
}

} // namespace
