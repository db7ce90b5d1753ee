// SPDX-License-Identifier: BSD-3-Clause
#include "tool_cloud.h"
#include "tool_contract.h"

#include <gtest/gtest.h>

namespace {

using namespace programs;
using pcl::sedr::tools::floatField;
using pcl::sedr::tools::loadCloud;
using pcl::sedr::tools::ToolCloud;

INSTANTIATE_TEST_SUITE_P(WallGrowing,
                         ToolContract,
                         ::testing::Values(CEILING_BOUNDARY_WALL_GROWING));

class WallGrowingTool : public InFolder<> {
protected:
  void add(double x, double y, double z, int label, int room)
  {
    lines_ += std::to_string(x) + ' ' + std::to_string(y) + ' ' + std::to_string(z) +
              ' ' + std::to_string(label) + ' ' + std::to_string(room) + ' ' +
              std::to_string(count_) + '\n';
    ++count_;
  }

  /** @brief Adds 21 x 21 points over 2 m x 2 m. */
  void addSlab(double x, double z, int label, int room)
  {
    for (int i = 0; i < 441; ++i)
      add(x + 0.1 * (i % 21), 0.1 * (i / 21), z, label, room);
  }

  ProgramRun grow(const std::vector<std::string>& options = {})
  {
    writeFile(in("input.pcd"), "FIELDS x y z label room intensity\nSIZE 4 4 4 1 2 8\n"
                               "TYPE F F F U U F\nWIDTH " +
                                   std::to_string(count_) + "\nDATA ascii\n" + lines_);
    return run(CEILING_BOUNDARY_WALL_GROWING, {in("input.pcd"), in("output.pcd")},
               options);
  }

  /** @brief Returns the labels of the points from index `first` on. */
  std::vector<std::uint32_t> labelsFrom(std::size_t first) const
  {
    const ToolCloud cloud = loadCloud(in("output.pcd"));
    return {cloud.label.begin() + static_cast<std::ptrdiff_t>(first),
            cloud.label.end()};
  }

  std::string lines_;
  std::size_t count_ = 0;
};

using Whole = std::vector<std::uint32_t>;

TEST_F(WallGrowingTool, GrowsEveryRoomByItselfAndGivesSharedPointsToTheNearer)
{
  addSlab(0, 2.5, 1, 1);
  addSlab(2.1, 2.5, 1, 2); // behind a wall of 10 cm
  const std::size_t first = count_;
  add(2.03, 1, 1, 0, 0); // face of the wall in room 1
  add(2.07, 1, 1, 0, 0); // face of the wall in room 2
  add(2.03, 1, 2, 0, 2); // said to be of room 2
  add(-0.05, 1, 1, 3, 1);
  add(1, 1, 1, 3, 1); // labelled wall
  add(-0.05, 1, 2, 5, 1);
  const ProgramRun result = grow();
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out + result.err, "") << "quiet when piped";

  EXPECT_EQ(labelsFrom(first), (Whole{3, 3, 3, 3, 0, 5}));
  const ToolCloud cloud = loadCloud(in("output.pcd"));
  const Whole rooms(cloud.room.begin() + static_cast<std::ptrdiff_t>(first),
                    cloud.room.end());
  EXPECT_EQ(rooms, (Whole{1, 2, 1, 1, 1, 1}));
  const auto intensity = floatField(cloud.blob, "intensity");
  for (std::size_t i = 0; i < count_; ++i)
    EXPECT_EQ(intensity[i], static_cast<float>(i));
}

TEST_F(WallGrowingTool, SlicesAtTheLowestDetail)
{
  addSlab(0, 2.5, 1, 0);
  addSlab(2.1, 2.0, 4, 0); // soffit
  addSlab(0, 0, 2, 0);
  addSlab(2.1, 0, 2, 0);
  const std::size_t first = count_;
  add(2.05, 1, 2.2, 0, 0); // at the riser
  add(2.05, 1, 1.9, 0, 0); // below the riser is air, not wall
  add(4.15, 1, 1.9, 0, 0);
  EXPECT_EQ(grow().exit_code, 0);
  EXPECT_EQ(labelsFrom(first), (Whole{3, 0, 3}));
}

TEST_F(WallGrowingTool, SaysWhatIsMissing)
{
  addSlab(0, 0, 2, 0);
  expectSentence(grow(), 2, "ceiling");
  addSlab(0, 2.5, 1, 0);
  add(1, 1, 1, 0, 0);
  expectSentence(grow(), 2);
  EXPECT_FALSE(std::filesystem::exists(in("output.pcd")));
}

} // namespace
