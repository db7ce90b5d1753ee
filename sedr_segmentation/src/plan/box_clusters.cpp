// SPDX-License-Identifier: BSD-3-Clause
#include "box_clusters.h"

namespace pcl::sedr {

std::vector<CellBox>
clusterBoxes(const std::vector<CellBox>& boxes, int margin)
{
  std::vector<CellBox> clusters;
  for (const CellBox& box : boxes) {
    if (box.count() == 0)
      continue;
    CellBox joined = grown(box, margin);
    for (std::size_t i = 0; i < clusters.size();) {
      if (overlapOf(joined, clusters[i]).count() == 0) {
        ++i;
        continue;
      }
      joined = around(joined, clusters[i]); // may overlap clusters tested before
      clusters.erase(clusters.begin() + static_cast<std::ptrdiff_t>(i));
      i = 0;
    }
    clusters.push_back(joined);
  }
  return clusters;
}

} // namespace pcl::sedr
