// SPDX-License-Identifier: BSD-3-Clause
#include "sample_rooms.h"
#include "simulator/truth/files.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <cstring>

namespace pcl::sedr::sim::test {
namespace {

template <typename T>
T
valueAt(const std::string& bytes, std::size_t offset)
{
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof(T));
  return value;
}

TEST(Files, pcdHoldsItsPointsAfterTheHeader)
{
  const TemporaryFolder folder;
  writePcd(folder.path() / "a.pcd",
           {{1.5F, 2.5F, -3.5F, 3, 1}, {0.0F, 0.0F, 1.0F, 0, 0}});
  const std::string bytes = bytesOf(folder.path() / "a.pcd");
  EXPECT_NE(bytes.find("FIELDS x y z label room\nSIZE 4 4 4 4 4\nTYPE F F F U U\n"),
            std::string::npos);
  EXPECT_NE(bytes.find("WIDTH 2\nHEIGHT 1\n"), std::string::npos);
  const std::string last = "DATA binary\n";
  const std::size_t data = bytes.find(last) + last.size();
  ASSERT_EQ(bytes.size(), data + 40);
  EXPECT_EQ(valueAt<float>(bytes, data + 8), -3.5F);
  EXPECT_EQ(valueAt<std::uint32_t>(bytes, data + 12), 3U);
  EXPECT_EQ(valueAt<std::uint32_t>(bytes, data + 16), 1U);
  EXPECT_EQ(valueAt<float>(bytes, data + 28), 1.0F);
}

TEST(Files, plyHoldsPlacedVerticesAndLabelledFaces)
{
  const TemporaryFolder folder;
  Mesh mesh;
  mesh.vertices = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
  mesh.faces = {{{0, 1, 2}, Label::Wall, 2}};
  writePly(folder.path() / "a.ply", mesh, {90.0, {5.0, 0.0, 1.0}});
  const std::string bytes = bytesOf(folder.path() / "a.ply");
  EXPECT_EQ(bytes.rfind("ply\nformat binary_little_endian 1.0\n", 0), 0U);
  const std::string last = "end_header\n";
  const std::size_t data = bytes.find(last) + last.size();
  ASSERT_EQ(bytes.size(), data + 36 + 1 + 12 + 8);
  EXPECT_FLOAT_EQ(valueAt<float>(bytes, data + 12), 5.0F); // (1, 0) turned to (0, 1)
  EXPECT_FLOAT_EQ(valueAt<float>(bytes, data + 16), 1.0F);
  EXPECT_FLOAT_EQ(valueAt<float>(bytes, data + 20), 1.0F);
  EXPECT_EQ(valueAt<std::uint8_t>(bytes, data + 36), 3U);
  EXPECT_EQ(valueAt<std::int32_t>(bytes, data + 45), 2);
  EXPECT_EQ(valueAt<std::int32_t>(bytes, data + 49), 3);
  EXPECT_EQ(valueAt<std::int32_t>(bytes, data + 53), 2);
}

TEST(Files, failureLeavesTheOldFileAndNoRemains)
{
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "taken.pcd");
  EXPECT_THROW(writePcd(folder.path() / "taken.pcd", {}), std::runtime_error);
  EXPECT_THROW(writePcd(folder.path() / "none" / "a.pcd", {}), std::runtime_error);
  const auto begin = std::filesystem::directory_iterator(folder.path());
  EXPECT_EQ(std::distance(begin, std::filesystem::directory_iterator()), 1);
}

} // namespace
} // namespace pcl::sedr::sim::test
