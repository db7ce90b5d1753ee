// SPDX-License-Identifier: BSD-3-Clause
#include "unit_check.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl::sedr {

std::string
inchProblem(const PointView& points, std::size_t storeys)
{
  constexpr float lowest = 60;   // metres, if the metre is the unit
  constexpr float highest = 200; // above, the check of the scan detects the unit
  constexpr float max_a_storey = 30;
  std::vector<float> heights;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points.isFinite(i))
      heights.push_back(points[i].z());
  if (heights.empty())
    return {};
  const auto cut = static_cast<std::ptrdiff_t>(heights.size() / 10);
  std::nth_element(heights.begin(), heights.begin() + cut, heights.end());
  const float low = heights[static_cast<std::size_t>(cut)];
  std::nth_element(heights.begin(), heights.end() - 1 - cut, heights.end());
  const float height = *(heights.end() - 1 - cut) - low;
  if (!(height > lowest && height < highest &&
        height > max_a_storey * static_cast<float>(storeys)))
    return {};
  return "the scan is " + std::to_string(std::lround(height)) +
         " m high: if its unit is the inch, scale it by 0.0254 (--unit 0.0254 in "
         "pcl_sedr)";
}

} // namespace pcl::sedr
