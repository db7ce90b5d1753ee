// SPDX-License-Identifier: BSD-3-Clause
// A scan that is read piece by piece is the scan as a whole.
#include "bytes/whole_file.h"
#include "scan_folder.h"

#include <pcl/conversions.h>
#include <pcl/sedr_filters/parallel_voxel_grid.h>

#include <cmath>
#include <limits>

namespace {

using namespace pcl::sedr::tools;
using namespace programs;
using pcl::sedr::RowSource;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

class ScanFiles : public ScanFolder {
protected:
  /** Writes the same points, fields and colours in every format.
   * @return the paths */
  std::vector<std::string> writeAll(std::size_t n) const
  {
    pcl::PCLPointCloud2 blob = manyFields();
    std::vector<std::int32_t> rows;
    std::vector<Eigen::Vector3f> places;
    LasSample las;
    std::string text;
    for (std::size_t i = 0; i < n; ++i) {
      rows.push_back(static_cast<std::int32_t>(i % 3));
      const auto k = static_cast<std::int32_t>(i);
      las.points.push_back({k * 37 % 9000, k * 53 % 7000, k % 3000});
      places.emplace_back(las.points.back()[0], las.points.back()[1], k % 3000);
      places.back() *= 0.001F;
      text += std::to_string(places.back().x()) + " " +
              std::to_string(places.back().y()) + " " +
              std::to_string(places.back().z()) + (k % 7 == 0 ? "\n\n# a\n" : "\n");
    }
    blob = selectRows(blob, rows);
    setCoordinates(blob, 0, places);
    saveBlob(in("scan.pcd"), blob);
    saveBlob(in("scan.ply"), blob);
    saveCompressed(in("packed.pcd"), blob);
    E57Writer e57;
    e57.packet_bytes = 40000;
    e57.is_uneven = true;
    e57.addScan("one", integerFields(wholeCoordinates(n, 90000), 90000));
    e57.addScan("two", integerFields(wholeCoordinates(777, 90000), 90000));
    write(las.bytes(), "scan.las");
    write(text, "scan.xyz");
    write("FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH " + std::to_string(n) +
              "\nDATA ascii\n" + text,
          "ascii.pcd");
    write(e57.file(), "scan.e57");
    return {in("scan.pcd"), in("scan.ply"),  in("packed.pcd"), in("scan.las"),
            in("scan.xyz"), in("ascii.pcd"), in("scan.e57")};
  }
};

TEST_F(ScanFiles, PiecesAndSingleRowsAreThoseOfTheWhole)
{
  const std::size_t n = 60000; // several blocks and packets
  for (const std::string& path : writeAll(n)) {
    const ToolCloud whole = loadCloud(path);
    const std::size_t size = whole.size();
    ASSERT_GE(size, n) << path;
    EXPECT_EQ(ScanFile(path).size(), size);
    for (const std::size_t piece_bytes : {std::size_t{99991}, std::size_t{1} << 26}) {
      const ScanFile scan(path, inPieces(piece_bytes));
      for (const auto& [from, to] : {std::make_pair(std::size_t{0}, size),
                                     {std::size_t{59999}, size},
                                     {std::size_t{33333}, std::size_t{33334}},
                                     {size - 1, size}}) {
        std::size_t next = from;
        scan.forEachPiece(from, to, [&](const RowSource::Piece& piece) {
          EXPECT_EQ(piece.first, next);
          EXPECT_EQ(std::memcmp(piece.rows, &whole.blob.data[next * scan.rowSize()],
                                piece.size * scan.rowSize()),
                    0)
              << path << " from " << next;
          next += piece.size;
          return true;
        });
        EXPECT_EQ(next, to) << path;
      }
    }
  }
  const ToolCloud las = loadCloud(in("scan.las"));
  const ToolCloud text = loadCloud(in("scan.xyz"));
  const ToolCloud ascii = loadCloud(in("ascii.pcd"));
  for (std::size_t i = 0; i < n; ++i) {
    ASSERT_FLOAT_EQ((*text.points)[i].x, (*las.points)[i].x) << i;
    ASSERT_FLOAT_EQ((*ascii.points)[i].z, (*las.points)[i].z) << i;
  }
  EXPECT_THROW(ScanFile(in("missing.pcd")), ToolError);
}

TEST_F(ScanFiles, AnAxisOfTheFileBecomesZWithNormalsAndPositions)
{
  writeFile(in("scan.pcd"),
            "VERSION 0.7\nFIELDS normal_x normal_y normal_z x y z\nSIZE 4 4 4 4 8 4\n"
            "TYPE F F F F F F\nCOUNT 1 1 1 1 1 1\nWIDTH 3\nHEIGHT 1\n"
            "VIEWPOINT 7 8 9 1 0 0 0\nPOINTS 3\nDATA ascii\n"
            "1 0 0 1 0 0\n0 1 0 0 1 0\n0 0 1 0 0 1\n");
  for (const char* up : {"x", "-x", "y", "-y", "z", "-z"}) {
    ScanSettings settings;
    settings.up = up;
    settings.unit = 2;
    const ScanFile scan(in("scan.pcd"), settings);
    const ToolCloud cloud = loadCloud(in("scan.pcd"), settings);
    Eigen::Matrix3f turn; // the axes of the file, turned
    for (int k = 0; k < 3; ++k)
      turn.col(k) = (*cloud.points)[static_cast<std::size_t>(k)].getVector3fMap() / 2;
    EXPECT_FLOAT_EQ(turn.determinant(), 1) << up << '\n' << turn;
    Eigen::Vector3f axis = Eigen::Vector3f::Unit(std::string(up).back() - 'x');
    axis *= up[0] == '-' ? -1.F : 1.F;
    EXPECT_EQ(turn * axis, Eigen::Vector3f::UnitZ()) << up << '\n' << turn;
    EXPECT_EQ(scan.viewpoint().head<3>(), 2 * turn * Eigen::Vector3f(7, 8, 9)) << up;
    int row = 0;
    for (const char* name : {"normal_x", "normal_y", "normal_z"}) {
      const std::vector<float> values = floatField(cloud.blob, name);
      for (int k = 0; k < 3; ++k)
        EXPECT_EQ(values[static_cast<std::size_t>(k)], turn(row, k)) << up << name;
      ++row;
    }
  }
}

TEST_F(ScanFiles, OfAMeshItIsSaidOnceThatItsVerticesAreThePoints)
{
  const std::string ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                          "property float y\nproperty float z\nelement face 1\n"
                          "property list uchar int vertex_indices\nend_header\n"
                          "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  testing::internal::CaptureStderr();
  const ScanFile scan(write(ply));
  for (int time = 0; time < 2; ++time)
    scan.forEachPiece([](const RowSource::Piece&) { return true; });
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_TRUE(says(said, "is a mesh of 1 face: only its 3 vertices"));
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1);
}

TEST_F(ScanFiles, ASinglePointThatIsFiniteIsFound)
{
  std::vector<std::vector<float>> points(250000, {nan, nan, nan});
  points[100777] = {1, 2, 3}; // between the rows of the first check
  pcl::ParallelVoxelGrid<pcl::PCLPointCloud2> grid;
  pcl::PCLPointCloud2 thinned;
  grid.filter(ScanFile(write(pcdBytes(points))), thinned);
  EXPECT_EQ(thinned.width, 1u);
  points[100777] = {nan, 2, 3};
  EXPECT_TRUE(says(refusal(pcdBytes(points)), "no finite point"));
}

// Clouds with all their fields, in memory and in the files that are written.

using Field = pcl::PCLPointField;

class CloudFiles : public ScanFolder {};

TEST_F(CloudFiles, EveryFieldSurvives)
{
  auto blob = manyFields();
  const std::uint32_t colour = 0xff102030U;
  std::memcpy(&blob.data[findField(blob, "rgb")->offset], &colour, sizeof colour);
  saveBlob(in("a.pcd"), blob);
  saveCompressed(in("b.pcd"), blob);
  saveBlob(in("c.PLY"), blob);
  EXPECT_TRUE(says(bytesOf(in("b.pcd")), "DATA binary_compressed"));
  for (const char* name : {"a.pcd", "b.pcd", "c.PLY"}) {
    const ToolCloud cloud = loadCloud(in(name));
    ASSERT_EQ(cloud.blob.fields.size(), blob.fields.size()) << name;
    for (const auto& field : blob.fields) {
      const auto* read = findField(cloud.blob, field.name);
      ASSERT_NE(read, nullptr) << field.name;
      EXPECT_EQ(read->datatype, field.datatype);
      if (field.name == "rgb")
        EXPECT_EQ(std::memcmp(&cloud.blob.data[read->offset], &colour, 4), 0) << name;
      else
        EXPECT_EQ(floatField(cloud.blob, field.name), floatField(blob, field.name));
    }
    EXPECT_TRUE(cloud.has_label);
    EXPECT_FALSE(cloud.has_room);
    EXPECT_EQ(cloud.label, (std::vector<std::uint32_t>{70, 71, 72}));
    EXPECT_EQ(cloud.room, (std::vector<std::uint32_t>{0, 0, 0}));
  }
  EXPECT_THROW(saveBlob(in("d.txt"), blob), ToolError);
}

TEST_F(CloudFiles, AStructureInPiecesIsTheSameFile)
{
  for (const std::size_t size : {std::size_t{0}, std::size_t{100000}}) {
    pcl::PointCloud<pcl::PointStructure> structure;
    for (std::size_t i = 0; i < size; ++i) {
      pcl::PointStructure p;
      p.getVector3fMap() << static_cast<float>(i), 2, 3;
      p.label = static_cast<std::uint32_t>(i % 4);
      p.room = static_cast<std::uint32_t>(i / 4);
      structure.push_back(p);
    }
    pcl::PCLPointCloud2 blob;
    pcl::toPCLPointCloud2(structure, blob);
    saveBlob(in("whole.pcd"), blob);
    saveStructure(in("pieces.pcd"), structure);
    EXPECT_EQ(bytesOf(in("pieces.pcd")), bytesOf(in("whole.pcd")));
  }
}

TEST_F(CloudFiles, AFileIsWrittenWholeOrNotAtAll)
{
  const std::string path = write("old", "a.txt");
  EXPECT_THROW(writeWhole(path,
                          [](std::ostream& stream) {
                            stream << "half of the ne";
                            throw ToolError("stopped");
                          }),
               ToolError);
  EXPECT_THROW(writeWhole(path, [](std::ostream& s) { s.setstate(std::ios::badbit); }),
               ToolError);
  EXPECT_EQ(bytesOf(path), "old");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.path()), {}), 1);
  EXPECT_THROW(checkWritable("/dev/null"), ToolError);
  EXPECT_THROW(checkWritable(folder_.path().string()), ToolError);
  std::filesystem::create_symlink(path, in("link"));
  writeWhole(in("link"), [](std::ostream& stream) { stream << "new"; });
  EXPECT_TRUE(std::filesystem::is_symlink(in("link")));
  EXPECT_EQ(bytesOf(path), "new");
}

} // namespace
