// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../solver/surface_samples.h"

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief A tangent plane of the surface. */
struct SurfacePlane {
  Eigen::Vector3f point;
  Eigen::Vector3f normal;
};

/** @brief The samples in and around one block of the finest grid, for queries of
 * tangent planes. Lengths in cells, from the block's first node. */
class SurfacePlanes {
public:
  /** @brief Samples further than `radius`, at most 8 cells, do not contribute to a
   * plane. */
  explicit SurfacePlanes(float radius)
      : radius_(std::min(radius, 8.f))
  {}

  /** @brief Loads the samples around block `b`. */
  void load(const BandGrid& grid, std::size_t b, const SortedSamples& samples)
  {
    around_.clear();
    samples.gather(grid.at(b), radius_, around_);
    places_.resize(static_cast<Eigen::Index>(around_.size()), 3);
    for (std::size_t i = 0; i < around_.size(); ++i)
      places_.row(static_cast<Eigen::Index>(i)) =
          Eigen::Map<const Eigen::RowVector3f>(around_[i].place);
  }

  /** @brief Fits a plane to samples around `place` on the side of `slope` whose normals
   * agree with that of the nearest one. Near an edge, the plane is that of one of its
   * sides. Follows curved surfaces.
   * @return false if there are no samples */
  bool
  find(const Eigen::Vector3f& place, const Eigen::Vector3f& slope, SurfacePlane& plane)
  {
    constexpr float agree = 0.9f;      // cosine of 25 degrees
    constexpr float min_share = 0.15f; // of the weight; below it, an outlier
    distance2_ = (places_.col(0) - place[0]).square() +
                 (places_.col(1) - place[1]).square() +
                 (places_.col(2) - place[2]).square();
    near_.clear();
    float all = 0;
    const float radius2 = radius_ * radius_;
    for (std::size_t i = 0; i < around_.size(); ++i) {
      const float distance2 = distance2_[static_cast<Eigen::Index>(i)];
      if (distance2 >= radius2 || normalOf(i).dot(slope) <= 0)
        continue;
      const float closeness = 1 - distance2 / radius2;
      near_.push_back({i, distance2, closeness * closeness});
      all += closeness * closeness;
    }
    std::sort(near_.begin(), near_.end(), [](const Near& a, const Near& b) {
      return a.distance2 != b.distance2 ? a.distance2 < b.distance2 : a.index < b.index;
    });
    for (const Near& seed : near_) {
      const Eigen::Vector3f direction = normalOf(seed.index);
      Eigen::Vector3f sum = Eigen::Vector3f::Zero();
      float weight = 0;
      for (const Near& other : near_)
        if (normalOf(other.index).dot(direction) > agree) {
          sum += other.weight * normalOf(other.index);
          weight += other.weight;
        }
      if (weight < min_share * all)
        continue;
      plane.normal = sum.normalized();
      // The mean of own and mean normal is exact on planes and on round surfaces.
      float height = 0;
      for (const Near& other : near_) {
        const Eigen::Vector3f normal = normalOf(other.index);
        if (normal.dot(direction) <= agree)
          continue;
        const Eigen::Vector3f from =
            place - Eigen::Map<const Eigen::Vector3f>(around_[other.index].place);
        height += other.weight * 0.5f * (normal + plane.normal).dot(from);
      }
      plane.point = place - height / weight * plane.normal;
      return true;
    }
    return false;
  }

private:
  struct Near {
    std::size_t index;
    float distance2;
    float weight;
  };

  Eigen::Map<const Eigen::Vector3f> normalOf(std::size_t i) const
  {
    return Eigen::Map<const Eigen::Vector3f>(around_[i].normal);
  }

  float radius_;
  std::vector<BlockSample> around_; ///< with unit normals
  Eigen::ArrayX3f places_;          ///< of these samples, by axis
  Eigen::ArrayXf distance2_;
  std::vector<Near> near_;
};

} // namespace pcl::sedr
