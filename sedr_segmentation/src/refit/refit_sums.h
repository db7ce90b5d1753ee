// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "even_share.h"
#include "refit_candidates.h"

#include <pcl/sedr_filters/point_view.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief What the points of a patch say of the surface: their mean distance, and the
 * mean of how that falls with each of its parameters. */
struct PatchSums {
  double count = 0;
  double sum = 0;     ///< of the distances
  double squares = 0; ///< of the distances
  double beyond = 0;  ///< points nearby that are beyond the band of those that count
  Eigen::Vector3d rows = Eigen::Vector3d::Zero();

  void add(double distance, const Eigen::Vector3d& row)
  {
    count += 1;
    sum += distance;
    squares += distance * distance;
    rows += row;
  }

  PatchSums& operator+=(const PatchSums& other);

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

/** @brief How many points of a surface are enough, see RefitParameters. */
struct EnoughPoints {
  std::size_t of_patch;
  std::size_t of_surface;
};

/** @brief The points of a scan that may show a surface, and which: found once, as most
 * of what is to know of that is where they are. */
class Sightings {
public:
  /** @brief Looks at all points, O(n). `raw` and `targets` must outlive this. */
  Sightings(const RawPoints& raw,
            const RefitTargets& targets,
            const EnoughPoints& enough);

  /** @brief Whether no other point may show a surface: no slab has moved far since. */
  bool areAll() const;

  /** @brief Looks again if they are not all. */
  void update();

  /** @brief How the points within `reach` scatter about every surface, and nearer to it
   * than to another that runs along it: by the shortest interval that holds half of
   * them (Rousseeuw 1984), which what is beside a wall hardly moves. */
  std::vector<Scatter> scatters(double reach) const;

  /** @brief Sums of the patches of each surface over the points within the `band` of
   * their surface's `centre`, and how many others are nearer to it than to one that
   * runs along it. The same for any number of threads. */
  std::vector<std::vector<PatchSums>> patchSums(const std::vector<double>& centre,
                                                const std::vector<double>& band) const;

private:
  /** @brief A point of the scan and where it is seen on a surface, see
   * RefitCandidates. With its coordinates: those of the points of a surface
   * are far apart in the scan. */
  struct Sighting {
    Eigen::Vector3f point;
    std::uint32_t place;
  };

  struct Seen {
    Sighting sighting;
    std::uint32_t surface;
  };

  /** @brief What some points that follow one another show: by surface, in their order.
   */
  struct Part {
    Part(const std::vector<Seen>& seen, std::size_t surfaces);

    bool shows(std::size_t t) const { return first[t] < first[t + 1]; }

    std::unique_ptr<Sighting[]> sightings;
    std::vector<std::uint32_t> first; ///< of each surface, and the end
  };

  /** @brief What a block of the scan shows, in the order of the points. */
  using Block = std::vector<Part>;

  /** @brief What a block shows of a surface. */
  struct Share {
    std::size_t surface;
    std::size_t block;
  };

  void find();
  LookedAt enoughOf(const EnoughPoints& enough) const;
  std::vector<Block> lookAt(const RawPoints& raw, const LookedAt& looked_at) const;
  Block lookAt(const RawPoints& raw,
               const RefitCandidates& candidates,
               std::size_t begin,
               std::size_t end) const;

  template <typename Sum, typename SizeOf, typename Add>
  std::vector<std::vector<Sum>> bySurface(SizeOf sizeOf, Add add) const;

  const RawPoints& raw_;
  const RefitTargets& targets_;
  LookedAt looked_at_;
  std::vector<Block> blocks_;
  std::vector<Share> shares_; ///< by surface, then block
  std::vector<PlanSlab> slabs_were_;
};

/** @brief A surface fitted to its patches. */
struct PatchFit {
  Eigen::Vector3d step = Eigen::Vector3d::Zero(); ///< of its parameters
  double count = 0;     ///< points of the patches that show it
  double deviation = 0; ///< standard deviation of these within their patches, metres
  double share = 0;     ///< of the points near it
};

/** @brief Fits the first `parameters` parameters of a surface to its patches.
 *
 * A patch holds many points, so that its mean is known to a fraction of their
 * noise: one that something stands before, or that is not the wall's, lies clearly off
 * and is left out by its biweight (Beaton and Tukey 1974), however much it overlaps the
 * noise of the others. It starts where half of the patches are nearest to each other
 * (Rousseeuw 1984), `is_top` patches counting more.
 * @param noise expected standard deviation of the points, metres: patches of few
 * points say little of it
 * @param beyond points that noise puts beyond the band, as a share of those within:
 * a patch with clearly more of them than this, and than most have, shows more than
 * the surface */
PatchFit fitPatches(const std::vector<PatchSums>& patches,
                    const std::vector<bool>& is_top,
                    Eigen::Index parameters,
                    double noise,
                    double beyond);

} // namespace sedr
} // namespace pcl
