// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "box_room.h"
#include "in_folder.h"
#include "tool_cloud.h"

#include <pcl/sedr_filters/floorplan_io.h>

#include <ostream>

namespace programs {

using Strings = std::vector<std::string>;

/** The program of a stage: "pcl_x INPUT OUTPUT [options]" or "pcl_x INPUT PLAN.json
 * OUTPUT [options]". */
struct Tool {
  std::string program;
  std::string output = "output.pcd";
  bool takes_plan = false;
};

inline const std::vector<Tool>&
stageTools()
{
  static const std::vector<Tool> tools{{PARALLEL_VOXEL_GRID},
                                       {ROOM_SEGMENTATION},
                                       {HORIZONTAL_PLANE_DETECTION},
                                       {GRID_REGION_OUTLIER_REMOVAL},
                                       {GRID_SLICE_DETAIL},
                                       {FLOOR_PROJECTION_RECOVERY},
                                       {CEILING_BOUNDARY_WALL_GROWING},
                                       {FLOORPLAN_FITTING, "output.json"},
                                       {OPENING_DETECTION, "output.json", true},
                                       {STRUCTURE_REFINEMENT, "output.pcd", true},
                                       {VERTICAL_HOLE_REPAIR, "output.pcd", true}};
  return tools;
}

inline std::ostream&
operator<<(std::ostream& stream, const Tool& tool)
{
  return stream << std::filesystem::path(tool.program).filename();
}

/** Runs programs of stages in a temporary folder. */
template <typename TestT = ::testing::Test>
class StageToolRuns : public InFolder<TestT> {
protected:
  using InFolder<TestT>::in;

  pcl::sedr::tools::ToolCloud output() const
  {
    return pcl::sedr::tools::loadCloud(in("output.pcd"));
  }

  /** Runs a tool on a file, with the plan of a room if it takes one. */
  ProgramRun runTo(const std::string& output,
                   const Tool& tool,
                   const std::string& input,
                   const Strings& options = {})
  {
    if (!tool.takes_plan)
      return run(tool.program, {input, output}, options);
    if (!std::filesystem::exists(in("input_plan.json")))
      writeFile(in("input_plan.json"),
                pcl::sedr::floorplanToJson({{planOf(BoxRoom())}}));
    return run(tool.program, {input, in("input_plan.json"), output}, options);
  }

  /** Runs a tool on the bytes of a file. */
  ProgramRun
  runOn(const Tool& tool, const std::string& bytes, const Strings& options = {})
  {
    writeFile(in("input.pcd"), bytes);
    return runTo(in(tool.output), tool, in("input.pcd"), options);
  }

  /** Expects the exit code, one sentence with `words`, and no new file. */
  void expectFailure(const ProgramRun& result,
                     int exit_code,
                     const std::string& words = "") const
  {
    expectSentence(result, exit_code, words);
    for (const auto& entry : std::filesystem::directory_iterator(this->folder_.path()))
      EXPECT_EQ(entry.path().filename().string().compare(0, 5, "input"), 0)
          << entry.path() << " was left behind";
  }
};

} // namespace programs
