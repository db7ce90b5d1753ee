// SPDX-License-Identifier: BSD-3-Clause
// What programs have in common.
#include "option_help.h"
#include "stage_tools.h"
#include "tools/pictures/pictures.h"

namespace {

using namespace programs;

class ToolContract : public StageToolRuns<::testing::TestWithParam<Tool>> {
protected:
  const std::string& program() const { return GetParam().program; }
  std::string output() const { return in(GetParam().output); }
  ProgramRun onFile(const std::string& bytes) { return runOn(GetParam(), bytes); }
};

class FileToolContract : public ToolContract {};
class StageToolContract : public ToolContract {};

/** The stages, and programs that mesh points or read a plan. */
std::vector<Tool>
fileTools()
{
  std::vector<Tool> tools = stageTools();
  for (const Tool& tool :
       {Tool{STRUCTURAL_POISSON, "output.ply"}, Tool{FLOORPLAN_EXTRUSION, "output.ply"},
        Tool{FLOORPLAN_DRAWING, "output.svg"}})
    tools.push_back(tool);
  return tools;
}

std::vector<Tool>
allTools()
{
  std::vector<Tool> tools = fileTools();
  for (const char* const program : {SEDR, SIMULATE_INDOOR_SCAN})
    tools.push_back({program, "output_folder"});
  return tools;
}

INSTANTIATE_TEST_SUITE_P(All, ToolContract, ::testing::ValuesIn(allTools()));
INSTANTIATE_TEST_SUITE_P(Files, FileToolContract, ::testing::ValuesIn(fileTools()));
INSTANTIATE_TEST_SUITE_P(Stages, StageToolContract, ::testing::ValuesIn(stageTools()));

TEST_P(ToolContract, HelpTellsUsageAndEveryDefault)
{
  const ProgramRun help = done(run(program(), {"-h"}));
  EXPECT_EQ(help.err, "");
  EXPECT_TRUE(says(help.out, "Usage: pcl_"));
  const std::vector<OptionHelp> options = optionsIn(help.out);
  EXPECT_FALSE(options.empty());
  for (const auto& option : options)
    EXPECT_TRUE(option.tellsDefault()) << option.name;
}

TEST_P(ToolContract, NumbersThatAreNoneOrOutOfRangeAreRefused)
{
  std::string value = "many";
  for (const auto& option : optionsIn(run(program(), {"-h"}).out))
    if (option.hasRange()) {
      expectFailure(
          runTo(output(), GetParam(), in("input.pcd"), {"--" + option.name, value}), 1,
          "--" + option.name);
      value = "-1";
    }
}

TEST_P(ToolContract, BadCommandLinesAreRefused)
{
  for (const Strings& arguments : {Strings{},
                                   {"a.pcd"},
                                   {"a.pcd", "b.pcd", "c.pcd", "d.pcd"},
                                   {"a.pcd", "b.pcd", "--no-such-option"}})
    expectFailure(run(program(), arguments), 1);
}

TEST_P(ToolContract, FilesThatAreNoInputsAreRefused)
{
  for (const std::string& path : {in("missing.pcd"), folder_.path().string()})
    expectFailure(runTo(output(), GetParam(), path), 1);
  const std::string good = pcdBytes({{1, 2, 3}, {1, 2, 4}}, {1, 2});
  for (const std::string& bytes :
       {std::string(), std::string("no cloud at all\n"), std::string(5000, '\0'),
        std::string("{}"), std::string(R"({"format": "sedr-floorplan"})"), pcdBytes({}),
        good.substr(0, good.size() - 1), good.substr(0, 60)})
    expectFailure(onFile(bytes), 1);
}

TEST_P(FileToolContract, OutputsThatCannotBeWrittenAreRefusedBeforeTheWork)
{
  writeFile(in("input.pcd"), pcdBytes({{1, 2, 3}}));
  const std::string folder = in("input_folder_" + GetParam().output);
  std::filesystem::create_directory(folder);
  for (const std::string& path :
       {in("no_folder/" + GetParam().output), in("output.txt"), folder})
    expectFailure(runTo(path, GetParam(), in("input.pcd")), 1);
}

TEST_P(StageToolContract, PicturesAreTheSameEveryTime)
{
  const auto draw = [&] {
    return runOn(GetParam(), scanOf().pcd(true), {"--picture", in("picture.png")});
  };
  writeFile(in("input.pcd"), pcdBytes({{1, 2, 3}}));
  expectFailure(runTo(output(), GetParam(), in("input.pcd"),
                      {"--picture", in("no_folder/picture.png")}),
                1, "no_folder/picture.png");
  const ProgramRun first = done(draw());
  EXPECT_EQ(first.err, "") << "quiet when piped";
  EXPECT_TRUE(std::filesystem::exists(output()));
  const std::string bytes = bytesOf(in("picture.png"));
  const Image image = imageOf(bytes);
  EXPECT_GT(image.width, 400);
  EXPECT_LE(image.width, 1200);
  EXPECT_GT(image.height, 200);
  const auto blank =
      std::count(image.pixels.begin(), image.pixels.end(), colours::paper);
  EXPECT_LT(static_cast<double>(blank),
            0.97 * static_cast<double>(image.pixels.size()));
  done(draw());
  EXPECT_TRUE(bytesOf(in("picture.png")) == bytes);
}

} // namespace
