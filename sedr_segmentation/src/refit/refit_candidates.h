// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "even_share.h"
#include "refit_targets.h"

#include <algorithm>
#include <limits>

namespace pcl {
namespace sedr {

/** @brief Which of the points that may show a surface are looked at: all, at first. */
struct LookedAt {
  explicit LookedAt(const RefitTargets& targets, EvenShare share = EvenShare())
      : of_surface(targets.size(), share)
      , of_patch(targets.patchCount(), share)
  {}

  std::vector<EvenShare> of_surface;
  std::vector<EvenShare> of_patch; ///< of slabs; no more than of the surface
};

/** @brief Tells which surfaces of a plan a point of the scan may show by its place, as
 * they are when this is made. */
class RefitCandidates {
public:
  /** @param far slabs are told of points at most so many metres from them
   * @param targets must outlive this, as `looked_at` must */
  RefitCandidates(const RefitTargets& targets, double far, const LookedAt& looked_at);

  /** @brief Calls `note(number, place)` for every surface that a point may show by
   * its place, if it is one of the surface's share: one before which it is, and any
   * slab not too far from it. `place` is what does not change with the surface: the row
   * of patches of an upright, the patch of a slab. A point that is not finite shows
   * none. */
  template <typename Note>
  void find(const Eigen::Vector3f& point, Note note) const
  {
    const std::uint32_t number = EvenShare::numberOf(point);
    if (!EvenShare::mayHold(most_parts_, number))
      return;
    const Eigen::Array2d at =
        (point.head<2>().cast<double>() - low_).array() * cells_per_metre;
    if (!((at >= 0).all() && at.x() < width_ && at.y() < height_)) // nor a NaN
      return;
    const Here& here =
        heres_[cells_[static_cast<std::size_t>(static_cast<int>(at.y())) *
                          static_cast<std::size_t>(width_) +
                      static_cast<std::size_t>(static_cast<int>(at.x()))]];
    if (!EvenShare::mayHold(here.parts, number)) // most points of a dense scan
      return;
    const Eigen::Vector3d p = point.cast<double>();
    if (here.heights.holds(p.z()))
      for (const std::uint32_t u : here.stretches)
        noteUpright(uprights_[u], number, p, note);
    for (const std::uint32_t r : here.rooms)
      findSlabs(rooms_[r], number, p, note);
    for (const std::uint32_t n : here.niches)
      findNiche(number, places_.niches[n], p, note);
  }

private:
  static constexpr double cells_per_metre = 1 / RefitPlaces::table_cell;

  struct Heights {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    bool holds(double z) const { return z >= low && z <= high; }

    void unite(double other_low, double other_high)
    {
      low = std::min(low, other_low);
      high = std::max(high, other_high);
    }
  };

  /** @brief What there is to know of a stretch, side by side. */
  struct Upright {
    Upright(const RefitStretch& stretch, EvenShare share);

    bool isBeside(const Eigen::Vector2d& p) const
    {
      if (arc)
        return arc->isBeside(p);
      const double s = (p - start).dot(way);
      return s >= 0 && s <= squared_length;
    }

    Heights heights;
    Eigen::Vector2d start;
    Eigen::Vector2d way;
    double squared_length;
    const PlanElement* arc; ///< null of a line
    std::size_t curve;
    EvenShare share;
  };

  /** @brief The map of a room, and the heights that its slabs may be shown at. */
  struct Room {
    const RefitRoomMap* map;
    double cells_per_metre;
    Heights ceiling;
    Heights floor;
  };

  /** @brief What may be shown in a cell. */
  struct Here {
    CellTable::Numbers stretches;
    CellTable::Numbers rooms;
    CellTable::Numbers niches;
    Heights heights;        ///< of the stretches
    std::uint8_t parts = 0; ///< of its points that are looked at, in 128ths

    bool isNothing() const
    {
      return stretches.first == stretches.last && rooms.first == rooms.last &&
             niches.first == niches.last;
    }

    void raiseParts(const EvenShare& share) { parts = std::max(parts, share.parts()); }
  };

  void tellCells();
  Heights heightsOf(const RefitSlabRange& slabs, const RefitRoomMap& map) const;
  void tellPartsOf(std::size_t slab);

  template <typename Note>
  static void noteUpright(const Upright& upright,
                          std::uint32_t number,
                          const Eigen::Vector3d& p,
                          Note note)
  {
    if (upright.share.holds(number) && upright.heights.holds(p.z()) &&
        upright.isBeside(p.head<2>()))
      note(upright.curve, RefitTargets::rowOf(upright.heights.high, p.z()));
  }

  template <typename Note>
  void findSlabs(const Room& room,
                 std::uint32_t number,
                 const Eigen::Vector3d& p,
                 Note note) const
  {
    const bool may_be_ceiling = room.ceiling.holds(p.z());
    const bool may_be_floor = room.floor.holds(p.z());
    if (!may_be_ceiling && !may_be_floor)
      return;
    const RefitRoomMap& map = *room.map;
    const Eigen::Vector2d at = (p.head<2>() - map.low) * room.cells_per_metre;
    if (at.x() < 0 || at.y() < 0 || at.x() >= map.width || at.y() >= map.height)
      return;
    const auto i =
        static_cast<std::size_t>(at.y()) * static_cast<std::size_t>(map.width) +
        static_cast<std::size_t>(at.x());
    if (may_be_ceiling && map.ceiling[i] >= 0)
      noteNear(number, static_cast<std::size_t>(map.ceiling[i]), p, note);
    if (may_be_floor && map.floor[i] >= 0)
      noteNear(number, static_cast<std::size_t>(map.floor[i]), p, note);
  }

  template <typename Note>
  void findNiche(std::uint32_t number,
                 const RefitNiche& niche,
                 const Eigen::Vector3d& p,
                 Note note) const
  {
    constexpr double margin = 0.03;
    const PlanLoop& boundary = niche.niche->boundary;
    if (!boundary.contains(p.head<2>()) || boundary.distance(p.head<2>()) <= margin)
      return;
    noteNear(number, niche.bottom, p, note);
    noteNear(number, niche.top, p, note);
  }

  template <typename Note>
  void noteNear(std::uint32_t number,
                std::size_t slab,
                const Eigen::Vector3d& p,
                Note note) const
  {
    if (!(std::abs(planes_[slab].head<3>().dot(p) + planes_[slab][3]) <= far_))
      return; // a NaN, too
    const std::size_t patch = RefitTargets::patchOf(places_.slabs[slab], p.head<2>());
    if (looked_at_.of_patch[first_patches_[slab] + patch].holds(number))
      note(first_slab_ + slab, patch);
  }

  const RefitPlaces& places_;
  double far_;
  const LookedAt& looked_at_;
  std::size_t first_slab_; ///< number of the first slab
  std::vector<Upright> uprights_;
  std::vector<Room> rooms_;
  std::vector<Eigen::Vector4d> planes_;    ///< of the slabs
  std::vector<std::size_t> first_patches_; ///< of the slabs
  std::vector<Here> heres_; ///< nothing, then those of the cells that may show anything
  std::vector<std::uint32_t> cells_; ///< which is whose, in the tables' box row by row
  Eigen::Vector2d low_ = Eigen::Vector2d::Zero(); ///< its corner, metres
  int width_ = 0;
  int height_ = 0;
  std::uint8_t most_parts_ = 0; ///< of any cell
};

} // namespace sedr
} // namespace pcl
