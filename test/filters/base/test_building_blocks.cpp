// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

// As the examples have them, verbatim.
#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_filters/plan_measures.h>

#include <pcl/sedr_filters/plan_warning.h>

#include <pcl/sedr_filters/point_view.h>

#include <pcl/sedr_filters/scan_frame.h>

#include <pcl/point_cloud.h>
#include <pcl/sedr_filters/impl/stage_error.h>
#include <pcl/sedr_filters/impl/stage_filter.hpp>
#include <pcl/sedr_filters/parallel_voxel_grid.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

// The examples of the pages of building blocks, verbatim.

namespace {

using namespace sedr_test;

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

TEST(BuildingBlocks, TheWarningsOfAPlan)
{
  const std::vector<pcl::sedr::PlanWarning> warnings{
      {pcl::sedr::WarningKind::NoDoor, {12}, 3}};
  std::ostringstream told;
  std::streambuf* const was = std::cerr.rdbuf(told.rdbuf());
  // clang-format off
for (const pcl::sedr::PlanWarning& warning : warnings) {
  std::cerr << sentenceOf(warning) << '\n';
}
  // clang-format on
  std::cerr.rdbuf(was);
  EXPECT_NE(told.str().find("room 3"), std::string::npos) << told.str();
}

TEST(BuildingBlocks, PointsOfAnyTypeAndTheirOrigin)
{
  pcl::PointCloud<pcl::PointNormal> cloud;
  cloud.resize(3);
  cloud[1].x = std::nanf("");
  // clang-format off
const pcl::sedr::PointView points(cloud); // of any point type
std::size_t finite = 0;
for (std::size_t i = 0; i < points.size(); ++i) {
  finite += points.isFinite(i) ? 1 : 0;
}
  // clang-format on
  EXPECT_EQ(finite, 2u);
  // clang-format off
const pcl::sedr::Origin origin{{691600, 5335900, 0}};
const Eigen::Vector3f p = origin.toLocal({691612.25, 5335907.5, 1.2}).cast<float>();
  // clang-format on
  EXPECT_EQ(p, Eigen::Vector3f(12.25F, 7.5F, 1.2F));
}

std::string
textOf(const std::string& path)
{
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

const char* const pages[] = {"building_blocks.md", "floorplan.md",
                             "points_and_frames.md"};

std::string
pageOf(const std::string& name)
{
  return textOf(std::string(PROJECT_FOLDER) + "/doc/" + name);
}

TEST(BuildingBlocks, PagesShowWhatIsCompiledHere)
{
  const std::string source = textOf(BUILDING_BLOCKS_SOURCE);
  std::size_t examples = 0;
  const std::string fence = "```cpp\n";
  for (const char* name : pages) {
    const std::string page = pageOf(name);
    for (auto at = page.find(fence); at != std::string::npos;
         at = page.find(fence, at)) {
      at += fence.size();
      const std::string code = page.substr(at, page.find("```", at) - at);
      const auto body = code.find("\n\n") + 2; // after the #include lines
      EXPECT_NE(source.find(code.substr(0, body - 1)), std::string::npos) << code;
      EXPECT_NE(source.find(code.substr(body)), std::string::npos) << code;
      ++examples;
    }
  }
  EXPECT_EQ(examples, 4u);
}

TEST(BuildingBlocks, EveryPublicHeaderIsOnAPage)
{
  namespace fs = std::filesystem;
  const fs::path root(PROJECT_FOLDER);
  std::string all;
  for (const char* name : pages)
    all += pageOf(name);
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
                  all.find('`' + header.string() + '`') != std::string::npos)
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

TEST(StageIndices, AreSharedByPointerAndNoneFromNull)
{
  using pcl::sedr::StageIndices;
  const pcl::PointIndices::Ptr found(new pcl::PointIndices);
  found->indices = {3, 1};
  EXPECT_EQ(StageIndices(found).get().get(), &found->indices);
  EXPECT_EQ(*StageIndices(pcl::Indices{2}).get(), pcl::Indices{2});
  EXPECT_EQ(StageIndices(nullptr).get(), nullptr);
  EXPECT_EQ(pcl::sedr::indicesProblem("floor", StageIndices(found).get(), 3),
            "floor index 3 is out of range, the cloud has 3 points");
  EXPECT_EQ(pcl::sedr::indicesInRange({-1, 0, 3}, 3), pcl::Indices{0});
  EXPECT_NE(pcl::sedr::lengthProblem("the grid size", std::nan("")), "");
}

/** A stage that keeps nothing and cannot work on fewer than two points. */
struct PickyFilter : pcl::sedr::StageFilter<pcl::PointXYZ> {
  PickyFilter()
      : StageFilter(true)
  {}

  void applyFilter(PointCloud& output) override
  {
    startRun(output);
    if (input_->size() < 2)
      failRun("at least 2 points are needed, there is 1");
  }
};

TEST(StageFilter, TellsWhyItFailedAndRemovesAll)
{
  PickyFilter filter;
  pcl::PointCloud<pcl::PointXYZ> output;
  output.resize(3);
  filter.filter(output);
  EXPECT_EQ(filter.getErrorMessage(), "no input cloud was set");
  EXPECT_TRUE(output.empty());
  const pcl::PointCloud<pcl::PointXYZ>::Ptr one(new pcl::PointCloud<pcl::PointXYZ>);
  one->push_back({});
  filter.setInputCloud(one);
  filter.filter(output);
  EXPECT_EQ(filter.getErrorMessage(), "at least 2 points are needed, there is 1");
  EXPECT_EQ(*filter.getRemovedIndices(), pcl::Indices{0});
  one->push_back({});
  filter.filter(output);
  EXPECT_EQ(filter.getErrorMessage(), "");
}

TEST(VoxelGridSettings, AreThoseOfPclsVoxelGrid)
{
  struct Settings : pcl::sedr::VoxelGridSettings {
  } settings;
  EXPECT_EQ(settings.getLeafSize(), Eigen::Vector3f::Constant(0.05F));
  settings.setLeafSize(Eigen::Vector4f(0.1F, 0.2F, 0.5F, 7));
  EXPECT_EQ(settings.getLeafSize(), Eigen::Vector3f(0.1F, 0.2F, 0.5F));
  EXPECT_EQ(settings.getMinimumPointsNumberPerVoxel(), 0u);
  EXPECT_FALSE(settings.getRemoveStrays());
}

} // namespace
