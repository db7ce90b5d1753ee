// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/building.h>

#include "patch_normals.h"
#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/base/smooth_counts.h"
#include <pcl/sedr_filters/priors.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace pcl::sedr {

namespace {

constexpr double patch_size = 0.4; // metres
constexpr double quarter = M_PI / 2;
constexpr double oblique = 0.5;       // radians between the walls and the axes
constexpr double same_surface = 0.02; // standard deviation of what is one, metres
constexpr double agreeing = 0.03;     // likewise of walls in one line

Eigen::Matrix3d
turnBy(double angle)
{
  return Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

/** @brief What is known of the points of a scan, in the level frame. */
struct FramePoints {
  std::vector<double> normals;          ///< directions of walls, radians
  std::vector<Eigen::Vector3d> slabs;   ///< points of level surfaces
  std::vector<Eigen::Vector3d> walls;   ///< all others
  std::vector<Eigen::Vector2d> upright; ///< some of them, in plan
};

/** @brief Removes strays, points a hundred times as far from the middle of all as half
 * of them are: few would make the counts along an axis kilometres long. */
void
dropStrays(const PointView& points, std::vector<int>& indices)
{
  const auto at = [&](int i) { return points[static_cast<std::size_t>(i)]; };
  const auto dropIf = [&](const auto& condition) {
    indices.erase(std::remove_if(indices.begin(), indices.end(), condition),
                  indices.end());
  };
  dropIf([&](int i) { return !points.isFinite(static_cast<std::size_t>(i)); });
  if (indices.empty())
    return;
  const auto valueOf = [&](double share, const auto& value) {
    std::vector<float> values(indices.size());
    std::transform(indices.begin(), indices.end(), values.begin(), value);
    const auto k =
        static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + k, values.end());
    return values[static_cast<std::size_t>(k)];
  };
  Eigen::Vector3f middle;
  for (int axis = 0; axis < 3; ++axis)
    middle[axis] = valueOf(0.5, [&](int i) { return at(i)[axis]; });
  const auto distance = [&](int i) { return (at(i) - middle).norm(); };
  const float farthest = 100 * valueOf(0.5, distance);
  dropIf([&](int i) { return distance(i) > farthest; });
}

FramePoints
framePoints(const PointView& points,
            const std::vector<int>& indices,
            const Eigen::Matrix3d& level,
            unsigned threads)
{
  const double steepest = std::sin(radians(5));
  const auto keyOf = [](const Eigen::Vector3d& p) {
    std::uint64_t key = 0; // of patches below 0 and far away too: modulo 2^64
    for (int axis = 0; axis < 3; ++axis)
      key = key * (1 << 21) + static_cast<std::uint64_t>(static_cast<std::int64_t>(
                                  std::floor(p[axis] / patch_size)));
    return key;
  };
  std::unordered_map<std::uint64_t, Eigen::Vector3d> normals;
  for (const PlanePatch& patch : planesOf(points, indices, level, patch_size, threads))
    normals[keyOf(patch.middle)] = patch.normal;
  FramePoints found;
  for (const int i : indices) {
    const Eigen::Vector3d p =
        level * points[static_cast<std::size_t>(i)].cast<double>();
    const auto patch = normals.find(keyOf(p));
    const bool is_plane = patch != normals.end();
    if (is_plane && std::abs(patch->second.z()) < steepest)
      found.normals.push_back(std::atan2(patch->second.y(), patch->second.x()));
    if (is_plane && patch->second.head<2>().norm() < steepest)
      found.slabs.push_back(p);
    else
      found.walls.push_back(p);
  }
  constexpr std::size_t enough = 200000; // points that tell the walls
  const std::size_t step = found.walls.size() / enough + 1;
  for (std::size_t k = 0; k < found.walls.size(); k += step)
    found.upright.emplace_back(found.walls[k].head<2>());
  return found;
}

/** @brief Returns the coordinates along an axis of what is not level, after a turn. */
std::vector<double>
offsetsAlong(const FramePoints& points, double turn, int axis)
{
  const Eigen::Vector2d direction =
      axis == 0 ? Eigen::Vector2d(std::cos(turn), -std::sin(turn))
                : Eigen::Vector2d(std::sin(turn), std::cos(turn));
  std::vector<double> offsets(points.upright.size());
  for (std::size_t i = 0; i < offsets.size(); ++i)
    offsets[i] = direction.dot(points.upright[i]);
  return offsets;
}

/** @brief Returns how much lies on common lines along the axes after a turn. */
double
agreement(const FramePoints& points, double turn)
{
  double sum = 0;
  for (const int axis : {0, 1}) {
    SmoothCounts counts(offsetsAlong(points, turn, axis), agreeing);
    counts.keepPeaks();
    sum += std::inner_product(counts.counts.begin(), counts.counts.end(),
                              counts.counts.begin(), 0.0);
  }
  return sum;
}

/** @brief Returns the turn after which most wall faces along the axes. */
double
mainTurn(const FramePoints& points, unsigned threads)
{
  std::vector<double> angles; // three quarters, as values near the ends are neighbours
  for (const double normal : points.normals)
    for (int k = 0; k < 3; ++k)
      angles.push_back(std::fmod(normal + 2 * M_PI, quarter) + k * quarter);
  const SmoothCounts counts(angles, radians(1));
  const auto inside = [&](std::size_t k) {
    const double angle = counts.first + counts.bin * static_cast<double>(k);
    return angle >= quarter && angle < 2 * quarter;
  };
  std::size_t best = counts.counts.size();
  for (std::size_t k = 0; k < counts.counts.size(); ++k)
    if (inside(k) &&
        (best == counts.counts.size() || counts.counts[k] > counts.counts[best]))
      best = k;
  double turn = -(counts.first + counts.bin * static_cast<double>(best));
  constexpr int reach = 8; // steps
  for (double step = radians(0.15); step > radians(0.0005); step /= 5) {
    std::vector<double> sums(2 * reach + 1);
    parallelFor(sums.size(), 1, threads, [&](std::size_t k) {
      sums[k] = agreement(points, turn + (static_cast<double>(k) - reach) * step);
    });
    const auto most = std::max_element(sums.begin(), sums.end());
    turn += (static_cast<double>(most - sums.begin()) - reach) * step;
  }
  return turn;
}

/** @brief Returns the squares that hold places, as coordinates in squares: of a surface
 * there are as many however it lies in the voxels of the scan, which those that it lies
 * askew in, or between, give more points. */
std::vector<Eigen::Vector2d>
squaresOf(std::vector<Eigen::Vector2d> places)
{
  for (Eigen::Vector2d& p : places)
    p = (p / (5 * same_surface)).array().floor();
  std::sort(places.begin(), places.end(), [](const auto& a, const auto& b) {
    return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
  });
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

/** @brief Returns the turn by a multiple of 90 degrees after which a building extends
 * most along x, and farther to positive x than to negative x. Both count together, so
 * that one decides where the other is in doubt.
 * @param points with the walls along the axes */
double
canonicalQuarter(const FramePoints& points)
{
  constexpr double farthest = 1.5; // of the usual distance from the middle
  std::vector<Eigen::Vector2d> all;
  for (const auto* part : {&points.walls, &points.slabs})
    for (const Eigen::Vector3d& p : *part)
      all.emplace_back(p.head<2>());
  all = squaresOf(std::move(all));
  const auto size = static_cast<double>(all.size());
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& p : all)
    middle += p / size;
  Eigen::Matrix2d square = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector2d& p : all)
    square += (p - middle) * (p - middle).transpose();
  const double usual = std::sqrt(square.trace() / size);
  Eigen::Vector2d lean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& p : all) {
    const Eigen::Vector2d off = (p - middle) / usual;
    const double far = off.norm();
    lean += off * std::pow(std::min(far, farthest), 3) / std::max(far, 1e-9) / size;
  }
  double best = 0;
  double most = -std::numeric_limits<double>::infinity();
  for (int k = 0; k < 4; ++k) {
    const Eigen::Rotation2Dd to_axes(k * quarter);
    const Eigen::Matrix2d axes = to_axes * square * to_axes.inverse();
    const Eigen::Vector2d leaning = to_axes * lean;
    const double stretch = (axes(0, 0) - axes(1, 1)) / axes.trace();
    if (const double score = stretch + leaning.x() + leaning.y() / 2; score > most) {
      most = score;
      best = k * quarter;
    }
  }
  return best;
}

/** @brief Returns the offset along an axis of the largest surface at a right angle to
 * it, metres.
 * @param preference of the first one to the last, by so much of its size: of two alike
 * it is always the same that counts */
double
largestOf(const std::vector<Eigen::Vector3d>& points, int axis, double preference)
{
  if (points.empty())
    return 0;
  std::vector<double> offsets;
  for (const Eigen::Vector3d& p : points)
    offsets.push_back(p[axis]);
  SmoothCounts peaks(offsets, same_surface);
  peaks.keepPeaks();
  const std::vector<double>& counts = peaks.counts;
  const double enough = *std::max_element(counts.begin(), counts.end()) / 2;
  double most = -1;
  double largest = 0;
  for (std::size_t k = 1; k + 1 < counts.size(); ++k) {
    if (counts[k] < enough || counts[k] < counts[k - 1] || counts[k] < counts[k + 1])
      continue;
    const double offset = peaks.first + peaks.bin * static_cast<double>(k);
    std::vector<Eigen::Vector2d> near;
    for (const Eigen::Vector3d& p : points)
      if (std::abs(p[axis] - offset) < 1.5 * same_surface)
        near.emplace_back(p[(axis + 1) % 3], p[(axis + 2) % 3]);
    const double share = static_cast<double>(k) / static_cast<double>(counts.size());
    if (const double size = static_cast<double>(squaresOf(std::move(near)).size()) *
                            (1 - preference * share);
        size > most) {
      most = size;
      largest = offset;
    }
  }
  for (int round = 0; round < 5; ++round) { // its mean
    double sum = 0;
    double count = 0;
    for (const double offset : offsets)
      if (std::abs(offset - largest) < 1.5 * same_surface) {
        sum += offset;
        ++count;
      }
    largest = sum / std::max(1.0, count);
  }
  return largest;
}

} // namespace

BuildingFrame
findBuildingFrame(const PointView& points,
                  const std::vector<int>& given,
                  unsigned threads,
                  const Eigen::Matrix3d& level,
                  double cell)
{
  std::vector<int> indices = given;
  if (given.empty()) {
    indices.resize(points.size());
    std::iota(indices.begin(), indices.end(), 0);
  }
  dropStrays(points, indices);
  FramePoints found = framePoints(points, indices, level, threads);
  BuildingFrame frame;
  frame.rotation = level;
  if (found.normals.empty())
    return frame;
  double turn = 0;
  const auto turnOn = [&](double angle) {
    turn += angle;
    for (auto* const part : {&found.walls, &found.slabs})
      for (Eigen::Vector3d& p : *part)
        p.head<2>() = Eigen::Rotation2Dd(angle) * Eigen::Vector2d(p.head<2>());
  };
  turnOn(mainTurn(found, threads));
  turnOn(canonicalQuarter(found));
  const Eigen::Matrix3d to_walls = turnBy(turn) * level;
  const Eigen::Vector3d corner(largestOf(found.walls, 0, 0.3),
                               largestOf(found.walls, 1, 0.3),
                               largestOf(found.slabs, 2, 0.8));
  frame.rotation = turnBy(oblique) * to_walls;
  frame.origin = to_walls.transpose() * (corner - Eigen::Vector3d::Constant(cell / 2));
  return frame;
}

} // namespace pcl::sedr
