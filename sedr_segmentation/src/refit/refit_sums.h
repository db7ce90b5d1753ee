// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refit_targets.h"

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Sums over the points of a patch: distances from the surface, and their
 * negative derivatives by its parameters. */
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

/** @brief Mode and scatter of the points near a surface. */
struct Scatter {
  double count = 0;
  double centre = 0;    ///< distance from the surface, metres
  double deviation = 0; ///< standard deviation around the centre, metres
};

/** @brief The points of a scan in use. */
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

/** @brief The points of a scan sorted by surface. Computed once, as the assignment
 * hardly changes while surfaces move by millimetres. */
class Sightings {
public:
  /** @brief Assigns all points, O(n). `targets` must outlive this object. */
  Sightings(const RawPoints& raw, const RefitTargets& targets, const Priors& priors);

  /** @brief Returns the scatter of the points within `reach` of each surface, up to
   * midway to an adjacent parallel surface. It is the shortest interval with half of
   * them (Rousseeuw 1984), hardly affected by objects at a wall. */
  std::vector<Scatter> scatters(double reach) const;

  /** @brief Returns the patch sums of each surface over the points within its `band`
   * around its `centre`. The result does not depend on the number of threads. */
  std::vector<std::vector<PatchSums>> patchSums(const std::vector<double>& centre,
                                                const std::vector<double>& band) const;

private:
  /** @brief A point and the constant part of its patch number: the row of a vertical
   * surface, the patch of a slab. */
  struct Sighting {
    Eigen::Vector3f point;
    std::uint32_t place;
  };

  using BySurface = std::vector<std::vector<Sighting>>;

  BySurface lookAt(const RawPoints& raw, std::size_t begin, std::size_t end) const;

  /** @brief Leaves out points of what stands square to a vertical surface. */
  void dropSquareSurfaces(std::size_t curve, const Priors& priors);

  template <typename See>
  void forEach(std::size_t surface, See see) const;

  const RefitTargets& targets_;
  unsigned threads_;
  std::vector<BySurface> blocks_; ///< blocks of the scan in point order
};

/** @brief Result of the fit of a surface to its patches. */
struct PatchFit {
  Eigen::Vector3d step = Eigen::Vector3d::Zero(); ///< change of its parameters
  double count = 0;     ///< number of points of its inlier patches
  double deviation = 0; ///< standard deviation within the patches, metres
};

/** @brief Fits the first `parameters` parameters of a surface to its patches.
 *
 * The mean of a patch is accurate to a fraction of the noise. Patches of other objects
 * deviate clearly and are excluded by the biweight (Beaton and Tukey 1974), as are
 * patches with a large scatter. The fit starts at the shortest half of the patch means
 * (Rousseeuw 1984); `is_top` patches have more weight.
 * @param noise expected standard deviation of the points, metres */
PatchFit fitPatches(const std::vector<PatchSums>& patches,
                    const std::vector<bool>& is_top,
                    Eigen::Index parameters,
                    double noise);

} // namespace pcl::sedr
