// SPDX-License-Identifier: BSD-3-Clause
// Figures of doc/real_scans.md for the scans in the folder SEDR_DATA, as printed by the
// programs.
#include "tools/run_program.h"
#include "tools/sample_files.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace programs;

std::string
dataFile(const std::string& name)
{
  const char* folder = std::getenv("SEDR_DATA");
  return (std::filesystem::path(folder ? folder : "") / name).string();
}

/** Returns the numbers after `start` in the last line that begins with it. */
std::vector<double>
figuresAfter(const std::string& start, const std::string& text)
{
  std::istringstream lines(text);
  std::vector<double> figures;
  for (std::string line; std::getline(lines, line);) {
    if (line.compare(0, start.size(), start) != 0)
      continue;
    std::istringstream words(line.substr(start.size()));
    figures.clear();
    for (double figure = 0; words >> figure;)
      figures.push_back(figure);
  }
  return figures;
}

TEST(RealScanFigures, synth1_lies_on_the_model_as_closely_as_on_its_reference)
{
  if (!std::filesystem::exists(dataFile("synth1.pcd")))
    GTEST_SKIP() << "no synth1.pcd in the folder that SEDR_DATA names";
  const TemporaryFolder folder;
  const std::string model = (folder.path() / "model").string();
  ASSERT_EQ(run(SEDR, {dataFile("synth1.pcd"), model, "--no-mesh"}).exit_code, 0);
  const auto figuresOf = [](const std::string& mesh, const std::string& near) {
    const ProgramRun result =
        run(MESH_EVALUATION,
            {mesh, "--cloud", dataFile("synth1.pcd"), "--labels", "2", "--near",
             dataFile("synth1_rooms.obj"), "--near-distance", near});
    return figuresAfter("cloud to model", result.out);
  };
  // Points, mean, rms, median, p95, p99, max, all but the first in centimetres.
  const auto own = figuresOf(dataFile("synth1_rooms.obj"), "0.05");
  const auto ours = figuresOf(model + "/solid.ply", "0.05");
  ASSERT_GE(own.size(), 7u);
  ASSERT_GE(ours.size(), 7u);
  EXPECT_LE(ours[1], 0.06 + own[1]);
  // Furniture edges up to 5 cm off the reference are as far from any model.
  const auto nearest = figuresOf(model + "/solid.ply", "0.03");
  ASSERT_GE(nearest.size(), 7u);
  EXPECT_LE(nearest[6], 3.0);
}

TEST(RealScanFigures, office_ceiling_floor_and_walls_are_found)
{
  if (!std::filesystem::exists(dataFile("office_labelled.pcd")))
    GTEST_SKIP() << "no office_labelled.pcd in the folder that SEDR_DATA names";
  const TemporaryFolder folder;
  const std::string model = (folder.path() / "model").string();
  const std::string scan = dataFile("office_labelled.pcd");
  ASSERT_EQ(run(SEDR, {scan, model, "--no-mesh"}).exit_code, 0);
  const auto scored = run(PYTHON, {LABEL_GRADES, model + "/structure.pcd", scan, "--map",
                                             "0=1,1=2,2=3,3=3,4=3,5=3,6=0"});
  // True, predicted, recall, precision, precision of the structure's points, in %.
  for (const auto& [label, recall] :
       {std::pair<std::string, double>{"ceiling", 94}, {"floor", 95}, {"wall", 88}}) {
    const auto figures = figuresAfter(label, scored.out);
    ASSERT_EQ(figures.size(), 5u) << scored.out << scored.err;
    EXPECT_GE(figures[2], recall) << label;
  }
}

} // namespace
