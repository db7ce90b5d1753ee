// SPDX-License-Identifier: BSD-3-Clause
#include "surface/mesh/meshes.h"
#include "tools/in_folder.h"

#include <gtest/gtest.h>
#include <pcl/PolygonMesh.h>
#include <pcl/common/io.h>
#include <pcl/conversions.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_types.h>
#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_surface/floorplan_ifc.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <fstream>
#include <tuple>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

class MeshIo : public programs::InFolder<> {
protected:
  std::string write(const std::string& name, const std::string& content) const
  {
    std::ofstream(in(name), std::ios::binary) << content;
    return in(name);
  }
};

void
expectFailure(const std::string& reason,
              const std::string& part,
              const TriangleMesh& mesh)
{
  EXPECT_TRUE(says(reason, part));
  EXPECT_TRUE(mesh.empty());
  EXPECT_TRUE(mesh.vertices.empty());
}

const std::string ascii_square =
    "ply\nformat ascii 1.0\ncomment made by hand\n"
    "element vertex 4\nproperty double x\nproperty double y\n"
    "property double z\nproperty uchar red\nelement face 1\n"
    "property list uchar int vertex_index\nend_header\n"
    "0 0 0 255\n2 0 0 255\n2 2 0 0\n0 2 1e0 0\n4 0 1 2 3\n";

TEST_F(MeshIo, a_mesh_comes_back_to_the_last_digit_of_a_float)
{
  TriangleMesh mesh = torus();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    mesh.labels.push_back(static_cast<std::uint32_t>(t % 6));
    mesh.rooms.push_back(static_cast<std::uint32_t>(t % 3));
  }
  write("torus.ply", meshToPly(mesh));
  TriangleMesh copy;
  ASSERT_EQ(loadMesh(in("torus.ply"), copy), "");
  EXPECT_EQ(copy.triangles, mesh.triangles);
  EXPECT_EQ(copy.labels, mesh.labels);
  EXPECT_EQ(copy.rooms, mesh.rooms);
  ASSERT_EQ(copy.vertices.size(), mesh.vertices.size());
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    EXPECT_EQ(copy.vertices[v].cast<float>(), mesh.vertices[v].cast<float>());
}

TEST_F(MeshIo, pcl_reads_labels_rooms_and_colours_of_vertices)
{
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 3}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 1}};
  mesh.labels = {2, 3};
  mesh.rooms = {7, 7};
  write("corner.ply", meshToPly(mesh));
  pcl::PolygonMesh read;
  ASSERT_GE(pcl::io::loadPLYFile(in("corner.ply"), read), 0);
  EXPECT_EQ(read.polygons.size(), 2u);
  pcl::PointCloud<pcl::PointXYZL> labelled;
  pcl::fromPCLPointCloud2(read.cloud, labelled);
  ASSERT_EQ(labelled.size(), 4u);
  EXPECT_EQ(labelled[3].z, 3);
  EXPECT_EQ(labelled[2].label, 2u);
  EXPECT_EQ(labelled[3].label, 3u);
  EXPECT_EQ(labelled[0].label, 3u) << "the wall is the larger one there";
  pcl::PointCloud<pcl::PointXYZRGB> coloured;
  pcl::fromPCLPointCloud2(read.cloud, coloured);
  EXPECT_EQ(coloured[2].r, 184) << "a floor's";
  EXPECT_EQ(coloured[3].b, 219) << "a wall's";
  EXPECT_GE(pcl::getFieldIndex(read.cloud, "room"), 0);
}

TEST_F(MeshIo, ascii_ply_with_polygons_other_properties_and_names_is_read)
{
  TriangleMesh mesh;
  ASSERT_EQ(loadMesh(write("square.ply", ascii_square), mesh), "");
  EXPECT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.vertices[3], Eigen::Vector3d(0, 2, 1));
  EXPECT_TRUE(mesh.labels.empty());
}

TEST_F(MeshIo, big_endian_ply_is_read)
{
  std::string content = "ply\r\nformat binary_big_endian 1.0\r\nelement vertex 3\r\n"
                        "property float x\r\nproperty float y\r\nproperty float z\r\n"
                        "element face 1\r\nproperty list uchar uint vertex_indices\r\n"
                        "end_header\r\n";
  const char zero[] = "\0\0\0\0";
  const char one[] = "\x3f\x80\0\0";
  for (const char* value : {zero, zero, zero, one, zero, zero, zero, one, zero})
    content.append(value, 4);
  content.append("\x03\0\0\0\0\0\0\0\x01\0\0\0\x02", 13);
  TriangleMesh mesh;
  ASSERT_EQ(loadMesh(write("big.ply", content), mesh), "");
  EXPECT_NEAR(mesh.area(), 0.5, 1e-12);
}

TEST_F(MeshIo, obj_with_slashes_negative_indices_and_a_concave_polygon_is_read)
{
  TriangleMesh mesh;
  ASSERT_EQ(
      loadMesh(write("l.obj",
                     "# an L\nv 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\n"
                     "vn 0 0 1\no room\nf 1//1 2//1 3//1 4//1 -2 -1\n"),
               mesh),
      "");
  EXPECT_EQ(mesh.triangles.size(), 4u);
  EXPECT_NEAR(mesh.area(), 3, 1e-12); // a plain fan would give more
  for (std::size_t t = 0; t < 4; ++t)
    EXPECT_GT(mesh.scaledNormal(t).z(), 0);
}

TEST_F(MeshIo, bad_files_are_told_apart)
{
  TriangleMesh mesh = unitCube();
  expectFailure(loadMesh(in("none.ply"), mesh), "cannot be opened", mesh);
  expectFailure(loadMesh(folder_.path().string(), mesh), "is a folder", mesh);
  for (const auto& [name, content, part] :
       {std::tuple("0", "", "is empty"),
        {"text", "hello\n", "neither a PLY nor an OBJ"},
        {"h.ply", "ply\nformat ascii 1.0\n", "header does not end"},
        {"f.ply", "ply\nformat utf8 1.0\nend_header\n", "its format is 'utf8'"},
        {"b.ply", "ply\nformat ascii 1.0\nelement vertex\n",
         "'' is no number of elements"},
        {"p.obj", "v 1 2 3\n", "1 vertices and no triangles"},
        {"r.obj", "v 1 2 3\nv 2 2 3\nv 1 3 3\nf 1 2 4\n", "bad vertex '4' in line 4"},
        {"v.obj", "v 1 2 3\nv 2 2\nf 1 1 1\n", "without three coordinates in line 2"}})
    expectFailure(loadMesh(write(name, content), mesh), part, mesh);
}

TEST_F(MeshIo, every_truncation_of_a_file_is_noticed)
{
  const std::string whole = meshToPly(unitCube());
  for (std::size_t size = 1; size < whole.size(); size += 7) {
    TriangleMesh mesh;
    EXPECT_NE(loadMesh(write("part.ply", whole.substr(0, size)), mesh), "") << size;
    EXPECT_TRUE(mesh.empty());
  }
  TriangleMesh mesh;
  expectFailure(loadMesh(write("part.ply", whole.substr(0, whole.size() - 1)), mesh),
                "11 of 12 rows of 'face'", mesh);
}

TEST(Schedules, CsvQuotesWhatNeedsIt)
{
  const ScheduleTable table{"rooms",
                            {"id", "name"},
                            {{"1", "hall"}, {"2", "Bad, \"blau\""}}};
  EXPECT_EQ(csvOf(table), "id,name\r\n1,hall\r\n2,\"Bad, \"\"blau\"\"\"\r\n");
  const ScheduleTable formulas{"rooms",
                               {"a", "b"},
                               {{"=1+2", "-0.250"}, {"@SUM(A1)", ""}}};
  EXPECT_EQ(csvOf(formulas), "a,b\r\n'=1+2,-0.250\r\n'@SUM(A1),\r\n");
}

} // namespace
