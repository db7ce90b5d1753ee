// SPDX-License-Identifier: BSD-3-Clause
#include "says.h"
#include "surface/mesh/meshes.h"
#include "surface/poisson/oriented_rooms.h"
#include "tools/in_folder.h"
#include "tools/sample_files.h"

#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstring>

using namespace programs;
using namespace sedr_test;
using pcl::sedr::checkTopology;
using pcl::sedr::loadMesh;
using pcl::sedr::meshToPly;

namespace {

// A PCD with normals, label and room.
std::string
structureBytes(const std::vector<pcl::sedr::OrientedPoint>& points, std::uint32_t room)
{
  std::string bytes =
      pcdHeader("x y z normal_x normal_y normal_z label room", points.size());
  for (const auto& p : points) {
    const std::uint32_t label = p.normal.z() > 0.5f ? 2 : p.normal.z() < -0.5f ? 1 : 3;
    bytes.append(reinterpret_cast<const char*>(p.position.data()), 12);
    bytes.append(reinterpret_cast<const char*>(p.normal.data()), 12);
    bytes.append(reinterpret_cast<const char*>(&label), 4);
    bytes.append(reinterpret_cast<const char*>(&room), 4);
  }
  return bytes;
}

class SurfaceTools : public InFolder<> {
protected:
  void writeCloud(const std::vector<std::uint32_t>& labels = {})
  {
    writeFile(in("cloud.pcd"),
              pcdBytes({{0.5f, 0.5f, 1.25f}, {0.5f, 0.5f, 1.03f}}, labels));
  }
};

TEST_F(SurfaceTools, a_room_becomes_a_closed_mesh_with_rooms_and_labels)
{
  writeFile(in("room.pcd"), structureBytes(orientedPoints(smallRoom(), 0.125), 4));
  const ProgramRun result =
      done(run(STRUCTURAL_POISSON, {in("room.pcd"), in("mesh.ply")}));
  EXPECT_EQ(result.out + result.err, ""); // quiet when piped
  TriangleMesh mesh;
  ASSERT_EQ(loadMesh(in("mesh.ply"), mesh), "");
  EXPECT_TRUE(checkTopology(mesh).isClosedManifold());
  EXPECT_EQ(checkTopology(mesh).components.size(), 1u);
  EXPECT_NEAR(mesh.signedVolume(), -3 * 2.5 * 2.5, 0.3);
  ASSERT_EQ(mesh.rooms.size(), mesh.triangles.size());
  EXPECT_EQ(mesh.rooms[0], 4u);
  EXPECT_EQ(mesh.labels.size(), mesh.triangles.size());
}

TEST_F(SurfaceTools, poisson_refuses_what_it_cannot_use)
{
  const auto expectRefused = [&](const std::string& cloud, const std::string& mesh,
                                 int exit_code, const std::string& words,
                                 const std::vector<std::string>& options = {}) {
    expectSentence(run(STRUCTURAL_POISSON, {in(cloud), in(mesh)}, options), exit_code,
                   words);
  };
  writeCloud();
  writeFile(in("few.pcd"),
            structureBytes({{{0, 0, 0}, {0, 0, 1}}, {{1, 0, 0}, {0, 0, 1}}}, 1));
  expectRefused("none.pcd", "mesh.ply", 1, "none.pcd");
  expectRefused("cloud.pcd", "mesh.ply", 2, "has no normals");
  expectRefused("cloud.pcd", "mesh.obj", 1, ".ply");
  expectRefused("cloud.pcd", "no/mesh.ply", 1, "no");
  expectRefused("cloud.pcd", "mesh.ply", 1, "depth", {"--depth", "99"});
  expectRefused("few.pcd", "mesh.ply", 2, "there are 2");
  EXPECT_FALSE(std::filesystem::exists(in("mesh.ply")));
}

TEST_F(SurfaceTools, evaluation_prints_and_writes_the_figures_that_its_inputs_allow)
{
  writeFile(in("cube.ply"), meshToPly(unitCube()));
  writeFile(in("large.ply"), meshToPly(box({-0.01, -0.01, -0.01}, {1.01, 1.01, 1.01})));
  writeCloud({1, 3});
  ProgramRun result = done(run(MESH_EVALUATION, {in("cube.ply")}));
  EXPECT_TRUE(says(result.out, "closed manifold     yes"));
  EXPECT_FALSE(says(result.out, "distances"));

  result = done(run(MESH_EVALUATION,
                    {in("large.ply"), "--truth", in("cube.ply"), "--cloud",
                     in("cloud.pcd"), "--labels", "3", "--json", in("figures.json")}));
  EXPECT_TRUE(says(result.out, "truth to model     15000    1.000",
                   "cloud to model         1    2.000"));
  const std::string json = bytesOf(in("figures.json"));
  EXPECT_TRUE(says(json, "\"closed_manifold\": true", "\"truth_to_mesh\""));
}

TEST_F(SurfaceTools, evaluation_refuses_what_it_cannot_use)
{
  writeFile(in("cube.ply"), meshToPly(unitCube()));
  writeCloud({1, 3});
  const auto expectRefused = [&](const std::vector<std::string>& options,
                                 const std::string& words, int exit_code = 1) {
    expectSentence(run(MESH_EVALUATION, {in("cube.ply")}, options), exit_code, words);
  };
  expectSentence(run(MESH_EVALUATION, {in("none.ply")}), 1, "cannot be opened");
  expectSentence(run(MESH_EVALUATION, {in("cloud.pcd")}), 1,
                 "neither a PLY nor an OBJ");
  expectRefused({"--truth", in("none.ply")}, "none.ply");
  expectRefused({"--cloud", in("none.pcd")}, "none.pcd");
  expectRefused({"--labels", "1"}, "no --cloud");
  expectRefused({"--cloud", in("cloud.pcd"), "--labels", "1,x"}, "1,x");
  expectRefused({"--cloud", in("cloud.pcd"), "--labels", "7,8"}, "none of the 2 points",
                2);
  expectRefused({"--json", in("no/f.json")}, "no");
}

} // namespace
