// SPDX-License-Identifier: BSD-3-Clause
#include "square_surfaces.h"

#include <pcl/sedr_filters/cell_grid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <unordered_map>

namespace pcl::sedr {

namespace {

/** @brief Points of a strip of a face: on it, and on both sides in three depths. */
struct DepthCounts {
  double on = 0;
  std::array<std::array<double, 3>, 2> beside{};

  void add(double off, const Priors& priors)
  {
    const double depth =
        (std::abs(off) - priors.wall_band) / (priors.surface_band - priors.wall_band);
    auto& side = beside[off < 0 ? 0 : 1];
    if (depth < 0)
      ++on;
    else if (depth < 1)
      ++side[static_cast<std::size_t>(depth * static_cast<double>(side.size()))];
  }

  /** @brief Whether there are points at every depth, not a few beside those on the face
   * and its band, which is as wide as six depths. */
  bool hasAllDepths(const Priors& priors) const
  {
    const double few = std::max(priors.min_evidence, priors.share_unseen * on / 6);
    return std::any_of(beside.begin(), beside.end(), [&](const auto& side) {
      return *std::min_element(side.begin(), side.end()) >= few;
    });
  }
};

} // namespace

std::vector<std::uint8_t>
areOnSquareSurfaces(const std::vector<FacePlace>& places, const Priors& priors)
{
  // As narrow as the noise of a surface, as wide as needed to see enough of it.
  const double wide = priors.patch;
  const double narrow = priors.evidence_cell / 5;
  std::vector<std::uint8_t> are_on(places.size(), 0);
  for (const Eigen::Vector2d& strip :
       {Eigen::Vector2d(wide, narrow), Eigen::Vector2d(narrow, wide)}) {
    const auto keyAt = [&](const FacePlace& p) {
      return keyOf({static_cast<std::int32_t>(std::floor(p.x() / strip.x())),
                    static_cast<std::int32_t>(std::floor(p.y() / strip.y()))});
    };
    std::unordered_map<CellKey, DepthCounts> counts;
    for (const FacePlace& p : places)
      counts[keyAt(p)].add(p.z(), priors);
    for (std::size_t i = 0; i < places.size(); ++i)
      if (counts[keyAt(places[i])].hasAllDepths(priors))
        are_on[i] = 1;
  }
  return are_on;
}

} // namespace pcl::sedr
