// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refit_places.h"
#include "refit_views.h"

#include "../curves/plan_curves.h"
#include "sedr_filters/src/plan/plan_surfaces.h"

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief The surfaces of a plan, by place: which of them a point of the scan may show.
 *
 * Numbered are first the curves of the plan, then its slabs. Each is divided into
 * patches: a tenth of a metre of an upright, less of a short one, a quarter of a slab.
 * Each has up to three parameters: a line its shift to the left and its turn about the
 * pivot, a circle its centre and radius, a slab its rise and its slopes about the
 * middle of its room; one that is parallel to another only its rise. */
class RefitTargets {
public:
  /** @brief `plan` must stay where it is; moved curves and slabs are seen.
   * @pre none of its loops is empty */
  RefitTargets(Floorplan& plan,
               const PlanCurves& curves,
               double reach,
               unsigned threads);

  /** @brief Why there is nothing to look up, a sentence; empty otherwise. */
  const std::string& problem() const { return problem_; }

  std::size_t size() const { return curves_.curves.size() + places_.slabs.size(); }

  /** @brief Points farther from a surface are not its own, metres. */
  double reach() const { return reach_; }

  std::size_t slabCount() const { return places_.slabs.size(); }
  PlanSlab& slab(std::size_t k) const { return *places_.slabs[k].slab; }
  const Eigen::Vector2d& middle(std::size_t k) const { return places_.slabs[k].middle; }

  /** @brief The slab whose direction slab `k` has; `k` itself where it has its own. */
  std::size_t parent(std::size_t k) const { return places_.slabs[k].parent; }

  /** @brief Width of a slab where it is narrowest, metres. */
  double widthOfSlab(std::size_t k) const { return places_.slabs[k].width; }

  /** @brief Length of the shown part of a curve that is looked at, metres. */
  double lengthOf(std::size_t curve) const { return length_[curve]; }

  /** @brief Distance to the nearest other upright that runs along a surface, such as
   * the other face of a partition, metres; infinite where none is near. */
  double gap(std::size_t number) const
  {
    return number < gap_.size() ? gap_[number]
                                : std::numeric_limits<double>::infinity();
  }

  /** @brief Number of the patches of a surface. */
  std::size_t patchCount(std::size_t number) const { return patch_count_[number]; }

  /** @brief Whether a patch, from the first of its surface, is at the top of a wall,
   * where least stands before it. */
  bool isTop(std::size_t number, std::size_t patch) const
  {
    constexpr std::size_t rows = 3;
    return number < curves_.curves.size() && patch < rows * along_[number];
  }

  /** @brief Where the surfaces are, and their slabs. */
  const RefitPlaces& places() const { return places_; }

  /** @brief The row of patches at a height of an upright whose highest is `top`, from
   * there down. */
  static std::size_t rowOf(double top, double z)
  {
    return static_cast<std::size_t>((top - z) / upright_patch);
  }

  /** @brief The patch of a slab at a place, from its first. */
  static std::size_t patchOf(const RefitSlab& slab, const Eigen::Vector2d& p)
  {
    const Eigen::Vector2d at =
        ((p - slab.middle + slab.half) / slab_patch).cwiseMax(0.0);
    const auto x = std::min(slab.along - 1, static_cast<std::size_t>(at.x()));
    const auto y = std::min(slab.rows - 1, static_cast<std::size_t>(at.y()));
    return y * slab.along + x;
  }

  /** @brief Calls `see(view)` by the kind of a surface: a LineView, CircleView or
   * SlabView. */
  template <typename See>
  void view(std::size_t number, See see) const
  {
    if (number >= curves_.curves.size()) {
      const RefitSlab& slab = places_.slabs[number - curves_.curves.size()];
      see(SlabView{*slab.slab, slab.middle});
      return;
    }
    const PatchColumns columns{patch_[number], along_[number]};
    const MeasuredCurve& m = curves_.curves[number];
    if (m.curve.isCircle())
      see(CircleView{m.curve, columns});
    else
      see(LineView{m, curves_.reach(number), columns});
  }

private:
  /** @brief Edge of a patch of an upright and of a slab, metres. */
  static constexpr double upright_patch = 0.1;
  static constexpr double slab_patch = 0.25;

  void numberPatches();

  void addUprights(Floorplan& plan);
  void addStretches(const UprightSurface& surface, std::size_t curve);
  void addStretch(const UprightSurface& surface,
                  std::size_t curve,
                  double from,
                  double to,
                  const UprightSpan& span);
  void findGaps();
  void addSlabs(PlanRoom& room, unsigned threads);
  std::size_t addSlab(PlanSlab& slab,
                      const PlanLoop& loop,
                      const PlanSlab* parallel_to,
                      std::size_t parent);

  const PlanCurves& curves_;
  double reach_;
  std::string problem_;
  std::vector<double> length_;
  std::vector<double> depth_;      ///< of each curve's stretches, below their tops
  std::vector<double> gap_;        ///< of each curve, to the next that runs along it
  std::vector<double> patch_;      ///< length of the patches of each curve
  std::vector<std::size_t> along_; ///< patches along each curve, and along x of a slab
  std::vector<std::size_t> patch_count_;
  RefitPlaces places_;
};

} // namespace sedr
} // namespace pcl
