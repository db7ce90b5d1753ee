// SPDX-License-Identifier: BSD-3-Clause
#include "scan_check.h"

#include "sedr_filters/src/base/middle_value.h"
#include "sedr_filters/src/base/parallel.h"
#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace pcl::sedr {

namespace {

std::string
text(const char* format, double a, double b = 0, double c = 0, double d = 0)
{
  std::array<char, 400> buffer{};
  std::snprintf(buffer.data(), buffer.size(), format, a, b, c, d);
  return buffer.data();
}

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
    return text("%.0f of %.0f points are finite, a room needs at least %.0f",
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
    return text(is_centimetre
                    ? "the scan is %.0f x %.0f x %.0f m large: if its unit is "
                      "the centimetre, scale it by 0.01 (--unit 0.01 in pcl_sedr)"
                    : "the scan is %.0f x %.0f x %.0f m large: if its unit is "
                      "the millimetre, scale it by 0.001 (--unit 0.001 in pcl_sedr)",
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
scanProblem(const PointView& points,
            const std::vector<int>& indices,
            const Priors& priors)
{
  ScanSample sample(indices.size());
  for (const int i : indices)
    sample.add(points[static_cast<std::size_t>(i)]);
  return sample.problem(priors);
}

namespace {

constexpr double foot = 0.3048; ///< metres

/** @brief What a height of doors or scanners tells of the unit. */
enum class Unit { Unknown, Metre, Foot };

/** @brief Returns what the median of heights that are at most those of doors tells.
 * @param min_height of such things, metres */
Unit
unitOf(const std::vector<double>& heights, double min_height, const Priors& priors)
{
  if (heights.empty())
    return Unit::Unknown;
  const double height = middleValue(heights);
  const double in_feet = height * foot;
  if (height <= priors.max_door_height || in_feet < min_height)
    return Unit::Metre;
  return in_feet <= priors.max_door_height ? Unit::Foot : Unit::Unknown;
}

std::vector<double>
heightsOfDoors(const Floorplan& plan)
{
  std::vector<double> heights;
  for (const PlanDoorway& doorway : plan.doorways)
    heights.push_back(doorway.top - doorway.bottom);
  return heights;
}

/** @brief Returns how far above the floors of rooms the scanner stood. */
std::vector<double>
heightsOfScanners(const Floorplan& plan, const std::vector<Eigen::Vector3f>& places)
{
  std::vector<double> heights;
  for (const Eigen::Vector3f& place : places) {
    const Eigen::Vector3d p = place.cast<double>();
    for (const PlanRoom& room : plan.rooms)
      if (p.z() > room.floor.heightAt(p.head<2>()) &&
          p.z() < room.ceiling.heightAt(p.head<2>()) && room.contains(p.head<2>()))
        heights.push_back(p.z() - room.floor.heightAt(p.head<2>()));
  }
  return heights;
}

} // namespace

std::string
footProblem(const Floorplan& plan,
            const std::vector<Eigen::Vector3f>& places,
            const Priors& priors)
{
  constexpr double sliver = 0.1; // of the largest room; smaller rooms are ignored
  double whole_area = 0;
  double high_area = 0;
  double largest_area = 0;
  for (const PlanRoom& room : plan.rooms)
    largest_area = std::max(largest_area, room.area());
  std::size_t rooms = 0;
  std::vector<double> heights; // of rooms that are high enough in feet
  std::vector<double> areas;   // of those as high as in homes
  for (const PlanRoom& room : plan.rooms) {
    if (room.boundary.elements.empty() || room.area() < sliver * largest_area)
      continue;
    ++rooms;
    const double height = clearHeight(room).usual;
    whole_area += room.area();
    if (height * foot < priors.min_home_height)
      continue;
    heights.push_back(height);
    high_area += room.area();
    if (height * foot <= priors.max_home_height)
      areas.push_back(room.area());
  }
  const double most = priors.share_most * whole_area;
  if (heights.empty() || high_area < most)
    return {};
  const std::vector<double> doors = heightsOfDoors(plan);
  const std::vector<double> stood = heightsOfScanners(plan, places);
  const Unit by_doors = unitOf(doors, priors.min_headroom, priors);
  const Unit by_scanners = unitOf(stood, 0, priors);
  if (by_doors == Unit::Metre || by_scanners == Unit::Metre)
    return {};
  const Unit unit = by_doors == Unit::Unknown ? by_scanners : by_doors;
  const bool is_home =
      std::accumulate(areas.begin(), areas.end(), 0.0) >= most &&
      (unit == Unit::Foot || middleValue(areas) * foot * foot <= priors.max_home_area);
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  std::string sentence =
      heights.size() == 1 ? text("the room is %.1f m high", *low)
                          : (heights.size() == rooms ? "all " : "") +
                                text("%.0f rooms are %.1f to %.1f m high",
                                     static_cast<double>(heights.size()), *low, *high);
  if (by_doors == Unit::Foot)
    sentence += text(", doors are %.1f m high", middleValue(doors));
  if (!stood.empty())
    sentence +=
        text(" and the scanner stood %.1f m above the floor", middleValue(stood));
  if (is_home)
    sentence += ", as rooms of homes and offices are in feet";
  else if (unit == Unit::Unknown)
    sentence += ", and nothing that was found tells the unit";
  return sentence +
         ": if the foot is the unit of the scan, scale it by 0.3048 "
         "(--unit 0.3048 in pcl_sedr), else --unit 1 says that it is the metre";
}

} // namespace pcl::sedr
