// SPDX-License-Identifier: BSD-3-Clause
#include "scan_file.h"
#include "tool_cloud.h"
#include "tool_error.h"
#include "tools/run_program.h"
#include "tools/sample_files.h"

#include "sedr_segmentation/src/scan/scan_excerpt.h"
#include "tools/reading_settings.h"
#include <pcl/conversions.h>
#include <pcl/sedr_filters/parallel_voxel_grid.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace {

using namespace pcl::sedr::tools;
using namespace programs;
using pcl::sedr::RowSource;
using programs::bytesOf;
using programs::TemporaryFolder;
using programs::writeFile;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

/** A room of 6 x 6 x 2 m; one in `nans` points is not finite, and one is far away. */
std::vector<std::vector<float>>
roomPoints(std::size_t n, std::size_t nans = 50)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<float> coordinate(-3, 3);
  std::vector<std::vector<float>> points;
  for (std::size_t i = 0; i < n; ++i) {
    const float x = coordinate(random);
    const float y = coordinate(random);
    points.push_back({x, y, coordinate(random) / 3});
    if (i % nans == 7)
      points.back()[i % 3] = nan;
  }
  points.push_back({6e5f, -3e4f, 600.f});
  return points;
}

/** The same points, each with a colour, a label and a normal. */
pcl::PCLPointCloud2
colouredRoom(std::size_t n)
{
  pcl::PointCloud<pcl::PointXYZRGBNormal> cloud;
  std::mt19937 random(4);
  for (const auto& p : roomPoints(n)) {
    pcl::PointXYZRGBNormal point;
    point.x = p[0];
    point.y = p[1];
    point.z = p[2];
    point.rgba = static_cast<std::uint32_t>(random()) | 0xff000000u;
    point.normal_x = 1;
    point.curvature = static_cast<float>(random() % 100);
    cloud.push_back(point);
  }
  pcl::PCLPointCloud2 blob;
  pcl::toPCLPointCloud2(cloud, blob);
  pcl::PCLPointCloud2 packed;
  for (const auto& field : blob.fields) {
    packed.fields.push_back(field);
    packed.fields.back().offset = packed.point_step;
    packed.point_step += 4;
  }
  packed.width = blob.width;
  packed.height = 1;
  packed.row_step = packed.width * packed.point_step;
  for (std::size_t i = 0; i < blob.width; ++i)
    for (const auto& field : blob.fields) {
      const auto* from = &blob.data[i * blob.point_step + field.offset];
      packed.data.insert(packed.data.end(), from, from + 4);
    }
  return packed;
}

pcl::PCLPointCloud2
thinned(const RowSource& source, unsigned threads, bool all_fields = true)
{
  pcl::ParallelVoxelGrid<pcl::PCLPointCloud2> grid;
  grid.setNumberOfThreads(threads);
  grid.setDownsampleAllData(all_fields);
  pcl::PCLPointCloud2 output;
  grid.filter(source, output);
  return output;
}

pcl::PCLPointCloud2
thinnedInMemory(const std::string& path)
{
  pcl::ParallelVoxelGrid<pcl::PCLPointCloud2> grid;
  grid.setInputCloud(std::make_shared<const pcl::PCLPointCloud2>(loadCloud(path).blob));
  pcl::PCLPointCloud2 output;
  grid.filter(output);
  return output;
}

class ScanFiles : public ::testing::Test {
protected:
  std::string in(const std::string& name) const
  {
    return (folder_.path() / name).string();
  }

  /** Expects the same from pieces that end inside a voxel, a page or a field's name. */
  void expectPiecesGiveTheSame(const std::string& path)
  {
    const pcl::PCLPointCloud2 expected = thinnedInMemory(path);
    ASSERT_GT(expected.width, 0u);
    for (const std::size_t piece : {std::size_t{1}, std::size_t{4099},
                                    std::size_t{100000}, std::size_t{1} << 26}) {
      if (piece == 1 && loadCloud(path).size() > 1000)
        continue;
      for (const unsigned threads : {1u, 2u, 3u, 8u})
        EXPECT_EQ(thinned(ScanFile(path, inPieces(piece)), threads).data, expected.data)
            << path << " by " << piece << " on " << threads;
    }
  }

  TemporaryFolder folder_;
};

TEST_F(ScanFiles, RowsFromOneToAnotherAreThoseOfTheWhole)
{
  const pcl::PCLPointCloud2 room = colouredRoom(2000);
  saveCloud(in("scan.pcd"), room);
  saveCloud(in("scan.ply"), room);
  saveCloud(in("packed.pcd"), room, PcdData::Compressed);
  for (const char* name : {"scan.pcd", "scan.ply", "packed.pcd"}) {
    const ScanFile scan(in(name), inPieces(5000));
    const pcl::PCLPointCloud2 whole = loadCloud(in(name)).blob;
    std::size_t next = 333;
    scan.forEachPiece(333, 1500, [&](const RowSource::Piece& piece) {
      EXPECT_EQ(piece.first, next);
      EXPECT_EQ(std::memcmp(piece.rows, &whole.data[next * whole.point_step],
                            piece.size * scan.rowSize()),
                0);
      next += piece.size;
      return true;
    });
    EXPECT_EQ(next, 1500u) << name;
  }
}

TEST_F(ScanFiles, HeadsTellRowsAndWhetherTheyComeInPieces)
{
  const pcl::PCLPointCloud2 room = colouredRoom(200);
  saveCloud(in("scan.pcd"), room);
  saveCloud(in("scan.ply"), room);
  saveCloud(in("packed.pcd"), room, PcdData::Compressed);
  EXPECT_EQ(readScanHead(in("scan.pcd")).rows, room.width);
  EXPECT_TRUE(readScanHead(in("scan.pcd")).is_in_pieces);
  EXPECT_EQ(readScanHead(in("scan.ply")).rows, room.width);
  EXPECT_TRUE(readScanHead(in("scan.ply")).is_in_pieces);
  EXPECT_EQ(readScanHead(in("packed.pcd")).rows, room.width);
  EXPECT_FALSE(readScanHead(in("packed.pcd")).is_in_pieces);
  EXPECT_THROW(readScanHead(in("missing.pcd")), ToolError);
}

TEST_F(ScanFiles, PiecesOfAnyFileGiveWhatTheWholeGives)
{
  const pcl::PCLPointCloud2 room = colouredRoom(20000);
  saveCloud(in("binary.pcd"), room);
  saveCloud(in("compressed.pcd"), room, PcdData::Compressed);
  saveCloud(in("binary.ply"), room);
  writeFile(in("xyz.pcd"), programs::pcdBytes(roomPoints(20000)));
  std::string ascii = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 3001\nDATA ascii\n";
  for (const auto& p : roomPoints(3000))
    for (int axis = 0; axis < 3; ++axis)
      ascii +=
          std::to_string(p[static_cast<std::size_t>(axis)]) + (axis < 2 ? " " : "\n");
  writeFile(in("ascii.pcd"), ascii);
  for (const char* name :
       {"binary.pcd", "compressed.pcd", "binary.ply", "xyz.pcd", "ascii.pcd"})
    expectPiecesGiveTheSame(in(name));
  EXPECT_EQ(thinnedInMemory(in("binary.pcd")).data,
            thinnedInMemory(in("compressed.pcd")).data);
}

TEST_F(ScanFiles, OnePointAndFewPointsGiveTheSameToo)
{
  writeFile(in("one.pcd"), programs::pcdBytes({{1.03f, 2, 3}}));
  writeFile(in("few.pcd"), programs::pcdBytes({{nan, 0, 0}, {1, 2, 3}, {1.01f, 2, 3}}));
  expectPiecesGiveTheSame(in("one.pcd"));
  expectPiecesGiveTheSame(in("few.pcd"));
  EXPECT_EQ(thinned(ScanFile(in("few.pcd"), inPieces(12)), 2).width, 1u);
}

TEST_F(ScanFiles, DoublesUnitsAndByteOrderAreBroughtIntoFormPieceByPiece)
{
  std::string doubles =
      "FIELDS z x y ring\nSIZE 8 8 8 2\nTYPE F F F U\nWIDTH 500\nDATA binary\n";
  std::string big = "ply\nformat binary_big_endian 1.0\nelement vertex 500\n"
                    "property double z\nproperty double x\nproperty double y\n"
                    "property ushort ring\nend_header\n";
  const auto append = [](std::string& bytes, auto value, bool turned) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    if (turned)
      std::reverse(raw, raw + sizeof value);
    bytes.append(raw, sizeof value);
  };
  for (int i = 0; i < 500; ++i)
    for (std::string* bytes : {&doubles, &big}) {
      for (const double v : {1000.0 + i % 7, 12.5 * (i % 300), -3.0 * i})
        append(*bytes, v, bytes == &big);
      append(*bytes, static_cast<std::uint16_t>(i), bytes == &big);
    }
  writeFile(in("doubles.pcd"), doubles);
  writeFile(in("big.ply"), big);
  for (const char* name : {"doubles.pcd", "big.ply"}) {
    const ScanFile whole(in(name), inUnit(0.001));
    const ScanFile pieces(in(name), inPieces(100, 0.001));
    EXPECT_EQ(thinned(whole, 1).data, thinned(pieces, 3).data);
    const ToolCloud cloud = loadCloud(in(name), inUnit(0.001));
    EXPECT_EQ((*cloud.points)[299].x, static_cast<float>(0.001 * 12.5 * 299));
    EXPECT_EQ((*cloud.points)[1].z, 1.001f);
  }
  EXPECT_EQ(thinned(ScanFile(in("doubles.pcd")), 1).data,
            thinned(ScanFile(in("big.ply")), 1).data);
}

TEST_F(ScanFiles, OfAMeshItIsSaidOnceThatItsVerticesAreThePoints)
{
  const auto plyOf = [](int faces) {
    return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
           "property float y\nproperty float z\nelement face " +
           std::to_string(faces) +
           "\nproperty list uchar int vertex_indices\nend_header\n"
           "0 0 0\n1 0 0\n0 1 0\n" +
           (faces > 0 ? "3 0 1 2\n" : "");
  };
  const auto saidOf = [&](const std::string& name) {
    testing::internal::CaptureStderr();
    const ScanFile scan(in(name));
    for (int time = 0; time < 2; ++time)
      scan.forEachPiece([](const RowSource::Piece&) { return true; });
    return testing::internal::GetCapturedStderr();
  };
  writeFile(in("mesh.ply"), plyOf(1));
  EXPECT_EQ(saidOf("mesh.ply"),
            "warning: '" + in("mesh.ply") +
                "' is a mesh of 1 face: only its 3 vertices are taken, as points; if "
                "they stand too far apart, pcl_mesh_sampling makes more of it\n");
  writeFile(in("cloud.ply"), plyOf(0));
  EXPECT_EQ(saidOf("cloud.ply"), "");
}

TEST_F(ScanFiles, AStrayPointCostsOneVoxel)
{
  auto points = roomPoints(5000);
  writeFile(in("stray.pcd"), programs::pcdBytes(points));
  points.pop_back();
  writeFile(in("near.pcd"), programs::pcdBytes(points));
  const auto with = thinned(ScanFile(in("stray.pcd")), 2);
  const auto without = thinned(ScanFile(in("near.pcd")), 2);
  ASSERT_EQ(with.width, without.width + 1);
  EXPECT_TRUE(std::equal(without.data.begin(), without.data.end(), with.data.begin()));
}

TEST_F(ScanFiles, WhatIsAmissIsToldAsOfAWholeCloud)
{
  const std::string good = programs::pcdBytes({{1, 2, 3}, {4, 5, 6}});
  const auto refusals = [&](const std::string& bytes) {
    writeFile(in("bad"), bytes);
    std::string sentences;
    try {
      ScanFile(in("bad"));
    }
    catch (const ToolError& error) {
      sentences = error.what();
    }
    try {
      loadCloud(in("bad"));
      EXPECT_EQ(sentences, "");
    }
    catch (const ToolError& error) {
      EXPECT_EQ(sentences, error.what());
    }
    return sentences;
  };
  EXPECT_EQ(refusals(good), "");
  EXPECT_NE(refusals(good.substr(0, good.size() - 1)).find("cut off"),
            std::string::npos);
  EXPECT_NE(refusals("WIDTH 2\n").find("as PCD"), std::string::npos);
  EXPECT_NE(refusals("hello").find("neither"), std::string::npos);
  EXPECT_NE(refusals(programs::pcdBytes({{nan, 0, 0}})).find("no finite point"),
            std::string::npos);
  EXPECT_NE(refusals(programs::pcdBytes({})).find("0 points"), std::string::npos);
  EXPECT_NE(refusals(programs::pcdBytes({{5e5f, 5.5e6f, 90}})).find("too large"),
            std::string::npos);
  EXPECT_THROW(ScanFile(in("missing.pcd")), ToolError);
}

TEST_F(ScanFiles, NearlyAllNaNIsToldFromNothingButNaN)
{
  std::vector<std::vector<float>> points(250000, {nan, nan, nan});
  points[100777] = {1, 2, 3}; // between the rows of the first check
  writeFile(in("a.pcd"), programs::pcdBytes(points));
  EXPECT_EQ(thinned(ScanFile(in("a.pcd")), 2).width, 1u);
  points[100777] = {nan, 2, 3};
  writeFile(in("b.pcd"), programs::pcdBytes(points));
  EXPECT_THROW(ScanFile(in("b.pcd")), ToolError);
}

TEST_F(ScanFiles, LargeDoublesAndTextAreCountedFromAnOriginThatGoesOn)
{
  const std::string far = "691600.125 5335900.5 512\n691601.125 5335902.5 514\n";
  const std::string pcd = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2\nHEIGHT 1\n"
                          "VIEWPOINT 691600.25 5335901 513 1 0 0 0\nDATA ascii\n";
  writeFile(in("far.pcd"), pcd + far);
  std::string ply = "ply\nformat binary_little_endian 1.0\nelement vertex 2\n"
                    "property double x\nproperty double y\nproperty double z\n"
                    "end_header\n";
  for (const double v : {691600.125, 5335900.5, 512., 691601.125, 5335902.5, 514.})
    ply.append(reinterpret_cast<const char*>(&v), sizeof v);
  writeFile(in("far.ply"), ply);
  for (const char* name : {"far.pcd", "far.ply"}) {
    const ToolCloud cloud = loadCloud(in(name));
    EXPECT_FALSE(cloud.origin.isZero());
    for (std::size_t i = 0; i < 2; ++i) {
      const Eigen::Vector3d p =
          cloud.origin.toGiven((*cloud.points)[i].getVector3fMap().cast<double>());
      EXPECT_EQ(p.x(), 691600.125 + static_cast<double>(i)) << name;
      EXPECT_EQ(p.y(), 5335900.5 + 2 * static_cast<double>(i)) << name;
    }
    // Written files contain the origin, which is kept when they are read again.
    for (const char* copy : {"copy.pcd", "copy.ply"}) {
      saveCloud(in(copy), cloud);
      const ToolCloud again = loadCloud(in(copy));
      EXPECT_EQ(again.origin, cloud.origin) << copy;
      EXPECT_EQ(again.blob.data, cloud.blob.data) << copy;
      ScanSettings settings;
      settings.origin = pcl::sedr::Origin{{691600, 5335900, 500}};
      const ToolCloud moved = loadCloud(in(copy), settings);
      EXPECT_EQ((*moved.points)[0].x, 0.125f);
      EXPECT_EQ((*moved.points)[1].z, 14.f);
    }
  }
  const ScanFile seen(in("far.pcd"));
  EXPECT_EQ(seen.origin().toGiven(seen.viewpoint().head<3>().cast<double>()),
            Eigen::Vector3d(691600.25, 5335901, 513));
}

TEST_F(ScanFiles, AnExcerptKeepsEveryKthPointAndTheSentenceOfTheWhole)
{
  writeFile(in("room.pcd"), programs::pcdBytes(roomPoints(20000)));
  const ToolCloud cloud = loadCloud(in("room.pcd"));
  const ScanFile scan(in("room.pcd"), inPieces(5000));
  const pcl::sedr::ScanExcerpt excerpt(scan, 3000, 2);
  const auto output = thinned(excerpt, 2);
  EXPECT_EQ(output.data, thinned(scan, 1).data);
  EXPECT_EQ(excerpt.problem(), "");
  const std::size_t step = 7; // of 20001
  ASSERT_EQ(excerpt.points()->size(), 20001 / step + 1);
  for (std::size_t k = 0; k < excerpt.points()->size(); ++k) {
    const auto& p = (*excerpt.points())[k];
    const auto& q = (*cloud.points)[step * k];
    ASSERT_TRUE(p.x() == q.x || (std::isnan(p.x()) && std::isnan(q.x)));
  }

  // Thinning stops early for a scan in millimetres.
  auto points = roomPoints(20000);
  for (auto& p : points)
    for (float& v : p)
      v *= 1000;
  writeFile(in("mm.pcd"), programs::pcdBytes(points));
  const ScanFile large(in("mm.pcd"), inPieces(5000));
  const pcl::sedr::ScanExcerpt refused(large, 3000, 2);
  EXPECT_LT(thinned(refused, 2).width, 2000u);
  const ToolCloud whole = loadCloud(in("mm.pcd"));
  std::vector<int> all(whole.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = static_cast<int>(i);
  EXPECT_EQ(refused.problem(),
            pcl::sedr::scanProblem(pcl::sedr::PointView(*whole.points), all));
  EXPECT_NE(refused.problem().find("if its unit is the"), std::string::npos);
}

} // namespace
