// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/scan_check.h>

#include <pcl/sedr_filters/cell_grid.h>
#include <pcl/sedr_filters/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

namespace pcl {
namespace sedr {

namespace {

std::string
text(const char* format, double a, double b = 0, double c = 0, double d = 0)
{
  std::array<char, 400> buffer{};
  std::snprintf(buffer.data(), buffer.size(), format, a, b, c, d);
  return buffer.data();
}

// No building, nor a scan of one, is larger, metres.
constexpr double highest = 200;
constexpr double longest = 20000;

/** @brief Extent along one axis of all but the outermost hundredth of the points at
 * each end. */
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

/** @brief Two large planes across an axis: the smaller one's cells, and their distance.
 */
struct PlanePair {
  std::size_t cells = 0;
  double distance = 0;
};

/** @brief The best pair of levels across `axis` that are between `nearest` and
 * `farthest` metres apart: slabs of a decimetre, measured in distinct cells of a
 * decimetre. */
PlanePair
bestPair(const PointView& points,
         const std::vector<int>& indices,
         int axis,
         double nearest,
         double farthest)
{
  constexpr double cell = 0.1;
  const CellGrid grid(cell);
  std::map<std::int64_t, std::vector<CellKey>> slabs;
  for (const int i : indices) {
    const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
    const double u = p[(axis + 1) % 3];
    const double v = p[(axis + 2) % 3];
    if (points.isFinite(static_cast<std::size_t>(i)) && grid.holds(u, v) &&
        grid.holds(p[axis], 0))
      slabs[static_cast<std::int64_t>(std::floor(p[axis] / cell))].push_back(
          keyOf(grid.at(u, v)));
  }
  std::vector<std::pair<std::int64_t, std::size_t>> sizes;
  for (auto& [level, keys] : slabs)
    sizes.emplace_back(level, CellSet(std::move(keys)).size());
  PlanePair best;
  for (std::size_t a = 0; a < sizes.size(); ++a)
    for (std::size_t b = a + 1; b < sizes.size(); ++b) {
      const double distance =
          static_cast<double>(sizes[b].first - sizes[a].first) * cell;
      if (distance > farthest)
        break;
      const std::size_t cells = std::min(sizes[a].second, sizes[b].second);
      if (distance >= nearest && cells > best.cells)
        best = {cells, distance};
    }
  return best;
}

/** @brief Number of the finite points from `begin` to `end`. */
std::size_t
countFinite(const PointView& points, std::size_t begin, std::size_t end)
{
  // Mostly all are: then each adds 0 to a sum that any other makes NaN. Four sums do
  // not wait for each other.
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
ScanSample::add(const PointView& points,
                unsigned threads,
                const std::function<void(std::size_t, std::size_t)>& beside)
{
  constexpr std::size_t block = std::size_t{1} << 16;
  const std::size_t blocks = (points.size() + block - 1) / block;
  std::vector<std::size_t> finite(blocks, 0);
  parallelBlocks(points.size(), block, threads,
                 [&](std::size_t begin, std::size_t end) {
                   finite[begin / block] = countFinite(points, begin, end);
                   if (beside)
                     beside(begin, end);
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
ScanSample::isTooLarge() const
{
  return !sample_.empty() &&
         (extentAlong(sample_, 2) > highest ||
          std::min(extentAlong(sample_, 0), extentAlong(sample_, 1)) > longest);
}

std::string
ScanSample::problem() const
{
  constexpr std::size_t fewest = 1000;
  if (finite_ < fewest)
    return text("%.0f of %.0f points are finite, a room needs at least %.0f",
                static_cast<double>(finite_), static_cast<double>(size_),
                static_cast<double>(fewest));
  const double x = extentAlong(sample_, 0);
  const double y = extentAlong(sample_, 1);
  const double z = extentAlong(sample_, 2);
  if (isTooLarge()) {
    // The unit in which the scan would be up to a few storeys high.
    const bool is_centimetre = z < 10 * highest && std::min(x, y) < longest;
    return text(is_centimetre
                    ? "the scan is %.0f x %.0f x %.0f m large: if its unit is "
                      "the centimetre, scale it by 0.01"
                    : "the scan is %.0f x %.0f x %.0f m large: if its unit is "
                      "the millimetre, scale it by 0.001",
                x, y, z);
  }
  if (std::max(x, y) < 1 || std::max({x, y, z}) < 1.5)
    return text("the scan is %.3f x %.3f x %.3f m large, too small for a room: its "
                "unit must be "
                "the metre",
                x, y, z);
  return {};
}

std::string
scanProblem(const PointView& points, const std::vector<int>& indices)
{
  ScanSample sample(indices.size());
  for (const int i : indices)
    sample.add(points[static_cast<std::size_t>(i)]);
  return sample.problem();
}

std::string
upProblem(const PointView& points, const std::vector<int>& indices, bool z_has_rooms)
{
  constexpr double lowest_room = 1.8;
  constexpr double highest_usual_room = 4.5;
  constexpr double highest_room = 100;
  constexpr std::size_t least_wall = 200; // cells of 10 cm, 2 square metres
  const PlanePair up = bestPair(points, indices, 2, lowest_room, highest_room);
  if (z_has_rooms && (up.cells == 0 || up.distance <= highest_usual_room))
    return {};
  for (const int axis : {1, 0}) {
    const PlanePair other =
        bestPair(points, indices, axis, lowest_room, highest_usual_room);
    if (other.cells >= least_wall && 2 * other.cells > 3 * up.cells)
      return std::string(axis == 1 ? "y" : "x") +
             text(" seems to be up, not z: across it two planes of %.0f square metres "
                  "are %.1f m "
                  "apart, across z of %.0f square metres %.1f m; turn the scan",
                  static_cast<double>(other.cells) * 0.01, other.distance,
                  static_cast<double>(up.cells) * 0.01, up.distance);
  }
  return {};
}

} // namespace sedr
} // namespace pcl
