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

namespace pcl::sedr {

/** @brief The surfaces of a plan and the assignment of scan points to them.
 *
 * Curves of the plan are numbered first, then its slabs. Patches of vertical surfaces
 * are 0.1 m long, or less for short ones; those of slabs 0.25 m. Each surface has up to
 * three parameters. A line has its shift to the left and its rotation about the pivot,
 * a circle its centre and radius. A slab has its height and its slopes about the centre
 * of its loop, or only its height if parallel to another. */
class RefitTargets {
public:
  /** @brief `plan` must not be moved in memory; changed curves and slabs take effect.
   * @pre none of its loops is empty */
  RefitTargets(Floorplan& plan,
               const PlanCurves& curves,
               double reach,
               unsigned threads);

  /** @brief Returns the reason for a failure, a sentence; else empty. */
  const std::string& problem() const { return problem_; }

  std::size_t size() const { return curves_.curves.size() + places_.slabs.size(); }

  /** @brief Returns the maximum distance of a surface's points, metres. */
  double reach() const { return reach_; }

  std::size_t curveCount() const { return curves_.curves.size(); }
  std::size_t slabCount() const { return places_.slabs.size(); }
  PlanSlab& slab(std::size_t k) const { return *places_.slabs[k].slab; }
  const Eigen::Vector2d& middle(std::size_t k) const { return places_.slabs[k].middle; }

  /** @brief Returns the slab that sets the direction of slab `k`, or `k` itself. */
  std::size_t parent(std::size_t k) const { return places_.slabs[k].parent; }

  /** @brief Returns the minimum width of a slab, metres. */
  double widthOfSlab(std::size_t k) const { return places_.slabs[k].width; }

  /** @brief Returns the length of a curve in use, metres. */
  double lengthOf(std::size_t curve) const { return length_[curve]; }

  /** @brief Returns the distance to the nearest parallel vertical surface, such as the
   * other face of a partition, metres; infinite if none is near. */
  double gap(std::size_t number) const
  {
    return number < gap_.size() ? gap_[number]
                                : std::numeric_limits<double>::infinity();
  }

  /** @brief Returns the number of patches of a surface. */
  std::size_t patchCount(std::size_t number) const { return patch_count_[number]; }

  /** @brief Returns whether a patch of a surface is at the top of a wall, where
   * furniture hides it least. */
  bool isTop(std::size_t number, std::size_t patch) const
  {
    constexpr std::size_t rows = 3;
    return number < curves_.curves.size() && patch < rows * along_[number];
  }

  /** @brief Returns the spatial index of the surfaces. */
  const RefitPlaces& places() const { return places_; }

  /** @brief Returns the patch row at height `z` of a vertical surface, down from `top`.
   */
  static std::size_t rowOf(double top, double z)
  {
    return static_cast<std::size_t>((top - z) / vertical_patch);
  }

  /** @brief Returns the patch number of a slab at a position. */
  static std::size_t patchOf(const RefitSlab& slab, const Eigen::Vector2d& p)
  {
    const Eigen::Vector2d at =
        ((p - slab.middle + slab.half) / slab_patch).cwiseMax(0.0);
    const auto x = std::min(slab.along - 1, static_cast<std::size_t>(at.x()));
    const auto y = std::min(slab.rows - 1, static_cast<std::size_t>(at.y()));
    return y * slab.along + x;
  }

  /** @brief Calls `see(view)` with the LineView, CircleView or SlabView of a surface.
   */
  template <typename See>
  void view(std::size_t number, See see) const
  {
    if (number < curves_.curves.size()) {
      viewCurve(number, see);
      return;
    }
    const RefitSlab& slab = places_.slabs[number - curves_.curves.size()];
    see(SlabView{*slab.slab, slab.middle});
  }

  /** @brief The same of a curve. */
  template <typename See>
  void viewCurve(std::size_t number, See see) const
  {
    const PatchColumns columns{patch_[number], along_[number]};
    const MeasuredCurve& m = curves_.curves[number];
    if (m.curve.isCircle())
      see(CircleView{m.curve, columns});
    else
      see(LineView{m, curves_.reach(number), columns});
  }

private:
  /** @brief Edge of a patch of a vertical surface and of a slab, metres. */
  static constexpr double vertical_patch = 0.1;
  static constexpr double slab_patch = 0.25;

  void numberPatches();

  void addVerticals(Floorplan& plan);
  void addStretches(const VerticalSurface& surface, std::size_t curve);
  void addStretch(const VerticalSurface& surface,
                  std::size_t curve,
                  double from,
                  double to,
                  const VerticalSpan& span);
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
  std::vector<double> depth_; ///< height of each curve's stretches, metres
  std::vector<double> gap_;   ///< distance of each curve to the nearest parallel one
  std::vector<double> patch_; ///< length of each curve's patches
  std::vector<std::size_t> along_; ///< patches along each curve, or x of a slab
  std::vector<std::size_t> patch_count_;
  RefitPlaces places_;
};

} // namespace pcl::sedr
