// SPDX-License-Identifier: BSD-3-Clause
#include "in_folder.h"
#include "sample_files.h"
#include "surface/mesh/meshes.h"

namespace {

using namespace programs;
using namespace sedr_test;
using pcl::sedr::meshToPly;

class MeshEvaluationTool : public InFolder<> {
protected:
  void SetUp() override
  {
    writeFile(in("cube.ply"), meshToPly(unitCube()));
    writeFile(in("cloud.pcd"),
              pcdBytes({{0.5f, 0.5f, 1.25f}, {0.5f, 0.5f, 1.03f}}, {1, 3}));
  }
};

TEST_F(MeshEvaluationTool, PrintsAndWritesTheFiguresThatItsInputsAllow)
{
  writeFile(in("large.ply"), meshToPly(box({-0.01, -0.01, -0.01}, {1.01, 1.01, 1.01})));
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

TEST_F(MeshEvaluationTool, RefusesWhatItCannotUse)
{
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
