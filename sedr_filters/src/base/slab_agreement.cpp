// SPDX-License-Identifier: BSD-3-Clause
#include "slab_agreement.h"

#include "parallel.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Four numbers, one for each of four slabs. */
using Four = Eigen::Array4d;

/** @brief Four slabs side by side: each sum depends on its previous term, so four
 * independent sums are faster than one. */
struct FourSlabs {
  Four a;
  Four b;
  Four c;
  Four d;

  explicit FourSlabs(const std::array<const PlanSlab*, 4>& slabs)
  {
    for (Eigen::Index k = 0; k < 4; ++k) {
      const Eigen::Vector4d& plane = slabs[static_cast<std::size_t>(k)]->plane;
      a[k] = plane[0];
      b[k] = plane[1];
      c[k] = plane[2];
      d[k] = plane[3];
    }
  }

  /** @brief Returns distanceAbove() for each slab, adding in the same order. */
  Four distancesAbove(const Eigen::Vector3f& p) const
  {
    const Eigen::Vector3d q = p.cast<double>();
    return a * q.x() + (b * q.y() + c * q.z()) + d;
  }
};

/** @brief Scores the agreement of the points with each of four slabs. Stops early, with
 * lower scores, if none of them can exceed `least`: then most points are not read. */
Four
agreement(const Positions& points,
          const FourSlabs& slabs,
          double tolerance,
          double least)
{
  constexpr std::size_t stretch = 64;
  constexpr double rounding = 1e-6; // bound of the rounding error of the sum
  Four sum = Four::Zero();
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Four d = slabs.distancesAbove(points[k]) / tolerance;
    sum += (1 - d * d).max(0);
    if (k % stretch == 0 &&
        sum.maxCoeff() + static_cast<double>(points.size() - k) + rounding < least)
      return sum;
  }
  return sum;
}

} // namespace

PlanSlab
mostAgreed(const std::vector<PlanSlab>& slabs,
           const PlanSlab& start,
           const Positions& points,
           double tolerance,
           unsigned threads)
{
  constexpr std::size_t at_once = 4;
  constexpr std::size_t block = 6 * at_once;
  using Choice = std::pair<double, const PlanSlab*>; // score and slab
  const FourSlabs start_alone({&start, &start, &start, &start});
  const Choice least{agreement(points, start_alone, tolerance, 0)[0], &start};
  std::vector<Choice> choices((slabs.size() + block - 1) / block, least);
  parallelBlocks(slabs.size(), block, threads, [&](std::size_t begin, std::size_t end) {
    Choice& best = choices[begin / block];
    for (std::size_t k = begin; k < end; k += at_once) {
      std::array<const PlanSlab*, at_once> four{};
      for (std::size_t s = 0; s < at_once; ++s)
        four[s] = &slabs[std::min(k + s, end - 1)];
      const Four scores = agreement(points, FourSlabs(four), tolerance, best.first);
      for (std::size_t s = 0; s < at_once; ++s)
        if (const double score = scores[static_cast<Eigen::Index>(s)];
            score > best.first)
          best = {score, four[s]};
    }
  });
  Choice best = least;
  for (const Choice& choice : choices)
    if (choice.first > best.first)
      best = choice;
  return *best.second;
}

} // namespace pcl::sedr
