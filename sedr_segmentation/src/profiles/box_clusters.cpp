// SPDX-License-Identifier: BSD-3-Clause
#include "box_clusters.h"

#include <algorithm>

namespace pcl::sedr {

namespace {

bool
overlap(const CellBox& a, const CellBox& b)
{
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y &&
         b.low.y <= a.high.y;
}

CellBox
hull(const CellBox& a, const CellBox& b)
{
  return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
          {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}

} // namespace

std::vector<CellBox>
clusterBoxes(const std::vector<CellBox>& boxes, int margin)
{
  std::vector<CellBox> clusters;
  for (const CellBox& box : boxes) {
    if (box.count() == 0)
      continue;
    CellBox joined = grown(box, margin);
    for (std::size_t i = 0; i < clusters.size();) {
      if (!overlap(joined, clusters[i])) {
        ++i;
        continue;
      }
      joined = hull(joined, clusters[i]); // may overlap clusters tested before
      clusters.erase(clusters.begin() + static_cast<std::ptrdiff_t>(i));
      i = 0;
    }
    clusters.push_back(joined);
  }
  return clusters;
}

} // namespace pcl::sedr
