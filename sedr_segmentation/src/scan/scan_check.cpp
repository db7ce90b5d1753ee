// SPDX-License-Identifier: BSD-3-Clause
#include "scan_check.h"

#include "sedr_filters/src/base/number_text.h"

#include <algorithm>

namespace pcl::sedr {

namespace {

/** @brief Returns the extent along an axis without 1 % of the points at each end. */
double
extentAlong(const std::vector<Eigen::Vector3f>& points, int axis)
{
  std::vector<float> values;
  for (const auto& p : points)
    values.push_back(p[axis]);
  const std::size_t cut = values.size() / 100;
  const auto low = values.begin() + static_cast<std::ptrdiff_t>(cut);
  const auto high = values.end() - 1 - static_cast<std::ptrdiff_t>(cut);
  std::nth_element(values.begin(), low, values.end());
  const double from = *low;
  std::nth_element(values.begin(), high, values.end());
  return *high - from;
}

Eigen::Vector3d
extentsOf(const std::vector<Eigen::Vector3f>& points)
{
  return {extentAlong(points, 0), extentAlong(points, 1), extentAlong(points, 2)};
}

bool
exceedsBuildings(const Eigen::Vector3d& extents, const Priors& priors)
{
  return extents.z() > priors.max_building_height ||
         std::min(extents.x(), extents.y()) > priors.max_building_extent;
}

} // namespace

std::string
scanProblem(const PointView& points,
            const std::vector<int>* indices,
            const Priors& priors)
{
  constexpr std::size_t max_sample = 100000;
  const std::size_t size = indices ? indices->size() : points.size();
  const std::size_t step = size / max_sample + 1;
  std::vector<Eigen::Vector3f> sample;
  std::size_t finite = 0;
  for (std::size_t k = 0; k < size; ++k)
    if (const Eigen::Vector3f p =
            points[indices ? static_cast<std::size_t>((*indices)[k]) : k];
        p.allFinite() && finite++ % step == 0)
      sample.push_back(p);
  const auto fewest = static_cast<std::size_t>(priors.min_scan_points);
  if (finite < fewest)
    return formatText("%.0f of %.0f points are finite, a room needs at least %.0f",
                      static_cast<double>(finite), static_cast<double>(size),
                      static_cast<double>(fewest));
  const Eigen::Vector3d extents = extentsOf(sample);
  const double x = extents.x();
  const double y = extents.y();
  const double z = extents.z();
  if (exceedsBuildings(extents, priors)) {
    // The unit in which the scan would have the height of a building.
    const bool is_centimetre = z < 10 * priors.max_building_height &&
                               std::min(x, y) < priors.max_building_extent;
    return formatText(
        is_centimetre ? "the scan is %.0f x %.0f x %.0f m large: if its unit is "
                        "the centimetre, scale it by 0.01 (--unit 0.01 in pcl_sedr)"
                      : "the scan is %.0f x %.0f x %.0f m large: if its unit is "
                        "the millimetre, scale it by 0.001 (--unit 0.001 in pcl_sedr)",
        x, y, z);
  }
  if (std::max(x, y) < 1 || std::max({x, y, z}) < 1.5)
    return formatText(
        "the scan is %.3f x %.3f x %.3f m large, too small for a room: its "
        "unit must be "
        "the metre",
        x, y, z);
  return {};
}

} // namespace pcl::sedr
