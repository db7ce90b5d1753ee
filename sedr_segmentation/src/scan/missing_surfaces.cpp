// SPDX-License-Identifier: BSD-3-Clause
#include "missing_surfaces.h"

#include "patch_normals.h"

#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/base/quantiles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace pcl::sedr {

namespace {

constexpr double patch = 0.3; // metres

/** @brief Returns what is missing of a floor and a ceiling.
 * @param level points on level planes, by height in patches
 * @param upright likewise on upright ones */
std::string
missingLevel(const std::map<long, double>& level,
             const std::map<long, double>& upright,
             double headroom)
{
  double most = 0;
  for (const auto& of_height : level)
    most = std::max(most, of_height.second);
  long low = std::numeric_limits<long>::max(), high = 0;
  for (const auto& [height, count] : level)
    if (4 * count >= most) {
      low = std::min(low, height);
      high = height;
    }
  if (level.empty())
    return "neither a floor nor a ceiling was seen";
  if (static_cast<double>(high - low + 1) * patch > headroom)
    return {};
  double above = 0, below = 0;
  for (const auto& [height, count] : upright) {
    above += height > high ? count : 0;
    below += height < low ? count : 0;
  }
  return above >= below
             ? formatText("a floor was seen at z = %.1f m, but no ceiling above it: it "
                          "is outdoors, or its ceiling is missing",
                          static_cast<double>(low) * patch)
             : formatText("a ceiling was seen at z = %.1f m, but no floor below it",
                          static_cast<double>(high) * patch);
}

} // namespace

MissingSurfaces
missingSurfaces(const PointView& points,
                const std::vector<int>& indices,
                unsigned threads,
                const Priors& priors)
{
  std::vector<PlanePatch> patches;
  for (const double offset : {0.0, 0.5}) { // a surface may lie between two cubes
    const std::vector<PlanePatch> found =
        planesOf(points, indices, Eigen::Matrix3d::Identity(), patch, threads, offset,
                 std::numeric_limits<double>::infinity());
    patches.insert(patches.end(), found.begin(), found.end());
  }
  const double max_scatter = 2 * priors.slab_noise;
  double count = 0;
  std::vector<Weighted> scatters;
  std::map<long, double> level, upright;
  for (const PlanePatch& plane : patches) {
    count += plane.count;
    scatters.push_back({plane.scatter, plane.count});
    if (plane.scatter > max_scatter)
      continue;
    const long height = std::lround(plane.middle.z() / patch);
    if (plane.normal.z() > 0.9)
      level[height] += plane.count;
    else if (plane.normal.z() < 0.2)
      upright[height] += plane.count;
  }
  MissingSurfaces missing;
  if (5 * count < 2 * static_cast<double>(indices.size())) {
    missing.reason =
        "the points are too sparse, or strewn: few cubes of 0.3 m have 20 of them";
    return missing;
  }
  missing.scatter = weightedQuantile(scatters, 0.5);
  missing.is_noisy = missing.scatter > max_scatter;
  missing.reason =
      missing.is_noisy
          ? formatText("half of the points lie %.1f cm or more off the planes that fit "
                       "them best: the scan is too noisy, or its points are strewn",
                       100 * missing.scatter)
          : missingLevel(level, upright, priors.min_headroom);
  return missing;
}

} // namespace pcl::sedr
