// SPDX-License-Identifier: BSD-3-Clause
#include "scene_check.h"

#include "problems.h"

namespace pcl::sedr::sim {

std::vector<std::string>
problemsOf(const Scene& scene)
{
  Problems problems;
  for (const auto check : {checkRooms, checkOpenings, checkObjects})
    if (problems.empty())
      check(scene, problems);
  return problems.take();
}

} // namespace pcl::sedr::sim
