// SPDX-License-Identifier: BSD-3-Clause
#include "scan_rays.h"

namespace pcl::sedr {

std::vector<ScanRay>
raysOf(const PointView& points,
       std::size_t step,
       const ScanPositions& positions,
       const CubeTable& cubes,
       unsigned max_a_cube)
{
  constexpr std::size_t nowhere = static_cast<std::size_t>(-1);
  struct Seen {
    std::size_t last = nowhere; ///< position
    unsigned rays = 0;
  };
  std::vector<Seen> seen(cubes.size());
  std::vector<ScanRay> rays;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t position = positionOfRow(positions, i * step);
    if (position == positions.size() || !positions[position].isKnown() ||
        !points.isFinite(i))
      continue;
    const Eigen::Vector3f to = points[i];
    const std::uint32_t cube = cubes.findAt(to.cast<double>());
    if (cube == CubeTable::none || seen[cube].last == position ||
        seen[cube].rays == max_a_cube)
      continue;
    seen[cube].last = position;
    ++seen[cube].rays;
    rays.push_back({positions[position].place, to, cube});
  }
  return rays;
}

} // namespace pcl::sedr
