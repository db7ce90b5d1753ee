// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/scan_lean.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>

namespace pcl {
namespace sedr {

namespace {

/** @brief Edge of a patch, metres. */
constexpr double patch_size = 0.5;

/** @brief Directions that are nearer to each other agree, radians. */
constexpr double agreement = 0.026;

/** @brief The points of a patch: their sums. */
struct PatchMoments {
  double count = 0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();

  void add(const Eigen::Vector3d& p)
  {
    count += 1;
    sum += p;
    squares.noalias() += p * p.transpose();
  }
};

/** @brief The normals of the patches that are planes, z not below 0. */
std::vector<Eigen::Vector3d>
normalsOf(const PointView& points, const std::vector<int>& indices)
{
  constexpr double fewest = 20;
  constexpr double most_scatter = 0.02; // across a plane, metres
  constexpr double least_spread = 0.08; // along it
  constexpr double farthest = 1e5;
  std::map<std::array<std::int64_t, 3>, PatchMoments> patches;
  for (const int i : indices) {
    const Eigen::Vector3d p = points[static_cast<std::size_t>(i)].cast<double>();
    if (!p.allFinite() || p.cwiseAbs().maxCoeff() > farthest)
      continue;
    std::array<std::int64_t, 3> key{};
    for (std::size_t k = 0; k < 3; ++k)
      key[k] = static_cast<std::int64_t>(
          std::floor(p[static_cast<Eigen::Index>(k)] / patch_size));
    // About the patch's corner: squares of large coordinates leave no digits.
    patches[key].add(p - patch_size * Eigen::Vector3d(static_cast<double>(key[0]),
                                                      static_cast<double>(key[1]),
                                                      static_cast<double>(key[2])));
  }
  std::vector<Eigen::Vector3d> normals;
  for (const auto& [key, m] : patches) {
    if (m.count < fewest)
      continue;
    const Eigen::Vector3d mean = m.sum / m.count;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
        m.squares / m.count - mean * mean.transpose());
    if (solver.eigenvalues()[0] > most_scatter * most_scatter ||
        solver.eigenvalues()[1] < least_spread * least_spread)
      continue;
    const Eigen::Vector3d normal = solver.eigenvectors().col(0);
    normals.push_back(normal.z() < 0 ? Eigen::Vector3d(-normal) : normal);
  }
  return normals;
}

/** @brief How many normals stand along a direction, and how many across it. */
struct Votes {
  double along = 0;
  double across = 0;
};

Votes
votesFor(const Eigen::Vector3d& direction, const std::vector<Eigen::Vector3d>& normals)
{
  Votes votes;
  for (const auto& n : normals) {
    const double cosine = std::abs(n.dot(direction));
    votes.along += cosine > std::cos(agreement) ? 1 : 0;
    votes.across += cosine < std::sin(agreement) ? 1 : 0;
  }
  return votes;
}

/** @brief The direction, more upright than level, along which most normals stand. */
Eigen::Vector3d
commonUp(const std::vector<Eigen::Vector3d>& normals)
{
  constexpr std::size_t most_tried = 400;
  constexpr double least_cosine = 0.7071;
  std::vector<Eigen::Vector3d> level;
  for (const auto& n : normals)
    if (n.z() > least_cosine)
      level.push_back(n);
  Eigen::Vector3d best = Eigen::Vector3d::UnitZ();
  double most = 0;
  const std::size_t step = level.size() / most_tried + 1;
  for (std::size_t k = 0; k < level.size(); k += step)
    if (const double along = votesFor(level[k], level).along; along > most) {
      most = along;
      best = level[k];
    }
  for (int round = 0; round < 3; ++round) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const auto& n : level)
      if (n.dot(best) > std::cos(agreement))
        sum += n;
    if (sum.norm() > 0)
      best = sum.normalized();
  }
  return best;
}

} // namespace

ScanLean
leanOf(const PointView& points, const std::vector<int>& indices)
{
  constexpr double least_area = 4; // square metres
  constexpr double times_more_level = 3;
  constexpr double times_more_upright = 1.5;
  const std::vector<Eigen::Vector3d> normals = normalsOf(points, indices);
  ScanLean lean;
  const Eigen::Vector3d up = commonUp(normals);
  const double angle = std::acos(std::min(1.0, up.z()));
  if (angle < 2 * agreement)
    return lean; // what agrees with it agrees with z
  const Votes of_up = votesFor(up, normals);
  const Votes of_z = votesFor(Eigen::Vector3d::UnitZ(), normals);
  const double area = of_up.along * patch_size * patch_size;
  if (area < least_area || of_up.along < times_more_level * of_z.along ||
      of_up.across < times_more_upright * of_z.across)
    return lean;
  lean.up = up;
  lean.angle = angle;
  lean.area = area;
  return lean;
}

std::string
leanProblem(const PointView& points, const std::vector<int>& indices)
{
  const ScanLean lean = leanOf(points, indices);
  if (!(lean.angle > 0))
    return {};
  const Eigen::Vector3d axis = lean.up.cross(Eigen::Vector3d::UnitZ()).normalized();
  std::array<char, 400> text{};
  std::snprintf(
      text.data(), text.size(),
      "the scan leans: its floors and ceilings, %.0f square metres of planes, "
      "stand at %.1f degrees to z, and its walls with them; turn it, for "
      "instance by pcl_transform_point_cloud IN OUT -axisangle "
      "%.4f,%.4f,0,%.4f",
      lean.area, lean.angle * 180 / M_PI, axis.x(), axis.y(), lean.angle);
  return text.data();
}

} // namespace sedr
} // namespace pcl
