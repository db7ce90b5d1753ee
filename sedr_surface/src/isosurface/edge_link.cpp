// SPDX-License-Identifier: BSD-3-Clause
#include "edge_link.h"

#include <algorithm>
#include <iterator>

namespace pcl::sedr {

std::vector<std::uint32_t>
neighboursOf(const TriangleMesh& mesh,
             std::uint32_t v,
             const std::vector<std::uint32_t>& triangles)
{
  std::vector<std::uint32_t> found;
  for (const auto t : triangles)
    for (const auto other : mesh.triangles[t])
      if (other != v)
        found.push_back(other);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

EdgeLink
linkOf(const TriangleMesh& mesh,
       std::uint32_t a,
       const std::vector<std::uint32_t>& at_a,
       std::uint32_t b,
       const std::vector<std::uint32_t>& at_b)
{
  const auto of_a = neighboursOf(mesh, a, at_a);
  const auto of_b = neighboursOf(mesh, b, at_b);
  EdgeLink link{of_a.size(), of_b.size(), {}};
  std::set_intersection(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(),
                        std::back_inserter(link.common));
  return link;
}

} // namespace pcl::sedr
