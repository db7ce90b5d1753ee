// SPDX-License-Identifier: BSD-3-Clause
#include "surface_planes.h"

#include <algorithm>

namespace pcl::sedr {

void
SurfacePlanes::load(const BandGrid& grid, std::size_t b, const SortedSamples& samples)
{
  for (auto* list : {&x_, &y_, &z_, &nx_, &ny_, &nz_})
    list->clear();
  const BandGrid::Block block = grid.at(b);
  for (int n = 0; n < 27; ++n) {
    const int step[3] = {n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
    const std::size_t s =
        samples.grid.find({block[0] + step[0], block[1] + step[1], block[2] + step[2]});
    if (s == samples.grid.size())
      continue;
    for (std::size_t i = samples.starts[s]; i < samples.starts[s + 1]; ++i) {
      const BlockSample& sample = samples.samples[i];
      float place[3];
      bool inside = true;
      for (int k = 0; k < 3; ++k) {
        place[k] = sample.place[k] + static_cast<float>(8 * step[k]);
        inside = inside && place[k] > -radius_ && place[k] < 8 + radius_;
      }
      if (!inside)
        continue;
      x_.push_back(place[0]);
      y_.push_back(place[1]);
      z_.push_back(place[2]);
      nx_.push_back(sample.normal[0] / sample.area);
      ny_.push_back(sample.normal[1] / sample.area);
      nz_.push_back(sample.normal[2] / sample.area);
    }
  }
  distance2_.resize(x_.size());
}

bool
SurfacePlanes::find(const Eigen::Vector3f& place,
                    const Eigen::Vector3f& slope,
                    SurfacePlane& plane)
{
  constexpr float agree = 0.9f;      // cosine of 25 degrees
  constexpr float min_share = 0.15f; // of the weight; below it, an outlier
  const std::size_t n = x_.size();
  for (std::size_t i = 0; i < n; ++i) {
    const float dx = x_[i] - place[0];
    const float dy = y_[i] - place[1];
    const float dz = z_[i] - place[2];
    distance2_[i] = dx * dx + dy * dy + dz * dz;
  }
  near_.clear();
  float all = 0;
  const float radius2 = radius_ * radius_;
  for (std::size_t i = 0; i < n; ++i) {
    if (distance2_[i] >= radius2 || normalOf(i).dot(slope) <= 0)
      continue;
    const float closeness = 1 - distance2_[i] / radius2;
    near_.push_back({i, distance2_[i], closeness * closeness});
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
      const Eigen::Vector3f from(place[0] - x_[other.index], place[1] - y_[other.index],
                                 place[2] - z_[other.index]);
      height += other.weight * 0.5f * (normal + plane.normal).dot(from);
    }
    plane.point = place - height / weight * plane.normal;
    return true;
  }
  return false;
}

} // namespace pcl::sedr
