// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/tilted_faces.h>

#include "../curves/plan_points.h"
#include "patch_normals.h"
#include "sedr_filters/src/base/symmetric_eigen.h"

#include <pcl/sedr_filters/priors.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>

namespace pcl::sedr {

namespace {

constexpr double cube_size = 0.4; // metres

/** @brief Limits of the tilt. Less is construction tolerance, 4 cm in a storey; more is
 * a roof. */
constexpr double min_tilt = radians(1);
constexpr double max_drift = radians(5); ///< of scanners
constexpr double max_tilt = radians(28);

/** @brief Minimum height and area of a face, and maximum start above the floor, metres.
 */
constexpr double min_height = 1.5;
constexpr double min_area = 1.5;
constexpr double max_above_floor = 1;

/** @brief A plane: unit normal . p = offset. */
struct Plane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitX();
  double offset = 0;

  double distance(const Eigen::Vector3d& p) const { return normal.dot(p) - offset; }
};

/** @brief Sums for a least-squares plane through weighted points. */
class PlaneSums {
public:
  void add(const Eigen::Vector3d& p, double weight)
  {
    if (weight_ == 0)
      about_ = p;
    const Eigen::Vector3d d = p - about_;
    weight_ += weight;
    sum_ += weight * d;
    squares_.noalias() += weight * d * d.transpose();
  }

  /** @brief Returns the plane with its normal on the side of `like`. */
  Plane plane(const Eigen::Vector3d& like) const
  {
    const Eigen::Vector3d mean = sum_ / weight_;
    Plane plane;
    plane.normal =
        symmetricEigen(Eigen::Matrix3d(squares_ / weight_ - mean * mean.transpose()))
            .vectors.col(0);
    plane.normal *= plane.normal.dot(like) < 0 ? -1 : 1;
    plane.offset = plane.normal.dot(about_ + mean);
    return plane;
  }

private:
  double weight_ = 0;
  Eigen::Vector3d about_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d sum_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares_ = Eigen::Matrix3d::Zero();
};

/** @brief The patches of walls with a spatial index. */
class WallPatches {
public:
  explicit WallPatches(const std::vector<PlanePatch>& patches)
  {
    for (const PlanePatch& patch : patches)
      if (std::abs(patch.normal.z()) < std::sin(max_tilt + radians(3)))
        patches_.push_back(patch);
    for (std::size_t i = 0; i < patches_.size(); ++i)
      cells_[cellOf(patches_[i].middle)].push_back(i);
    is_used_.assign(patches_.size(), false);
    reached_.assign(patches_.size(), 0);
  }

  /** @brief Returns the patches of each face, grown from the largest patches first. */
  std::vector<std::vector<std::size_t>> faces()
  {
    std::vector<std::size_t> order(patches_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return patches_[a].count > patches_[b].count;
    });
    std::vector<std::vector<std::size_t>> faces;
    for (const std::size_t seed : order) {
      if (is_used_[seed])
        continue;
      std::vector<std::size_t> face = grown(seed);
      for (const std::size_t i : face)
        is_used_[i] = true;
      if (static_cast<double>(face.size()) * cube_size * cube_size >= min_area)
        faces.push_back(std::move(face));
    }
    return faces;
  }

  const PlanePatch& operator[](std::size_t i) const { return patches_[i]; }

  /** @brief Returns the root mean square distance of patches from their plane. */
  double scatterOf(const std::vector<std::size_t>& members) const
  {
    const Plane plane = planeOf(members);
    double squares = 0;
    for (const std::size_t i : members)
      squares += squareOff(plane, patches_[i]);
    return std::sqrt(squares / static_cast<double>(members.size()));
  }

  /** @brief Returns how much more likely patches are on their plane than on the
   * vertical plane through their middle, in nats, at a deviation of `sigma`. */
  double gainOf(const std::vector<std::size_t>& members, double sigma) const
  {
    constexpr double outlier = 4.5; // nats
    const Plane plane = planeOf(members);
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const std::size_t i : members)
      middle += patches_[i].middle / static_cast<double>(members.size());
    Plane vertical;
    vertical.normal << plane.normal.head<2>().normalized(), 0;
    vertical.offset = vertical.normal.dot(middle);
    double gain = 0;
    for (const std::size_t i : members)
      for (const auto& [fit, sign] : {std::pair(vertical, 1), std::pair(plane, -1)})
        gain += sign *
                std::min(outlier, squareOff(fit, patches_[i]) / (2 * sigma * sigma));
    return gain;
  }

  /** @brief Fits the plane of some patches. */
  Plane planeOf(const std::vector<std::size_t>& members) const
  {
    PlaneSums sums;
    for (const std::size_t i : members)
      sums.add(patches_[i].middle, patches_[i].count);
    return sums.plane(patches_[members.front()].normal);
  }

private:
  using Cell = std::array<std::int64_t, 3>;

  /** @brief Returns the mean square distance of the lower and the upper edge of a patch
   * from a plane: walls above each other, each vertical, are no tilted one. */
  static double squareOff(const Plane& plane, const PlanePatch& patch)
  {
    const Eigen::Vector3d half =
        cube_size / 2 *
        (Eigen::Vector3d::UnitZ() - patch.normal.z() * patch.normal).normalized();
    return (std::pow(plane.distance(patch.middle - half), 2) +
            std::pow(plane.distance(patch.middle + half), 2)) /
           2;
  }

  static constexpr double cell_size =
      2 * cube_size; // patches in adjacent cells are connected

  static Cell cellOf(const Eigen::Vector3d& p)
  {
    Cell cell;
    for (int k = 0; k < 3; ++k)
      cell[static_cast<std::size_t>(k)] =
          static_cast<std::int64_t>(std::floor(p[k] / cell_size));
    return cell;
  }

  /** @brief Grows a face from a patch in its plane, which is refitted repeatedly. */
  std::vector<std::size_t> grown(std::size_t seed)
  {
    Plane plane{patches_[seed].normal,
                patches_[seed].normal.dot(patches_[seed].middle)};
    std::vector<std::size_t> face;
    for (const double tolerance : {0.05, 0.04, 0.03}) {
      const std::vector<std::size_t> next = inPlane(seed, plane, tolerance);
      if (next.size() < 4)
        break;
      face = next;
      plane = planeOf(face);
    }
    if (face.empty())
      face.push_back(seed);
    return face;
  }

  std::vector<std::size_t>
  inPlane(std::size_t seed, const Plane& plane, double tolerance)
  {
    constexpr double max_turn = radians(6);
    std::vector<std::size_t> face{seed};
    ++round_;
    reached_[seed] = round_;
    for (std::size_t k = 0; k < face.size(); ++k) {
      const Cell at = cellOf(patches_[face[k]].middle);
      for (std::int64_t n = 0; n < 27; ++n) {
        const auto cell =
            cells_.find({at[0] + n % 3 - 1, at[1] + n / 3 % 3 - 1, at[2] + n / 9 - 1});
        if (cell == cells_.end())
          continue;
        for (const std::size_t i : cell->second)
          if (!is_used_[i] && reached_[i] != round_ &&
              std::abs(patches_[i].normal.dot(plane.normal)) > std::cos(max_turn) &&
              std::abs(plane.distance(patches_[i].middle)) < tolerance) {
            reached_[i] = round_;
            face.push_back(i);
          }
      }
    }
    return face;
  }

  std::vector<PlanePatch> patches_;
  std::map<Cell, std::vector<std::size_t>> cells_;
  std::vector<bool> is_used_;
  std::vector<std::size_t> reached_; ///< round in which each patch was last reached
  std::size_t round_ = 0;
};

double
quantile(std::vector<double> values, double share)
{
  const auto at =
      static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

/** @brief Fits a face to the points around its patches.
 * @return none if it is no wall that begins near the floor */
std::optional<TiltedFace>
faceOf(const WallPatches& patches,
       const std::vector<std::size_t>& members,
       const std::vector<Eigen::Vector3d>& points,
       const PlanPoints& in_plan,
       bool is_tilted)
{
  constexpr double reach = 0.06; // of points from the plane of patches
  constexpr double beside = 0.6; // search distance for the floor
  constexpr double stray = 0.005;
  Eigen::AlignedBox3d box;
  for (const std::size_t i : members)
    box.extend(patches[i].middle);
  Plane plane = patches.planeOf(members);
  // Cubes at its rim have points of other surfaces and are no patches.
  const Eigen::Vector3d border = Eigen::Vector3d::Constant(2 * cube_size);
  box = Eigen::AlignedBox3d(box.min() - border + cube_size * Eigen::Vector3d::UnitZ(),
                            box.max() + border);
  std::vector<Eigen::Vector3d> near;
  std::vector<double> below;
  const Eigen::AlignedBox2d around(
      box.min().head<2>() - Eigen::Vector2d::Constant(beside),
      box.max().head<2>() + Eigen::Vector2d::Constant(beside));
  in_plan.forEachIndexIn(around, [&](std::size_t k) {
    const Eigen::Vector3d& p = points[in_plan.given(k)];
    if (!p.allFinite())
      return;
    if (box.contains(p) && std::abs(plane.distance(p)) < reach)
      near.push_back(p);
    if (around.contains(p.head<2>().eval()) && p.z() < box.min().z() + 2 * cube_size &&
        p.z() > box.min().z() - 2 * max_above_floor)
      below.push_back(p.z());
  });
  for (const double share : {1.0, 0.6}) {
    PlaneSums better;
    for (const Eigen::Vector3d& p : near)
      if (std::abs(plane.distance(p)) < share * reach)
        better.add(p, 1);
    plane = better.plane(plane.normal);
  }
  if (std::abs(plane.normal.z()) > std::sin(max_tilt))
    return {};
  const Eigen::Vector2d left = plane.normal.head<2>().normalized();
  const Eigen::Vector2d way(left.y(), -left.x());
  std::vector<double> along;
  std::vector<double> heights;
  for (const Eigen::Vector3d& p : near)
    if (std::abs(plane.distance(p)) < reach / 2) {
      along.push_back(p.head<2>().dot(way));
      heights.push_back(p.z());
    }
  if (along.size() < 20 || below.empty())
    return {};
  const double low = quantile(heights, stray);
  const double high = quantile(heights, 1 - stray);
  const double floor = quantile(below, stray);
  if (high - low < min_height || low - floor > max_above_floor)
    return {};
  TiltedFace face;
  face.run = is_tilted ? -plane.normal.z() / plane.normal.head<2>().norm() : 0;
  face.low = std::min(low, floor) - 0.1;
  face.head = high + 0.05;
  const double at_head = face.run == 0 ? (low + high) / 2 : face.head;
  const double off =
      (plane.offset - plane.normal.z() * at_head) / plane.normal.head<2>().norm();
  face.start = off * left + quantile(along, stray) * way;
  face.end = off * left + quantile(along, 1 - stray) * way;
  return face;
}

} // namespace

std::vector<TiltedFace>
tiltedFaces(const PointView& points, const std::vector<int>& indices, unsigned threads)
{
  constexpr double min_gain = 10;     // nats: few walls are tilted
  constexpr double min_sigma = 0.003; // of plaster, metres
  constexpr double drift_sigmas = 4;
  WallPatches patches(
      planesOf(points, indices, Eigen::Matrix3d::Identity(), cube_size, threads));
  const std::vector<std::vector<std::size_t>> all = patches.faces();
  std::vector<double> tilts;
  std::vector<double> scatters;
  for (const std::vector<std::size_t>& members : all) {
    tilts.push_back(std::abs(std::asin(patches.planeOf(members).normal.z())));
    scatters.push_back(patches.scatterOf(members));
  }
  if (all.empty())
    return {};
  // A third of the walls at least is vertical: it shows how far these seem to tilt, as
  // the error of mobile scanners drifts. 0.43 deviations hold a third of a normal
  // distribution.
  const double drift =
      std::min(max_drift, drift_sigmas * quantile(tilts, 1.0 / 3) / 0.43);
  const double sigma = std::max(min_sigma, quantile(scatters, 0.5));
  std::vector<TiltedFace> faces;
  std::vector<Eigen::Vector3d> all_points; // used only if some wall may be tilted,
  std::optional<const PlanPoints> in_plan; // and these
  std::vector<std::size_t> others;         // used only if some wall is tilted
  for (std::size_t f = 0; f < all.size(); ++f) {
    const bool may_tilt = tilts[f] > std::max(min_tilt, drift) &&
                          patches.gainOf(all[f], sigma) > min_gain;
    if (may_tilt && !in_plan) {
      std::vector<Eigen::Vector2d> places;
      for (const int i : indices) {
        all_points.push_back(points[static_cast<std::size_t>(i)].cast<double>());
        places.emplace_back(all_points.back().head<2>());
      }
      in_plan.emplace(places, 1);
    }
    const auto face =
        may_tilt ? faceOf(patches, all[f], all_points, *in_plan, true) : std::nullopt;
    if (face)
      faces.push_back(*face);
    else
      others.push_back(f);
  }
  for (const std::size_t f : others)
    if (const auto face = faces.empty()
                              ? std::nullopt
                              : faceOf(patches, all[f], all_points, *in_plan, false))
      faces.push_back(*face);
  return faces;
}

} // namespace pcl::sedr
