// SPDX-License-Identifier: BSD-3-Clause
#include "scan_check.h"

#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/base/parallel.h"

#include <algorithm>
#include <array>
#include <atomic>

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

/** @brief Number of points per block. */
constexpr std::size_t block = std::size_t{1} << 16;

/** @brief Counts the finite points from `begin` to `end`. */
std::size_t
countFinite(const PointView& points, std::size_t begin, std::size_t end)
{
  // Usually all are finite: then the sums of 0 * value are 0, else NaN. Four sums avoid
  // data dependencies.
  std::array<float, 4> zero{};
  for (std::size_t i = begin; i < end; ++i)
    zero[i % 4] += 0 * points[i].sum();
  if (zero[0] + zero[1] + zero[2] + zero[3] == 0)
    return end - begin;
  std::size_t finite = 0;
  for (std::size_t i = begin; i < end; ++i)
    finite += points.isFinite(i) ? 1 : 0;
  return finite;
}

} // namespace

void
ScanSample::add(const PointView& points, unsigned threads)
{
  add(points, [&](const RowSource::SeeRun& see_run) {
    parallelBlocks(points.size(), block, threads, see_run);
  });
}

void
ScanSample::add(const PointView& points, const Read& read)
{
  const std::size_t blocks = (points.size() + block - 1) / block;
  std::vector<std::atomic<std::size_t>> finite(blocks);
  for (auto& count : finite)
    count = 0;
  read([&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin / block; b * block < end; ++b)
      finite[b] += countFinite(points, std::max(begin, b * block),
                               std::min(end, (b + 1) * block));
  });
  for (std::size_t b = 0; b < blocks; ++b) {
    const std::size_t begin = b * block;
    const std::size_t end = std::min(begin + block, points.size());
    if (finite[b] < end - begin) {
      for (std::size_t i = begin; i < end; ++i)
        add(points[i]);
      continue;
    }
    for (std::size_t k = (step_ - finite_ % step_) % step_; k < finite[b]; k += step_)
      sample_.push_back(points[begin + k]);
    finite_ += finite[b];
  }
}

bool
ScanSample::isTooLarge(const Priors& priors) const
{
  return !sample_.empty() && exceedsBuildings(extentsOf(sample_), priors);
}

std::string
ScanSample::problem(const Priors& priors) const
{
  const auto fewest = static_cast<std::size_t>(priors.min_scan_points);
  if (finite_ < fewest)
    return formatText("%.0f of %.0f points are finite, a room needs at least %.0f",
                      static_cast<double>(finite_), static_cast<double>(size_),
                      static_cast<double>(fewest));
  const Eigen::Vector3d extents = extentsOf(sample_);
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

std::string
scanProblem(const PointView& points,
            const std::vector<int>& indices,
            const Priors& priors)
{
  ScanSample sample(indices.size());
  for (const int i : indices)
    sample.add(points[static_cast<std::size_t>(i)]);
  return sample.problem(priors);
}

} // namespace pcl::sedr
