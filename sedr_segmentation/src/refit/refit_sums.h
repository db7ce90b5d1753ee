// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refit_targets.h"

#include <pcl/sedr_filters/point_view.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Sums over the points of a patch: their distances from the surface, and how
 * the distance falls with each parameter of the surface. */
struct PatchSums {
  double count = 0;
  double sum = 0;     ///< of the distances
  double squares = 0; ///< of the distances
  Eigen::Vector3d rows = Eigen::Vector3d::Zero();

  void add(double distance, const Eigen::Vector3d& row)
  {
    count += 1;
    sum += distance;
    squares += distance * distance;
    rows += row;
  }

  double mean() const { return count > 0 ? sum / count : 0; }
};

/** @brief Where most of the points near a surface are, and how far they scatter. */
struct Scatter {
  double count = 0;
  double centre = 0;    ///< distance from the surface, metres
  double deviation = 0; ///< standard deviation about it, metres
};

/** @brief The points of a scan that are looked at. */
struct RawPoints {
  PointView points;
  const std::vector<int>* indices = nullptr; ///< null: all
  std::size_t step = 1;                      ///< every k-th of them
  unsigned threads = 0;

  std::size_t size() const
  {
    return ((indices ? indices->size() : points.size()) + step - 1) / step;
  }

  std::size_t at(std::size_t k) const
  {
    return indices ? static_cast<std::size_t>((*indices)[k * step]) : k * step;
  }
};

/** @brief The points of a scan by the surface that they may show. Found once, since
 * that hardly changes while the surfaces move by millimetres. */
class Sightings {
public:
  /** @brief Looks at all points, O(n). `targets` must outlive this. */
  Sightings(const RawPoints& raw, const RefitTargets& targets);

  /** @brief How the points within `reach` scatter about each surface, on this side of
   * the middle between it and another that runs along it: by the shortest interval that
   * holds half of them (Rousseeuw 1984), which objects beside a wall hardly move. */
  std::vector<Scatter> scatters(double reach) const;

  /** @brief Sums over the patches of each surface of the points within its `band` about
   * its `centre`. The same for any number of threads. */
  std::vector<std::vector<PatchSums>> patchSums(const std::vector<double>& centre,
                                                const std::vector<double>& band) const;

private:
  /** @brief A point and the part of its patch number that does not change: the row of
   * patches of an upright, the patch of a slab. */
  struct Sighting {
    Eigen::Vector3f point;
    std::uint32_t place;
  };

  using BySurface = std::vector<std::vector<Sighting>>;

  BySurface lookAt(const RawPoints& raw, std::size_t begin, std::size_t end) const;

  template <typename See>
  void forEach(std::size_t surface, See see) const;

  const RefitTargets& targets_;
  unsigned threads_;
  std::vector<BySurface> blocks_; ///< of the scan, in the order of its points
};

/** @brief A surface fitted to its patches. */
struct PatchFit {
  Eigen::Vector3d step = Eigen::Vector3d::Zero(); ///< of its parameters
  double count = 0;     ///< points of the patches that show it
  double deviation = 0; ///< standard deviation of these within their patches, metres
};

/** @brief Fits the first `parameters` parameters of a surface to its patches.
 *
 * The mean of a patch is known to a fraction of the noise. A patch that shows something
 * else lies clearly off and is left out by its biweight (Beaton and Tukey 1974), as is
 * one that scatters more than most. The fit starts where half of the patches are
 * nearest to each other (Rousseeuw 1984); `is_top` patches count more.
 * @param noise expected standard deviation of the points, metres */
PatchFit fitPatches(const std::vector<PatchSums>& patches,
                    const std::vector<bool>& is_top,
                    Eigen::Index parameters,
                    double noise);

} // namespace sedr
} // namespace pcl
