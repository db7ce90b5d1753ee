// SPDX-License-Identifier: BSD-3-Clause
#include "e57_writer.h"
#include "scan_file.h"
#include "scan_options.h"
#include "tool_cloud.h"
#include "tool_error.h"
#include "tools/reading_settings.h"
#include "tools/run_program.h"
#include "tools/sample_files.h"

#include <pcl/io/pcd_io.h>

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr::tools;
using namespace programs;
using pcl::sedr::ScanPositions;
using programs::E57TestField;
using programs::E57Writer;
using programs::TemporaryFolder;
using programs::writeFile;

class ScanPositionFiles : public ::testing::Test {
protected:
  std::string in(const std::string& name) const
  {
    return (folder_.path() / name).string();
  }

  /** Reads three points as text with a file of positions. */
  ScanPositions positionsBy(const std::string& positions,
                            ScanSettings settings = {}) const
  {
    writeFile(in("scan.xyz"), "2000 0 0\n2001 0 0\n2000 2 1\n");
    writeFile(in("positions.txt"), positions);
    settings.positions = in("positions.txt");
    return ScanFile(in("scan.xyz"), settings).positions();
  }

  std::string refusal(const std::string& positions) const
  {
    try {
      positionsBy(positions);
    }
    catch (const ToolError& error) {
      return error.what();
    }
    return "it was read";
  }

  TemporaryFolder folder_;
};

TEST_F(ScanPositionFiles, ALineIsAPositionInTheFrameOfTheScan)
{
  // The scan is more than 1 km from 0 along x, so its origin there is 2000.
  const ScanPositions positions =
      positionsBy("# x y z points\n2003.5 -1 1.5 1\n\n2004 1.25 1.6 2\n");
  ASSERT_EQ(positions.size(), 2u);
  EXPECT_EQ(positions[0].first_row, 0u);
  EXPECT_EQ(positions[0].place, Eigen::Vector3f(3.5F, -1, 1.5F));
  EXPECT_EQ(positions[1].first_row, 1u);
  EXPECT_EQ(positions[1].place, Eigen::Vector3f(4, 1.25F, 1.6F));
  ScanSettings millimetres;
  millimetres.unit = 0.001;
  const ScanPositions small = positionsBy("3000 500 -250", millimetres);
  ASSERT_EQ(small.size(), 1u);
  EXPECT_TRUE(small[0].place.isApprox(Eigen::Vector3f(3, 0.5F, -0.25F)));
}

TEST_F(ScanPositionFiles, WhatIsAmissIsOneSentenceWithTheNumbers)
{
  EXPECT_NE(refusal("1 2 3 1\n1 2 3 1\n").find("are of 2 points"), std::string::npos);
  EXPECT_NE(refusal("1 2 3 1\n1 2 3\n").find("of 2 positions"), std::string::npos);
  EXPECT_NE(refusal("1 2 3 3\n1 2\n").find("line 2 of"), std::string::npos);
  EXPECT_NE(refusal("1 2 3 -3\n").find("line 1 of"), std::string::npos);
  EXPECT_NE(refusal("1 2 3m 3\n").find("line 1 of"), std::string::npos);
  EXPECT_NE(refusal("inf 0 0\n").find("line 1 of"), std::string::npos);
  EXPECT_NE(refusal("1e300 0 0\n").find("line 1 of"), std::string::npos);
  EXPECT_NE(refusal("# none\n").find("has no positions"), std::string::npos);
}

TEST_F(ScanPositionFiles, AViewpointOfPcdIsOneUnlessItIsZero)
{
  std::string pcd = programs::pcdBytes({{1, 2, 3}, {4, 5, 6}});
  writeFile(in("scan.pcd"), pcd);
  EXPECT_TRUE(ScanFile(in("scan.pcd")).positions().empty());
  pcd.replace(pcd.find("VIEWPOINT 0 0 0"), 15, "VIEWPOINT 1 2 1.5");
  writeFile(in("scan.pcd"), pcd);
  const ScanPositions positions = ScanFile(in("scan.pcd")).positions();
  ASSERT_EQ(positions.size(), 1u);
  EXPECT_EQ(positions[0].first_row, 0u);
  EXPECT_EQ(positions[0].place, Eigen::Vector3f(1, 2, 1.5F));
}

/** Returns what PCL's own reader takes for the place of the sensor. */
Eigen::Vector3f
sensorOrigin(const std::string& path)
{
  pcl::PCLPointCloud2 blob;
  Eigen::Vector4f origin;
  Eigen::Quaternionf orientation;
  int version = 0;
  EXPECT_EQ(pcl::PCDReader().read(path, blob, origin, orientation, version), 0);
  EXPECT_TRUE(orientation.isApprox(Eigen::Quaternionf::Identity()));
  return origin.head<3>();
}

TEST_F(ScanPositionFiles, ThePositionIsKeptBesideAnOriginThatPclSeesInViewpoint)
{
  const std::string pcd = "FIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nWIDTH 2\nHEIGHT 1\n"
                          "VIEWPOINT 691604 5336005 501.5 0 1 0 0\nDATA ascii\n"
                          "691600 5336000 500\n691601 5336000 500\n";
  writeFile(in("scan.pcd"), pcd);
  std::string from = in("scan.pcd");
  for (const char* copy : {"one.pcd", "two.pcd"}) {
    saveScan(in(copy), ScanFile(from));
    EXPECT_EQ(sensorOrigin(in(copy)), Eigen::Vector3f(691601, 5336000, 0)) << copy;
    const ScanFile read(in(copy));
    EXPECT_EQ(read.origin(), (pcl::sedr::Origin{{691601, 5336000, 0}}));
    ASSERT_EQ(read.positions().size(), 1u);
    EXPECT_EQ(read.positions()[0].place, Eigen::Vector3f(3, 5, 501.5F));
    EXPECT_EQ(read.orientation().x(), 1.F);
    from = in(copy);
  }
}

TEST_F(ScanPositionFiles, AViewpointBeyondTheReachOfAScannerIsAnOrigin)
{
  const auto written = [&](const std::string& viewpoint, double unit = 1,
                           float size = 1) {
    std::string pcd = programs::pcdBytes({{size, 2, 3}, {4, size, 6}});
    pcd.replace(pcd.find("VIEWPOINT 0 0 0"), 15, "VIEWPOINT " + viewpoint);
    writeFile(in("scan.pcd"), pcd);
    return ScanFile(in("scan.pcd"), inUnit(unit));
  };
  const pcl::sedr::Origin grid{{691600, 5336000, 0}};
  EXPECT_EQ(written("691600 5336000 0").origin(), grid);
  EXPECT_TRUE(written("691600 5336000 0").positions().empty());
  EXPECT_EQ(written("691600 5336000 0", 0.3048).origin(), grid); // in metres
  EXPECT_EQ(written("691600.5 5336000 0").positions().size(), 1u);
  EXPECT_EQ(written("691600 5336005 0").positions().size(), 1u); // seven digits
  for (const char* unknown :
       {"inf 0 0", "nan 0 0", "1e300 0 0", "1e400 0 0", "1 2 3x"}) {
    const ScanFile scan = written(unknown);
    EXPECT_TRUE(scan.origin().isZero()) << unknown;
    EXPECT_TRUE(scan.positions().empty()) << unknown;
  }
  EXPECT_EQ(written("200 30 2").positions().size(), 1u);
  EXPECT_EQ(written("0 0 1500", 1, 5000).positions().size(), 1u); // millimetres
  EXPECT_EQ(written("0 0 1500", 0.001, 5000).positions().size(), 1u);
}

TEST_F(ScanPositionFiles, PclsOwnWritersKeepTheOriginThatIsChosen)
{
  writeFile(in("scan.xyz"), "691614 5335995 500\n691615 5335995 500\n"
                            "691614 5335996 503\n");
  saveScan(in("scan.pcd"), ScanFile(in("scan.xyz")));
  const pcl::sedr::Origin origin{{691614, 5336000, 0}};
  EXPECT_EQ(ScanFile(in("scan.pcd")).origin(), origin);
  pcl::PointCloud<pcl::PointXYZ> cloud;
  ASSERT_EQ(pcl::io::loadPCDFile(in("scan.pcd"), cloud), 0);
  pcl::PCDWriter writer;
  ASSERT_EQ(writer.writeASCII(in("ascii.pcd"), cloud), 0);
  ASSERT_EQ(writer.writeBinary(in("binary.pcd"), cloud), 0);
  ASSERT_EQ(writer.writeBinaryCompressed(in("compressed.pcd"), cloud), 0);
  for (const char* name : {"ascii.pcd", "binary.pcd", "compressed.pcd"}) {
    const ScanFile scan(in(name));
    EXPECT_EQ(scan.origin(), origin) << name;
    EXPECT_TRUE(scan.positions().empty()) << name;
    EXPECT_EQ(originOfModel(in(name)), origin) << name;
  }
}

TEST_F(ScanPositionFiles, AnOriginOfMoreDigitsThanPclWritesIsInACommentOnly)
{
  writeFile(in("scan.xyz"), "691614 5335995 500\n691615 5335995 500\n");
  ScanSettings settings;
  settings.origin = pcl::sedr::Origin{{691614, 5335995, 0}};
  saveScan(in("scan.pcd"), ScanFile(in("scan.xyz"), settings));
  EXPECT_EQ(sensorOrigin(in("scan.pcd")), Eigen::Vector3f(0, 0, 0));
  EXPECT_EQ(ScanFile(in("scan.pcd")).origin(), *settings.origin);
  EXPECT_TRUE(ScanFile(in("scan.pcd")).positions().empty());
}

TEST_F(ScanPositionFiles, AScannerAtTheOriginIsKnown)
{
  for (const double x : {0., 691600.}) {
    E57Writer writer;
    writer.addScan("",
                   {E57TestField::ofFloats("cartesianX", {-1, 0, 1}),
                    E57TestField::ofFloats("cartesianY", {1, 2, 3}),
                    E57TestField::ofFloats("cartesianZ", {1, 2, 3})},
                   E57Writer::pose(0, 0, 0, 1, x, 0, 0));
    writeFile(in("scan.e57"), writer.file());
    saveScan(in("scan.pcd"), ScanFile(in("scan.e57")));
    saveCloud(in("cloud.pcd"), loadCloud(in("scan.pcd")));
    for (const char* name : {"scan.pcd", "cloud.pcd"}) {
      const ScanFile scan(in(name));
      EXPECT_EQ(scan.origin().place.x(), x) << name;
      ASSERT_EQ(scan.positions().size(), 1u) << name;
      EXPECT_EQ(scan.positions()[0].place, Eigen::Vector3f(0, 0, 0)) << name;
      EXPECT_EQ(scan.orientation().z(), 1.F) << name;
    }
  }
}

TEST_F(ScanPositionFiles, AnUnknownOneStaysUnknownInAPcdOfAScanFarFromZero)
{
  writeFile(in("far.xyz"), "691600 5336000 500\n691610 5336000 500\n"
                           "691600 5336010 503\n");
  saveScan(in("far.pcd"), ScanFile(in("far.xyz")));
  EXPECT_TRUE(ScanFile(in("far.pcd")).positions().empty());
}

TEST_F(ScanPositionFiles, PosesOfE57AreThoseOfItsScansIfAllHaveOne)
{
  const std::vector<E57TestField> fields{E57TestField::ofFloats("cartesianX", {1, 2}),
                                         E57TestField::ofFloats("cartesianY", {1, 2}),
                                         E57TestField::ofFloats("cartesianZ", {1, 2})};
  E57Writer writer;
  writer.addScan("a", fields, E57Writer::pose(1, 0, 0, 0, 5, 6, 1.5));
  writer.addScan("b", fields, E57Writer::pose(1, 0, 0, 0, -5, 6, 1.5));
  writeFile(in("scan.e57"), writer.file());
  const ScanPositions positions = ScanFile(in("scan.e57")).positions();
  ASSERT_EQ(positions.size(), 2u);
  EXPECT_EQ(positions[1].first_row, 2u);
  EXPECT_EQ(positions[1].place, Eigen::Vector3f(-5, 6, 1.5F));
  writer.addScan("c", fields);
  writeFile(in("scan.e57"), writer.file());
  EXPECT_TRUE(ScanFile(in("scan.e57")).positions().empty());
}

} // namespace
