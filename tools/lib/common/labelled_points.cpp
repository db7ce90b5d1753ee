// SPDX-License-Identifier: BSD-3-Clause
#include "labelled_points.h"

#include "tool_error.h"

#include <pcl/sedr_filters/impl/floor_recovery.h>

namespace pcl::sedr::tools {

pcl::Indices
requireLabel(const ToolCloud& cloud, StructureLabel label, const std::string& remedy)
{
  pcl::Indices found = cloud.withLabel(label);
  if (found.empty())
    throw ToolError(
        "none of the " + std::to_string(cloud.size()) + " points of '" + cloud.path +
            "' has label " + std::to_string(static_cast<std::uint32_t>(label)) + ", " +
            pcl::sedr::toString(label) + (remedy.empty() ? "" : "; " + remedy),
        NothingFound);
  return found;
}

std::set<std::uint32_t>
ceilingRooms(const ToolCloud& cloud)
{
  std::set<std::uint32_t> numbers;
  for (const auto i : requireLabel(cloud, StructureLabel::Ceiling))
    numbers.insert(cloud.room[static_cast<std::size_t>(i)]);
  if (numbers.size() > 1)
    numbers.erase(0);
  return numbers;
}

double
meanFloorHeight(const ToolCloud& cloud, const std::string& remedy)
{
  const PointView points(*cloud.points);
  pcl::Indices finite;
  for (const auto i : requireLabel(cloud, StructureLabel::Floor, remedy))
    if (points.isFinite(static_cast<std::size_t>(i)))
      finite.push_back(i);
  if (finite.empty())
    throw ToolError("none of the points of '" + cloud.path +
                        "' with label 2, floor, is finite" +
                        (remedy.empty() ? "" : "; " + remedy),
                    NothingFound);
  return meanHeight(points, finite);
}

} // namespace pcl::sedr::tools
