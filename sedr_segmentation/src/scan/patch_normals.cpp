// SPDX-License-Identifier: BSD-3-Clause
#include "patch_normals.h"

#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/base/plane_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>

namespace pcl::sedr {

namespace {

/** @brief Sums over the points of a patch. */
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

  void add(const PatchMoments& other)
  {
    count += other.count;
    sum += other.sum;
    squares += other.squares;
  }
};

/** @brief Position of a patch, in patches from the origin. */
using PatchKey = std::array<std::int64_t, 3>;

Eigen::Vector3d
cornerOf(const PatchKey& key)
{
  return Eigen::Matrix<std::int64_t, 3, 1>(key.data()).cast<double>();
}

using Patches = std::map<PatchKey, PatchMoments>;

/** @brief Sums the rotated points indices[begin, end) per patch, relative to its
 * corner, as squares of large coordinates lose precision. */
Patches
patchesOf(const PointView& points,
          const std::vector<int>& indices,
          std::size_t begin,
          std::size_t end,
          const Eigen::Matrix3d& turn,
          double patch,
          double offset)
{
  Patches patches;
  auto last = patches.end(); // the next point is mostly in the same patch
  for (std::size_t n = begin; n < end; ++n) {
    const Eigen::Vector3d p =
        turn * points[static_cast<std::size_t>(indices[n])].cast<double>() +
        Eigen::Vector3d::Constant(offset * patch);
    if (!p.allFinite() || p.cwiseAbs().maxCoeff() >= farthest_place)
      continue;
    const auto alongAxis = [&](double v) { // floor without a function call
      const auto whole = static_cast<std::int64_t>(v / patch);
      return whole - (v / patch < static_cast<double>(whole) ? 1 : 0);
    };
    const PatchKey key{alongAxis(p.x()), alongAxis(p.y()), alongAxis(p.z())};
    if (last == patches.end() || last->first != key)
      last = patches.try_emplace(key).first;
    last->second.add(p - patch * cornerOf(key));
  }
  return patches;
}

/** @brief Returns the plane of a patch if its points lie on one.
 * @param corner origin of its sums */
std::optional<PlanePatch>
planeOf(const PatchMoments& patch, const Eigen::Vector3d& corner, double max_scatter)
{
  constexpr double fewest = 20;
  constexpr double min_spread = 0.08; // within the plane, metres
  if (patch.count < fewest)
    return {};
  const Eigen::Vector3d mean = patch.sum / patch.count;
  const SymmetricEigen<3> eigen = symmetricEigen(
      Eigen::Matrix3d(patch.squares / patch.count - mean * mean.transpose()));
  if (eigen.values[0] > max_scatter * max_scatter ||
      eigen.values[1] < min_spread * min_spread)
    return {};
  const Eigen::Vector3d normal = eigen.vectors.col(0);
  return PlanePatch{mean + corner, normal.z() < 0 ? Eigen::Vector3d(-normal) : normal,
                    patch.count, std::sqrt(std::max(eigen.values[0], 0.0))};
}

} // namespace

std::vector<PlanePatch>
planesOf(const PointView& points,
         const std::vector<int>& indices,
         const Eigen::Matrix3d& turn,
         double patch,
         unsigned threads,
         double offset,
         double max_scatter)
{
  constexpr std::size_t block = std::size_t{1} << 15;
  constexpr std::size_t patches_a_block = 512;
  std::vector<Patches> parts(indices.size() / block + 1);
  parallelBlocks(indices.size(), block, threads,
                 [&](std::size_t begin, std::size_t end) {
                   parts[begin / block] =
                       patchesOf(points, indices, begin, end, turn, patch, offset);
                 });
  Patches patches;
  for (const Patches& part : parts)
    for (const auto& [key, moments] : part)
      patches[key].add(moments);
  std::vector<const Patches::value_type*> moments;
  for (const auto& entry : patches)
    moments.push_back(&entry);
  const Eigen::Vector3d shift = Eigen::Vector3d::Constant(offset * patch);
  std::vector<std::optional<PlanePatch>> plane_of(moments.size());
  parallelFor(moments.size(), patches_a_block, threads, [&](std::size_t k) {
    plane_of[k] = planeOf(moments[k]->second,
                          patch * cornerOf(moments[k]->first) - shift, max_scatter);
  });
  std::vector<PlanePatch> planes;
  for (const auto& plane : plane_of)
    if (plane)
      planes.push_back(*plane);
  return planes;
}

} // namespace pcl::sedr
