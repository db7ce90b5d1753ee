// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_surface/structure_chain.h>

#include "sedr_filters/src/rays/mirrored_points.h"

#include <algorithm>
#include <limits>

namespace pcl::sedr {

void
StructureChain::leaveOutMirrored(const ScanPositions& positions,
                                 std::size_t step,
                                 Cloud& thinned,
                                 std::vector<Eigen::Vector3f>& rows)
{
  const MirroredPoints found = findMirroredPoints(
      PointView(thinned), PointView(rows.data(), sizeof(Eigen::Vector3f), rows.size()),
      step, positions, room_segmentation.getNumberOfThreads());
  mirrored.positions = static_cast<std::size_t>(
      std::count_if(positions.begin(), positions.end(),
                    [](const ScanPosition& position) { return position.isKnown(); }));
  mirrored.untrue = static_cast<std::size_t>(std::count_if(
      positions.begin(), positions.end(), [&](const ScanPosition& position) {
        return std::find(found.untrue.begin(), found.untrue.end(), position.place) !=
               found.untrue.end();
      }));
  mirrored.rays = found.rays;
  mirrored.mirrors = found.mirrors;
  mirrored.lines =
      found.lines.empty() ? nullptr : std::make_shared<SightLines>(found.lines);
  mirrored.behind.clear();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < thinned.size(); ++i)
    if (found.of_thinned[i] == 0) {
      thinned[kept++] = thinned[i];
      mirrored.behind.push_back(found.behind[i]);
    }
  mirrored.points = thinned.size() - kept;
  thinned.resize(kept);
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (found.of_rows[k] != 0)
      rows[k].setConstant(std::numeric_limits<float>::quiet_NaN());
}

} // namespace pcl::sedr
