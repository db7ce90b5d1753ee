// SPDX-License-Identifier: BSD-3-Clause
#include "e57_writer.h"
#include "joint_scan.h"
#include "las_writer.h"
#include "tool_error.h"
#include "tools/run_program.h"
#include "tools/sample_files.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace pcl::sedr::tools;
using pcl::sedr::PointView;
using pcl::sedr::ScanPositions;
using programs::E57TestField;
using programs::E57Writer;
using programs::LasSample;
using programs::pcdBytes;
using programs::TemporaryFolder;
using programs::writeFile;

const Eigen::Vector3d grid(691600, 5336000, 500); // origin of all files' points

/** Three files of one site: E57 with a pose, PCD of doubles with a viewpoint, LAS. */
class JointScans : public ::testing::Test {
protected:
  void SetUp() override
  {
    E57Writer e57;
    std::vector<E57TestField> fields;
    for (const char* name : {"cartesianX", "cartesianY", "cartesianZ"})
      fields.push_back(E57TestField::ofDoubles(name, {1, 2, 3}));
    e57.addScan("hall", fields,
                E57Writer::pose(1, 0, 0, 0, grid.x(), grid.y(), grid.z()));
    writeFile(in("a.e57"), e57.file());
    std::string pcd = "VERSION 0.7\nFIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nCOUNT 1 1 1\n"
                      "WIDTH 2\nHEIGHT 1\nVIEWPOINT 691604 5336005 501.5 1 0 0 0\n"
                      "POINTS 2\nDATA ascii\n691610 5336010 501\n691611 5336010 501\n";
    writeFile(in("b.pcd"), pcd);
    LasSample las;
    las.shift = {grid.x(), grid.y(), grid.z()};
    las.points = {{20000, 0, 0}, {21000, 0, 0}, {22000, 0, 0}, {23000, 0, 0}};
    writeFile(in("c.las"), las.bytes());
  }

  std::string in(const std::string& name) const
  {
    return (folder_.path() / name).string();
  }

  std::vector<std::string> all() const
  {
    return {in("a.e57"), in("b.pcd"), in("c.las")};
  }

  /** Returns all points in the grid's coordinates. */
  static std::vector<Eigen::Vector3d> pointsOf(const JointScan& scan)
  {
    std::vector<Eigen::Vector3d> points;
    pcl::sedr::RowCoordinates coordinates(scan.fields(), scan.rowSize());
    scan.forEachPiece([&](const pcl::sedr::RowSource::Piece& piece) {
      EXPECT_EQ(piece.first, points.size());
      const PointView view = coordinates.of(piece.rows, piece.size);
      for (std::size_t i = 0; i < view.size(); ++i)
        points.push_back(scan.origin().toGiven(view[i].cast<double>()));
      return true;
    });
    return points;
  }

  TemporaryFolder folder_;
};

TEST_F(JointScans, HaveTheRowsOfAllFilesInOneFrame)
{
  const JointScan scan(all(), {});
  ASSERT_EQ(scan.size(), 9u);
  EXPECT_EQ(scan.origin(), ScanFile(in("a.e57")).origin());
  const std::vector<Eigen::Vector3d> points = pointsOf(scan);
  ASSERT_EQ(points.size(), 9u);
  EXPECT_LT((points[2] - grid - Eigen::Vector3d(3, 3, 3)).norm(), 1e-5);
  EXPECT_LT((points[4] - grid - Eigen::Vector3d(11, 10, 1)).norm(), 1e-5);
  EXPECT_LT((points[8] - grid - Eigen::Vector3d(23, 0, 0)).norm(), 1e-5);
}

TEST_F(JointScans, EachFileTellsItsPositionAndThoseThatDoNotHaveNone)
{
  const JointScan scan(all(), {});
  const ScanPositions positions = scan.positions();
  ASSERT_EQ(positions.size(), 3u);
  const auto given = [&](std::size_t k) {
    return scan.origin().toGiven(positions[k].place.cast<double>());
  };
  EXPECT_EQ(positions[0].first_row, 0u);
  EXPECT_LT((given(0) - grid).norm(), 1e-5);
  EXPECT_EQ(positions[1].first_row, 3u);
  EXPECT_LT((given(1) - grid - Eigen::Vector3d(4, 5, 1.5)).norm(), 1e-5);
  EXPECT_EQ(positions[2].first_row, 5u);
  EXPECT_FALSE(positions[2].isKnown());
  EXPECT_TRUE(JointScan({in("c.las"), in("c.las")}, {}).positions().empty());
}

TEST_F(JointScans, AFileOfPositionsIsOfAllRows)
{
  ScanSettings settings;
  settings.positions = in("positions.txt");
  writeFile(settings.positions, "691600 5336000 501 4\n691602 5336000 501 5\n");
  const JointScan scan(all(), settings);
  const ScanPositions positions = scan.positions();
  ASSERT_EQ(positions.size(), 2u);
  EXPECT_EQ(positions[1].first_row, 4u);
  EXPECT_LT((scan.origin().toGiven(positions[1].place.cast<double>()) - grid -
             Eigen::Vector3d(2, 0, 1))
                .norm(),
            1e-5);
  writeFile(settings.positions, "0 0 0 3\n");
  EXPECT_THROW(JointScan(all(), settings).positions(), ToolError);
}

TEST_F(JointScans, OfOneFileAreThatFile)
{
  writeFile(in("one.pcd"), pcdBytes({{1, 2, 3}, {4, 5, 6}}));
  const JointScan scan({in("one.pcd")}, {});
  const ScanFile file(in("one.pcd"));
  EXPECT_EQ(scan.rowSize(), file.rowSize());
  EXPECT_EQ(scan.fields().size(), file.fields().size());
  EXPECT_EQ(pointsOf(scan).size(), 2u);
}

TEST_F(JointScans, FilesOfAFolderComeByNameAndWhatIsAmissIsRefused)
{
  EXPECT_EQ(scanFilesOf({folder_.path().string()}), all());
  writeFile(in("z.xyz"), "1 2 3\n");
  writeFile(in("positions.txt"), "1 2 3\n");
  testing::internal::CaptureStderr();
  const std::vector<std::string> with_text = scanFilesOf({folder_.path().string()});
  EXPECT_NE(testing::internal::GetCapturedStderr().find("positions.txt"),
            std::string::npos);
  EXPECT_EQ(with_text.size(), all().size() + 1);
  EXPECT_EQ(with_text.back(), in("z.xyz"));
  std::filesystem::create_directory(in("empty"));
  EXPECT_THROW(scanFilesOf({in("empty")}), ToolError);
  EXPECT_THROW(scanFilesOf({"-", in("a.e57"), "-"}), ToolError);
  EXPECT_THROW(JointScan({in("a.e57"), in("missing.pcd")}, {}), ToolError);
}

} // namespace
