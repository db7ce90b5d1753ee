// SPDX-License-Identifier: BSD-3-Clause
#include "simulator/scene/building.h"
#include "simulator/scene/scenes.h"
#include "simulator/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>

namespace {

using namespace pcl::sedr::sim;
using pcl::sedr::sim::test::TemporaryFolder;

struct Row {
  float x, y, z;
  std::uint32_t label;
};

std::vector<Row>
rowsOf(const std::filesystem::path& path)
{
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  const std::string end = "DATA binary\n";
  const std::size_t begin = bytes.find(end) + end.size();
  EXPECT_EQ((bytes.size() - begin) % sizeof(Row), 0u);
  std::vector<Row> rows((bytes.size() - begin) / sizeof(Row));
  std::memcpy(rows.data(), bytes.data() + begin, rows.size() * sizeof(Row));
  EXPECT_NE(bytes.find("POINTS " + std::to_string(rows.size()) + "\n"),
            std::string::npos);
  return rows;
}

class Building : public ::testing::Test {
protected:
  BuildingScan write(const std::string& name, std::size_t points, double noise)
  {
    ScanOptions options;
    options.rays_per_station = 3000;
    options.noise = noise;
    return writeBuilding(folder_.path() / name, sceneNamed("l_room"), points, options);
  }

  TemporaryFolder folder_;
};

TEST_F(Building, CopiesStandInRowsWithAWallBetween)
{
  const BuildingScan one = write("one.pcd", 1, 0);
  ASSERT_EQ(one.copies, 1u);
  const std::vector<Row> room = rowsOf(folder_.path() / "one.pcd");
  ASSERT_EQ(room.size(), one.points);
  const BuildingScan six = write("six.pcd", 6 * one.points + 10, 0);
  ASSERT_EQ(six.copies, 6u);
  const std::vector<Row> rows = rowsOf(folder_.path() / "six.pcd");
  ASSERT_EQ(rows.size(), 6 * room.size());

  float width = 0;
  for (const Row& row : room)
    width = std::max(width, row.x);
  const float pitch = rows[room.size()].x - room[0].x;
  EXPECT_NEAR(pitch, width + 0.3, 0.02);
  for (std::size_t i = 0; i < room.size(); ++i) {
    ASSERT_NEAR(rows[room.size() + i].x, room[i].x + pitch, 1e-5);
    ASSERT_EQ(rows[room.size() + i].y, room[i].y);
    ASSERT_EQ(rows[5 * room.size() + i].z, room[i].z);
    ASSERT_EQ(rows[5 * room.size() + i].label, room[i].label);
  }
  EXPECT_GT(rows[5 * room.size()].y, room[0].y + 1) << "the last is in another row";
}

TEST_F(Building, EveryCopyHasNoiseOfItsOwnAndTheSameSeedTheSameBytes)
{
  const BuildingScan exact = write("exact.pcd", 1, 0);
  write("noisy.pcd", 2 * exact.points, 0.01);
  write("again.pcd", 2 * exact.points, 0.01);
  const auto truth = rowsOf(folder_.path() / "exact.pcd");
  const auto noisy = rowsOf(folder_.path() / "noisy.pcd");
  const auto again = rowsOf(folder_.path() / "again.pcd");
  EXPECT_EQ(std::memcmp(noisy.data(), again.data(), noisy.size() * sizeof(Row)), 0);
  double squares = 0;
  std::size_t same = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double dx = noisy[i].x - truth[i].x;
    const double dy = noisy[i].y - truth[i].y;
    const double dz = noisy[i].z - truth[i].z;
    squares += dx * dx + dy * dy + dz * dz;
    same += noisy[i].z == noisy[truth.size() + i].z ? 1 : 0;
  }
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(truth.size())), 0.01, 0.001);
  EXPECT_LT(same, truth.size() / 100);
}

} // namespace
