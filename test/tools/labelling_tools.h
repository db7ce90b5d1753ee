// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_cloud.h"
#include "tool_contract.h"

#include <gtest/gtest.h>

namespace programs {

using Strings = std::vector<std::string>;

/** Runs a tool that labels a scan or fits a plan to it, in a temporary folder. */
class LabellingTools : public InFolder<> {
protected:
  ProgramRun runOn(const std::string& tool,
                   const std::string& bytes,
                   const std::string& output,
                   const Strings& options = {})
  {
    writeFile(in("input.pcd"), bytes);
    return run(tool, {in("input.pcd"), in(output)}, options);
  }

  /** Expects exit code 2, a sentence with `words`, and no output. */
  void expectNothingFound(const ProgramRun& result, const std::string& words) const
  {
    expectSentence(result, 2, words);
    EXPECT_FALSE(std::filesystem::exists(in("output.pcd")));
    EXPECT_FALSE(std::filesystem::exists(in("output.json")));
  }

  /** Returns the share of points with label `truth` that now have label `found`. */
  static double share(const RoomScan& scan,
                      const pcl::sedr::tools::ToolCloud& cloud,
                      Label truth,
                      Label found)
  {
    std::size_t all = 0;
    std::size_t right = 0;
    for (std::size_t i = 0; i < scan.points.size(); ++i)
      if (scan.points[i].label == truth) {
        ++all;
        right += cloud.label[i] == static_cast<std::uint32_t>(found) ? 1 : 0;
      }
    return static_cast<double>(right) / static_cast<double>(all);
  }

  static void expectIntensity(const pcl::sedr::tools::ToolCloud& cloud)
  {
    const auto intensity = pcl::sedr::tools::floatField(cloud.blob, "intensity");
    ASSERT_EQ(intensity.size(), cloud.size());
    for (std::size_t i = 0; i < intensity.size(); ++i)
      ASSERT_EQ(intensity[i], static_cast<float>(i));
  }

  pcl::sedr::Floorplan plan() const
  {
    std::string problem;
    auto result = pcl::sedr::floorplanFromJson(bytesOf(in("output.json")), problem);
    EXPECT_EQ(problem, "");
    return result;
  }
};

} // namespace programs
