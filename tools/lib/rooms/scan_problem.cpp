// SPDX-License-Identifier: BSD-3-Clause
#include "scan_problem.h"

#include "tool_error.h"

#include "sedr_segmentation/src/scan/scan_inclination.h"

#include <numeric>

namespace pcl::sedr::tools {

namespace {

pcl::Indices
allOf(const ToolCloud& cloud)
{
  pcl::Indices all(cloud.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

} // namespace

void
checkScan(const ToolCloud& cloud)
{
  const std::string problem = scanProblem(PointView(*cloud.points), allOf(cloud));
  if (!problem.empty())
    throw ToolError("'" + cloud.path + "': " + problem, NothingFound);
}

void
checkUp(const ToolCloud& cloud,
        bool trust_up,
        RoomsAlongZ rooms,
        double found_area,
        const std::string& missing)
{
  const PointView points(*cloud.points);
  const pcl::Indices all = allOf(cloud);
  std::string doubt;
  if (!trust_up) {
    doubt = upProblem(points, all, rooms, found_area, 0);
    if (doubt.empty() && rooms != RoomsAlongZ::Found)
      doubt = inclinationProblem(points, all, 0);
    if (!doubt.empty())
      doubt += ", or say --z-up if it is right as it is";
  }
  if (!missing.empty())
    throw ToolError(missing + (doubt.empty() ? "" : "; " + doubt), NothingFound);
  if (!doubt.empty())
    throw ToolError("'" + cloud.path + "': " + doubt, NothingFound);
}

} // namespace pcl::sedr::tools
