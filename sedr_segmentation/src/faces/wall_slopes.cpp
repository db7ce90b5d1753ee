// SPDX-License-Identifier: BSD-3-Clause
#include "wall_slopes.h"

#include "../curves/plan_points.h"
#include <pcl/sedr_filters/priors.h>

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

constexpr double in_plane = 0.05; // distance within which a point is on a patch, metres

} // namespace

Eigen::Vector2d
runOf(const Eigen::Vector3d& normal)
{
  return -normal.z() / normal.head<2>().squaredNorm() * normal.head<2>();
}

WallSlopes::WallSlopes(const PointView& points,
                       const std::vector<int>& indices,
                       unsigned threads)
{
  constexpr double max_tilt = radians(30);
  constexpr double max_turn = radians(6);       // of patches of one face
  constexpr std::size_t min_around = 9;         // 1.5 m2: furniture is smaller
  constexpr double min_rise = 1.5 * patch_size; // of three rows: two may be a step
  std::vector<PlanePatch> found;
  std::vector<Eigen::Vector2d> places;
  for (const PlanePatch& patch :
       planesOf(points, indices, Eigen::Matrix3d::Identity(), patch_size, threads))
    if (std::abs(patch.normal.z()) < std::sin(max_tilt)) {
      found.push_back(patch);
      places.emplace_back(patch.middle.head<2>());
    }
  const PlanPoints in_plan(places, 2 * patch_size);
  patches_ = found;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const PlanePatch& own = found[i];
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    std::size_t around = 0;
    double low = own.middle.z();
    double high = low;
    in_plan.forEachIndexWithin(places[i], 2.5 * patch_size, [&](std::size_t k) {
      const PlanePatch& other = found[in_plan.given(k)];
      const Eigen::Vector3d way = other.middle - own.middle;
      const double cosine = other.normal.dot(own.normal);
      if (way.norm() > 2.5 * patch_size || std::abs(way.dot(own.normal)) > in_plane ||
          std::abs(cosine) < std::cos(max_turn))
        return;
      sum += (cosine < 0 ? -other.count : other.count) * other.normal;
      ++around;
      low = std::min(low, other.middle.z());
      high = std::max(high, other.middle.z());
    });
    patches_[i].normal = sum.normalized();
    if (around < min_around || high - low < min_rise ||
        runOf(patches_[i].normal).norm() <= vertical_run)
      continue;
    const Eigen::Vector2d reach = Eigen::Vector2d::Constant(1.5 * patch_size);
    near_.addIn({places[i] - reach, places[i] + reach},
                static_cast<std::uint32_t>(leaning_.size()));
    leaning_.push_back(i);
  }
  near_.finish();
}

Eigen::Vector2d
WallSlopes::at(const Eigen::Vector3d& p) const
{
  Eigen::Vector2d run = Eigen::Vector2d::Zero();
  if (areNone() || !p.allFinite())
    return run;
  double nearest = 1.5 * patch_size;
  for (const std::uint32_t k : near_.at(p.head<2>())) {
    const PlanePatch& patch = patches_[leaning_[k]];
    const Eigen::Vector3d way = p - patch.middle;
    if (way.norm() >= nearest || std::abs(way.dot(patch.normal)) > in_plane)
      continue;
    nearest = way.norm();
    run = runOf(patch.normal);
    run *= 1 - vertical_run * vertical_run / run.squaredNorm();
  }
  return run;
}

} // namespace pcl::sedr
