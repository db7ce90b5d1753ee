// SPDX-License-Identifier: BSD-3-Clause
// Where coordinates are counted from, where the scanner stood, and files that are one
// scan.
#include "joint_scan.h"
#include "scan_folder.h"
#include "scan_options.h"

namespace {

using namespace pcl::sedr::tools;
using namespace programs;
using pcl::sedr::Origin;
using pcl::sedr::ScanPositions;

class ScanOrigins : public ScanFolder {
protected:
  /** Returns what PCL's own reader takes for the place of the sensor. */
  static Eigen::Vector3f sensorOrigin(const std::string& path)
  {
    pcl::PCLPointCloud2 blob;
    Eigen::Vector4f origin;
    Eigen::Quaternionf orientation;
    int version = 0;
    EXPECT_EQ(pcl::PCDReader().read(path, blob, origin, orientation, version), 0);
    return origin.head<3>();
  }
};

const std::string far_points =
    "691600.125 5335900.5 512\n691601.125 5335902.5 514\n691602.125 5335904.5 516\n";

TEST_F(ScanOrigins, LargeCoordinatesOfAnyFormatLoseNothing)
{
  std::string ply = "ply\nformat binary_little_endian 1.0\nelement vertex 3\n"
                    "property double x\nproperty double y\nproperty double z\n"
                    "end_header\n";
  LasSample las;
  las.scale = {0.125, 0.125, 0.125};
  las.shift = {691600, 5335900, 0};
  std::vector<std::vector<double>> xyz(3);
  for (int i = 0; i < 3; ++i) {
    las.points.push_back({1 + 8 * i, 4 + 16 * i, 4096 + 16 * i});
    for (const std::size_t axis : {0, 1, 2}) {
      const double v =
          las.shift[axis] + 0.125 * las.points.back()[axis]; // exact in binary
      ply.append(reinterpret_cast<const char*>(&v), sizeof v);
      xyz[axis].push_back(v);
    }
  }
  E57Writer e57;
  e57.addScan("", realFields(xyz[0], xyz[1], xyz[2]));
  const std::string pcd = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 3\n"
                          "VIEWPOINT 691600.25 5335901 513 1 0 0 0\nDATA ascii\n";
  for (const std::string& bytes :
       {far_points, pcd + far_points, ply, las.bytes(), e57.file()}) {
    const ToolCloud cloud = load(bytes);
    EXPECT_EQ(cloud.origin, (Origin{{691601, 5335900, 0}}));
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_EQ(
          cloud.origin.toGiven((*cloud.points)[i].getVector3fMap().cast<double>()),
          Eigen::Vector3d(xyz[0][i], xyz[1][i], xyz[2][i]));
    for (const char* copy : {"copy.pcd", "copy.ply"}) { // tell it again
      saveCloud(in(copy), cloud);
      EXPECT_EQ(loadCloud(in(copy)).origin, cloud.origin) << copy;
      EXPECT_EQ(loadCloud(in(copy)).blob.data, cloud.blob.data) << copy;
      ScanSettings settings;
      settings.origin = Origin{{691600, 5335900, 500}};
      EXPECT_EQ((*loadCloud(in(copy), settings).points)[1].z, 14.F);
    }
    ScanSettings as_given;
    as_given.shifts = false;
    EXPECT_TRUE(says(refusal(bytes, as_given), "too large"));
  }
  const ScanFile seen(write(pcd + far_points));
  EXPECT_EQ(seen.origin().toGiven(seen.viewpoint().head<3>().cast<double>()),
            Eigen::Vector3d(691600.25, 5335901, 513));
}

TEST_F(ScanOrigins, FloatsTooLargeAreRefusedButStrayPointsAreNot)
{
  EXPECT_EQ(refusal(pcdBytes({{8000, 1, 1}, {8000, 2, 1}, {8000, 3, 1}})), "");
  EXPECT_EQ(refusal(pcdBytes({{1, 1, 1}, {1, 2, 1}, {4.5e6F, 3, 1}})), "");
  const std::string sentence =
      refusal(pcdBytes({{412345.5F, 5650100, 90}, {412346.5F, 5650101, 91}}));
  EXPECT_TRUE(says(sentence, "(412000, 5650000, 0)"));
}

TEST_F(ScanOrigins, OriginsOfModelsAreReadOrTheFileIsRefused)
{
  const auto originIn = [&](const std::string& json) {
    return originOfModel(write(json, "plan.json"));
  };
  EXPECT_EQ(originIn(R"({"origin": [691000, 5335990.5, -3]})"),
            (Origin{{691000, 5335990.5, -3}}));
  EXPECT_TRUE(originIn(R"({"rooms": []})").isZero());
  EXPECT_THROW(originIn(R"({"origin": [691000, 53)"), ToolError);
  EXPECT_THROW(originIn(R"({"origin": [1, 2]})"), ToolError);
}

TEST_F(ScanOrigins, PositionAndOriginAreKeptSideBySide)
{
  const std::string pcd = "FIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nWIDTH 2\n"
                          "VIEWPOINT 691604 5336005 501.5 0 1 0 0\nDATA ascii\n"
                          "691600 5336000 500\n691601 5336000 500\n";
  std::string from = write(pcd);
  for (const char* copy : {"one.pcd", "two.pcd"}) {
    copyScan(in(copy), ScanFile(from));
    EXPECT_EQ(sensorOrigin(in(copy)), Eigen::Vector3f(691601, 5336000, 0)) << copy;
    const ScanFile read(in(copy));
    EXPECT_EQ(read.origin(), (Origin{{691601, 5336000, 0}}));
    ASSERT_EQ(read.positions().size(), 1u);
    EXPECT_EQ(read.positions()[0].place, Eigen::Vector3f(3, 5, 501.5F));
    EXPECT_EQ(read.orientation().x(), 1.F);
    from = in(copy);
  }
  // PCL's own writers keep the origin in VIEWPOINT, and drop comments.
  write(far_points, "far.xyz");
  copyScan(in("far.pcd"), ScanFile(in("far.xyz")));
  pcl::PointCloud<pcl::PointXYZ> cloud;
  ASSERT_EQ(pcl::io::loadPCDFile(in("far.pcd"), cloud), 0);
  ASSERT_EQ(pcl::PCDWriter().writeASCII(in("ascii.pcd"), cloud), 0);
  ASSERT_EQ(pcl::PCDWriter().writeBinary(in("binary.pcd"), cloud), 0);
  ASSERT_EQ(pcl::PCDWriter().writeBinaryCompressed(in("compressed.pcd"), cloud), 0);
  for (const char* name : {"far.pcd", "ascii.pcd", "binary.pcd", "compressed.pcd"}) {
    EXPECT_EQ(ScanFile(in(name)).origin(), (Origin{{691601, 5335900, 0}})) << name;
    EXPECT_EQ(originOfModel(in(name)), (Origin{{691601, 5335900, 0}})) << name;
    EXPECT_TRUE(ScanFile(in(name)).positions().empty()) << name;
  }
  // One of more digits than PCL writes is in a comment only.
  ScanSettings settings;
  settings.origin = Origin{{691614, 5335995, 0}};
  copyScan(in("digits.pcd"), ScanFile(in("far.xyz"), settings));
  EXPECT_EQ(sensorOrigin(in("digits.pcd")), Eigen::Vector3f(0, 0, 0));
  EXPECT_EQ(ScanFile(in("digits.pcd")).origin(), *settings.origin);
}

TEST_F(ScanOrigins, AViewpointIsAPositionOrAnOriginOrNothing)
{
  const auto with = [&](const std::string& viewpoint, double unit = 1, float size = 1) {
    write(replaced(pcdBytes({{size, 2, 3}, {4, size, 6}}), "VIEWPOINT 0 0 0",
                   "VIEWPOINT " + viewpoint));
    ScanSettings settings;
    settings.unit = unit;
    return ScanFile(in("scan"), settings);
  };
  const Origin grid{{691600, 5336000, 0}};
  EXPECT_EQ(with("691600 5336000 0").origin(), grid);
  EXPECT_TRUE(with("691600 5336000 0").positions().empty());
  EXPECT_EQ(with("691600 5336000 0", 0.3048).origin(), grid); // in metres
  EXPECT_EQ(with("691600.5 5336000 0").positions().size(), 1u);
  EXPECT_EQ(with("691600 5336005 0").positions().size(), 1u); // seven digits
  EXPECT_EQ(with("200 30 2").positions().size(), 1u);
  EXPECT_EQ(with("0 0 1500", 0.001, 5000).positions().size(), 1u); // millimetres
  for (const char* unknown :
       {"0 0 0", "inf 0 0", "nan 0 0", "1e300 0 0", "1e400 0 0", "1 2 3x"}) {
    EXPECT_TRUE(with(unknown).origin().isZero()) << unknown;
    EXPECT_TRUE(with(unknown).positions().empty()) << unknown;
  }
}

TEST_F(ScanOrigins, PosesOfE57ArePositionsIfAllScansHaveOne)
{
  for (const double x : {0., 691600.}) { // one at the origin is known, too
    E57Writer writer;
    writer.addScan("", realFields({-1, 0, 1}, {1, 2, 3}, {1, 2, 3}),
                   E57Writer::pose(0, 0, 0, 1, x, 0, 0));
    copyScan(in("scan.pcd"), ScanFile(write(writer.file())));
    saveCloud(in("cloud.pcd"), loadCloud(in("scan.pcd")));
    for (const char* name : {"scan.pcd", "cloud.pcd"}) {
      const ScanFile scan(in(name));
      EXPECT_EQ(scan.origin().place.x(), x) << name;
      ASSERT_EQ(scan.positions().size(), 1u) << name;
      EXPECT_EQ(scan.positions()[0].place, Eigen::Vector3f(0, 0, 0)) << name;
      EXPECT_EQ(scan.orientation().z(), 1.F) << name;
    }
  }
  E57Writer writer;
  const auto fields = realFields({1, 2}, {1, 2}, {1, 2});
  writer.addScan("a", fields, E57Writer::pose(1, 0, 0, 0, 5, 6, 1.5));
  writer.addScan("b", fields, E57Writer::pose(1, 0, 0, 0, -5, 6, 1.5));
  const ScanPositions positions = ScanFile(write(writer.file())).positions();
  ASSERT_EQ(positions.size(), 2u);
  EXPECT_EQ(positions[1].first_row, 2u);
  EXPECT_EQ(positions[1].place, Eigen::Vector3f(-5, 6, 1.5F));
  writer.addScan("c", fields);
  EXPECT_TRUE(ScanFile(write(writer.file())).positions().empty());
}

TEST_F(ScanOrigins, AFileOfPositionsIsInTheFrameOfTheScan)
{
  write("2000 0 0\n2001 0 0\n2000 2 1\n", "scan.xyz"); // counted from x = 2000
  const auto positionsIn = [&](const std::string& text, double unit = 1) {
    ScanSettings settings;
    settings.unit = unit;
    settings.positions = write(text, "positions.txt");
    return ScanFile(in("scan.xyz"), settings).positions();
  };
  const ScanPositions positions =
      positionsIn("# x y z points\n2003.5 -1 1.5 1\n\n2004 1.25 1.6 2\n");
  ASSERT_EQ(positions.size(), 2u);
  EXPECT_EQ(positions[0].place, Eigen::Vector3f(3.5F, -1, 1.5F));
  EXPECT_EQ(positions[1].first_row, 1u);
  EXPECT_EQ(positions[1].place, Eigen::Vector3f(4, 1.25F, 1.6F));
  const ScanPositions single = positionsIn("3000 500 -250", 0.001);
  ASSERT_EQ(single.size(), 1u);
  EXPECT_TRUE(single[0].place.isApprox(Eigen::Vector3f(3, 0.5F, -0.25F)));
  for (const char* bad :
       {"1 2 3 1\n1 2 3 1\n", "1 2 3 1\n1 2 3\n", "1 2 3 3\n1 2\n", "1 2 3 -3\n",
        "1 2 3m 3\n", "inf 0 0\n", "1e300 0 0\n", "# none\n"})
    EXPECT_THROW(positionsIn(bad), ToolError) << bad;
}

/** Three files of one site: E57 with a pose, PCD with a viewpoint, LAS. */
class JointScans : public ScanOrigins {
protected:
  void SetUp() override
  {
    E57Writer e57;
    e57.addScan("hall", realFields({1, 2, 3}, {1, 2, 3}, {1, 2, 3}),
                E57Writer::pose(1, 0, 0, 0, grid.x(), grid.y(), grid.z()));
    LasSample las;
    las.shift = {grid.x(), grid.y(), grid.z()};
    las.points = {{20000, 0, 0}, {21000, 0, 0}, {22000, 0, 0}, {23000, 0, 0}};
    all = {write(e57.file(), "a.e57"),
           write("FIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nWIDTH 2\nVIEWPOINT 691604 "
                 "5336005 501.5 1 0 0 0\nDATA ascii\n691610 5336010 501\n"
                 "691611 5336010 501\n",
                 "b.pcd"),
           write(las.bytes(), "c.las")};
  }

  /** Expects a place of the grid, counted from (691600, 5336000, 500). */
  static void expectPlace(const JointScan& scan,
                          const Eigen::Vector3f& place,
                          const Eigen::Vector3d& expected)
  {
    EXPECT_LT((scan.origin().toGiven(place.cast<double>()) - grid - expected).norm(),
              1e-5);
  }

  static inline const Eigen::Vector3d grid{691600, 5336000, 500};
  std::vector<std::string> all;
};

TEST_F(JointScans, HaveTheRowsOfAllFilesInOneFrame)
{
  const JointScan scan(all, {});
  ASSERT_EQ(scan.size(), 9u);
  EXPECT_EQ(scan.origin(), ScanFile(all[0]).origin());
  std::vector<Eigen::Vector3f> points;
  pcl::sedr::RowCoordinates coordinates(scan.fields(), scan.rowSize());
  scan.forEachPiece([&](const pcl::sedr::RowSource::Piece& piece) {
    EXPECT_EQ(piece.first, points.size());
    const auto view = coordinates.of(piece.rows, piece.size);
    for (std::size_t i = 0; i < view.size(); ++i)
      points.push_back(view[i]);
    return true;
  });
  ASSERT_EQ(points.size(), 9u);
  expectPlace(scan, points[2], {3, 3, 3});
  expectPlace(scan, points[4], {11, 10, 1});
  expectPlace(scan, points[8], {23, 0, 0});
  EXPECT_EQ(JointScan({all[2]}, {}).fields().size(), ScanFile(all[2]).fields().size());
}

TEST_F(JointScans, HaveThePositionsOfTheirFilesOrOfOneForAll)
{
  const JointScan scan(all, {});
  const ScanPositions positions = scan.positions();
  ASSERT_EQ(positions.size(), 3u);
  expectPlace(scan, positions[0].place, {0, 0, 0});
  EXPECT_EQ(positions[1].first_row, 3u);
  expectPlace(scan, positions[1].place, {4, 5, 1.5});
  EXPECT_EQ(positions[2].first_row, 5u);
  EXPECT_FALSE(positions[2].isKnown());
  EXPECT_TRUE(JointScan({all[2], all[2]}, {}).positions().empty());
  ScanSettings settings;
  settings.positions = write("691600 5336000 501 4\n691602 5336000 501 5\n", "p.txt");
  const ScanPositions given = JointScan(all, settings).positions();
  ASSERT_EQ(given.size(), 2u);
  EXPECT_EQ(given[1].first_row, 4u);
  expectPlace(scan, given[1].place, {2, 0, 1});
}

TEST_F(JointScans, OfAFolderAreItsScansByName)
{
  EXPECT_EQ(scanFilesOf({folder_.path().string()}), all);
  all.push_back(write("1 2 3\n", "z.xyz"));
  write("1 2 3\n", "positions.txt");
  testing::internal::CaptureStderr();
  EXPECT_EQ(scanFilesOf({folder_.path().string()}), all);
  EXPECT_TRUE(says(testing::internal::GetCapturedStderr(), "positions.txt"));
  write("1 2 3\n", "solid.ply");
  write(R"({"format": "sedr-report", "files": ["report.json", "solid.ply", "../b"]})",
        "report.json");
  testing::internal::CaptureStderr();
  EXPECT_EQ(scanFilesOf({folder_.path().string()}), all) << "without results";
  EXPECT_TRUE(
      says(testing::internal::GetCapturedStderr(), "2 files that its report.json"));
  std::filesystem::create_directory(in("empty"));
  EXPECT_THROW(scanFilesOf({in("empty")}), ToolError);
  const std::string text = write("1 2 3\n", "empty/scan.csv");
  EXPECT_EQ(scanFilesOf({in("empty")}), std::vector<std::string>{text});
  EXPECT_THROW(scanFilesOf({"-", all[0], "-"}), ToolError);
  EXPECT_THROW(JointScan({all[0], in("missing.pcd")}, {}), ToolError);
}

} // namespace
