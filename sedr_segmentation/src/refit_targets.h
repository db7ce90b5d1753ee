// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refit_views.h"

#include <pcl/sedr_filters/cell_table.h>
#include <pcl/sedr_filters/plan_surfaces.h>
#include <pcl/sedr_segmentation/plan_curves.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
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
  RefitTargets(Floorplan& plan, const PlanCurves& curves, double reach);

  /** @brief Why there is nothing to look up, a sentence; empty otherwise. */
  const std::string& problem() const { return problem_; }

  std::size_t size() const { return curves_.curves.size() + slabs_.size(); }

  /** @brief Points farther from a surface are not its own, metres. */
  double reach() const { return reach_; }

  std::size_t slabCount() const { return slabs_.size(); }
  PlanSlab& slab(std::size_t k) const { return *slabs_[k].slab; }
  const Eigen::Vector2d& middle(std::size_t k) const { return slabs_[k].middle; }

  /** @brief The slab whose direction slab `k` has; `k` itself where it has its own. */
  std::size_t parent(std::size_t k) const { return slabs_[k].parent; }

  /** @brief Length of the shown part of a curve that is looked at, metres. */
  double lengthOf(std::size_t curve) const { return length_[curve]; }

  /** @brief Distance to the nearest other upright that runs along a surface, such as
   * the other face of a partition, metres; infinite where none is near. */
  double gap(std::size_t number) const
  {
    return number < gap_.size() ? gap_[number]
                                : std::numeric_limits<double>::infinity();
  }

  /** @brief Number of all patches, and the first one of a surface. */
  std::size_t patchCount() const { return first_patch_.back(); }
  std::size_t firstPatch(std::size_t number) const { return first_patch_[number]; }

  /** @brief Number of the patches that the plan shows: curves go on beyond that. */
  std::size_t shownPatches() const { return shown_patches_; }

  /** @brief Whether a patch, from the first of its surface, is at the top of a wall,
   * where least stands before it. */
  bool isTop(std::size_t number, std::size_t patch) const
  {
    constexpr std::size_t rows = 3;
    return number < curves_.curves.size() && patch < rows * along_[number];
  }

  /** @brief Calls `note(number, place)` for every surface that a point may show by its
   * place: one before which it is, and any slab at most `far` metres from it. `place`
   * is what does not change with the surface: the row of patches of an upright, the
   * patch of a slab. */
  template <typename Note>
  void candidates(const Eigen::Vector3d& p, double far, Note note) const
  {
    const Eigen::Vector2d place = p.head<2>();
    const CellGrid& grid = stretches_near_.grid(); // that of all tables
    if (!grid.holds(place.x(), place.y()))
      return;
    const Cell cell = grid.at(place.x(), place.y());
    findUprights(p, cell, note);
    findSlabs(p, cell, far, note);
  }

  /** @brief Calls `see(view)` by the kind of a surface: a LineView, CircleView or
   * SlabView. */
  template <typename See>
  void view(std::size_t number, See see) const
  {
    if (number >= curves_.curves.size()) {
      const Slab& slab = slabs_[number - curves_.curves.size()];
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

  /** @brief The greatest distance, metres, of a slab from where it was, `before` having
   * been all slabs. */
  double farthestMove(const std::vector<PlanSlab>& before) const;

private:
  /** @brief A part of an upright surface with one height. */
  struct Stretch {
    std::size_t curve = 0;
    PlanElement part; ///< away from corners
    double low = 0;
    double high = 0;
  };

  struct Slab {
    PlanSlab* slab = nullptr;
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    std::size_t parent = 0; ///< whose direction it has
    Eigen::Vector2d half =
        Eigen::Vector2d::Zero(); ///< extent of its loop about the middle
  };

  /** @brief Which slabs are above and below the cells of a room, -1 none, away from
   * edges. */
  struct RoomMap {
    double cell = 0.05;
    Eigen::Vector2d low = Eigen::Vector2d::Zero();
    std::int32_t width = 0;
    std::int32_t height = 0;
    std::vector<std::int32_t> ceiling;
    std::vector<std::int32_t> floor;
  };

  /** @brief The bottom and top of a niche. */
  struct NicheSlabs {
    const PlanNiche* niche = nullptr;
    std::size_t bottom = 0;
    std::size_t top = 0;
  };

  template <typename Note>
  void findUprights(const Eigen::Vector3d& p, Cell cell, Note note) const
  {
    for (const std::uint32_t k : stretches_near_.ofCell(cell)) {
      const Stretch& stretch = stretches_[k];
      if (p.z() >= stretch.low && p.z() <= stretch.high &&
          stretch.part.isBeside(p.head<2>()))
        note(stretch.curve, rowOf(stretch, p.z()));
    }
  }

  template <typename Note>
  void findSlabs(const Eigen::Vector3d& p, Cell cell, double far, Note note) const
  {
    const Eigen::Vector2d place = p.head<2>();
    const auto noteNear = [&](std::size_t k) {
      if (std::abs(distanceAbove(*slabs_[k].slab, p.cast<float>())) <= far)
        note(curves_.curves.size() + k, patchOf(k, place));
    };
    for (const std::uint32_t r : rooms_near_.ofCell(cell)) {
      const RoomMap& map = rooms_[r];
      const Eigen::Vector2d at = (place - map.low) / map.cell;
      if (at.x() < 0 || at.y() < 0 || at.x() >= map.width || at.y() >= map.height)
        continue;
      const auto i =
          static_cast<std::size_t>(at.y()) * static_cast<std::size_t>(map.width) +
          static_cast<std::size_t>(at.x());
      if (map.ceiling[i] >= 0)
        noteNear(static_cast<std::size_t>(map.ceiling[i]));
      if (map.floor[i] >= 0)
        noteNear(static_cast<std::size_t>(map.floor[i]));
    }
    for (const std::uint32_t n : niches_near_.ofCell(cell))
      if (isIn(niches_[n], place)) {
        noteNear(niches_[n].bottom);
        noteNear(niches_[n].top);
      }
  }

  static std::size_t rowOf(const Stretch& stretch, double z);
  std::size_t patchOf(std::size_t slab, const Eigen::Vector2d& p) const;
  void numberPatches();

  static bool isIn(const NicheSlabs& niche, const Eigen::Vector2d& p);

  void addUprights(Floorplan& plan);
  void addStretches(const UprightSurface& surface, std::size_t curve);
  void addStretch(const UprightSurface& surface,
                  std::size_t curve,
                  double from,
                  double to,
                  const UprightSpan& span);
  void findGaps();
  void addSlabs(PlanRoom& room);
  std::size_t addSlab(PlanSlab& slab,
                      const Eigen::Vector2d& middle,
                      const Eigen::Vector2d& half,
                      const PlanSlab* parallel_to,
                      std::size_t parent);
  void tabulate();

  const PlanCurves& curves_;
  double reach_;
  std::string problem_;
  std::vector<Stretch> stretches_;
  std::vector<double> length_;
  std::vector<double> depth_;      ///< of each curve's stretches, below their tops
  std::vector<double> gap_;        ///< of each curve, to the next that runs along it
  std::vector<double> patch_;      ///< length of the patches of each curve
  std::vector<std::size_t> along_; ///< patches along each curve, and along x of a slab
  std::vector<std::size_t> first_patch_;
  std::vector<Slab> slabs_;
  std::vector<RoomMap> rooms_;
  std::vector<NicheSlabs> niches_;
  std::size_t shown_patches_ = 0;
  static constexpr double table_cell = 0.2; // metres
  CellTable stretches_near_{table_cell};
  CellTable rooms_near_{table_cell};
  CellTable niches_near_{table_cell};
};

} // namespace sedr
} // namespace pcl
