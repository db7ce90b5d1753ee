// SPDX-License-Identifier: BSD-3-Clause
#include "level_patches.h"

#include "sedr_filters/src/base/plane_fit.h"
#include "sedr_filters/src/grids/disjoint_sets.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace pcl::sedr {

RoomFloors::RoomFloors(const Building& building, double voxel)
    : grid_(building.grid)
{
  for (const BuildingRoom& room : building.rooms)
    for (const RoomColumn& c : room.columns)
      if (std::abs(c.floor - room.floor) < stair_priors.same_floor)
        at_[keyOf(c.cell)].push_back({room.id, c.floor - voxel / 2});
}

RoomFloors::Floor
RoomFloors::near(const Eigen::Vector2d& place, double z, double same, double away) const
{
  const int reach = static_cast<int>(std::ceil(away / grid_.size()));
  const Cell middle = grid_.at(place.x(), place.y());
  Floor nearest;
  double least = std::max(away, grid_.size());
  for (int dx = -reach; dx <= reach; ++dx)
    for (int dy = -reach; dy <= reach; ++dy) {
      const Cell cell{middle.x + dx, middle.y + dy};
      const auto found = at_.find(keyOf(cell));
      const double distance = (grid_.centre(cell) - place).norm();
      if (found == at_.end() || distance > least)
        continue;
      for (const Floor& floor : found->second)
        if (std::abs(floor.z - z) < same) {
          nearest = floor;
          least = distance;
        }
    }
  return nearest;
}

bool
RoomFloors::part(const Eigen::Vector2d& from,
                 double low,
                 const Eigen::Vector2d& to,
                 double high,
                 int steps) const
{
  const double rise = (high - low) / steps;
  for (int k = 1; k < steps; ++k)
    if (near(from + k * (to - from) / steps, low + k * rise, rise / 2).room != 0)
      return true;
  return false;
}

namespace {

/** @brief The top of something in a fine column, with air above. */
struct Level {
  Cell cell;
  std::int32_t voxel = 0;
  bool is_riser = false; ///< it goes down, as a ramp does not
  double z = 0;
  Eigen::Vector2d at = Eigen::Vector2d::Zero(); ///< mean of its points
  std::size_t points = 0;
};

class PatchFinder {
public:
  PatchFinder(const PointView& points,
              const std::vector<int>& indices,
              const VoxelColumns& fine,
              const RoomFloors& floors)
      : fine_(fine)
      , floors_(floors)
      , first_(fine.size() + 1, 0)
  {
    findLevels();
    measureHeights(points, indices);
  }

  std::vector<LevelPatch> find() const
  {
    // At a corner of a tread eight of the 24 cells around are level with it, at the end
    // of a riser's upper edge two; some were not seen.
    std::vector<std::uint8_t> is_core(levels_.size(), 0);
    for (std::uint32_t k = 0; k < levels_.size(); ++k) {
      int level = 0;
      forEachBeside(k, [&](std::uint32_t) { ++level; });
      is_core[k] = level >= (levels_[k].is_riser ? 3 : 6) ? 1 : 0;
    }
    DisjointSets<> sets(levels_.size());
    for (std::uint32_t k = 0; k < levels_.size(); ++k)
      if (is_core[k] != 0)
        forEachBeside(k, [&](std::uint32_t o) {
          if (is_core[o] != 0)
            sets.join(k, o);
        });
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> members;
    for (std::uint32_t k = 0; k < levels_.size(); ++k)
      if (is_core[k] != 0)
        members[sets.find(k)].push_back(k);
    std::vector<LevelPatch> patches;
    for (const auto& entry : members)
      addPatch(entry.second, patches);
    std::sort(patches.begin(), patches.end(),
              [](const LevelPatch& a, const LevelPatch& b) {
                return std::tuple(a.z, a.middle.x(), a.middle.y()) <
                       std::tuple(b.z, b.middle.x(), b.middle.y());
              });
    return patches;
  }

private:
  void findLevels()
  {
    const auto clear = static_cast<std::int32_t>(
        std::lround(stair_priors.clearance / fine_.voxelHeight()));
    const auto rise = static_cast<std::int32_t>(
        std::ceil(stair_priors.min_rise / fine_.voxelHeight()));
    for (std::uint32_t c = 0; c < fine_.size(); ++c) {
      bool has_top = false;
      bool is_riser = false;
      std::int32_t top = 0;
      fine_.forEachRun(c, [&](std::int32_t begin, std::int32_t end) {
        if (has_top && begin - top >= clear) {
          const Cell cell = fine_.cellOf(c);
          const double z = fine_.heightOf(top) - fine_.voxelHeight() / 2;
          if (floors_.near(fine_.grid().centre(cell), z, stair_priors.same_floor, 0)
                  .room == 0)
            levels_.push_back({cell, top - 1, is_riser});
        }
        has_top = true;
        is_riser = end - begin >= rise;
        top = end;
      });
      first_[c + 1] = static_cast<std::uint32_t>(levels_.size());
    }
  }

  /** @brief Gives each level the mean place and height of its points; of a riser the
   * height of its upper edge. */
  void measureHeights(const PointView& points, const std::vector<int>& indices)
  {
    const std::size_t n = indices.empty() ? points.size() : indices.size();
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t i = indices.empty() ? k : static_cast<std::size_t>(indices[k]);
      const Eigen::Vector3f p = points[i];
      if (!points.isFinite(i) || !fine_.grid().holds(p.x(), p.y()))
        continue;
      const std::uint32_t c = fine_.columnAt(fine_.grid().at(p.x(), p.y()));
      if (c == VoxelColumns::none)
        continue;
      for (std::uint32_t l = first_[c]; l < first_[c + 1]; ++l)
        if (Level& level = levels_[l]; fine_.voxelAt(p.z()) == level.voxel) {
          ++level.points;
          level.at += (p.head<2>().cast<double>() - level.at) /
                      static_cast<double>(level.points);
          if (level.is_riser)
            level.z = level.points == 1 ? p.z() : std::max<double>(level.z, p.z());
          else
            level.z += (p.z() - level.z) / static_cast<double>(level.points);
        }
    }
    for (Level& level : levels_)
      if (level.points == 0) {
        level.z = fine_.heightOf(level.voxel);
        level.at = fine_.grid().centre(level.cell);
      }
  }

  /** @brief Calls `visit` for the levels at most two cells from one and as high. */
  template <typename Visitor>
  void forEachBeside(std::uint32_t k, Visitor visit) const
  {
    constexpr int reach = 2; // cells
    const Level& level = levels_[k];
    for (int dx = -reach; dx <= reach; ++dx)
      for (int dy = -reach; dy <= reach; ++dy) {
        const std::uint32_t c = fine_.columnAt({level.cell.x + dx, level.cell.y + dy});
        if (c == VoxelColumns::none)
          continue;
        for (std::uint32_t l = first_[c]; l < first_[c + 1]; ++l)
          if (l != k && std::abs(levels_[l].z - level.z) <= stair_priors.level)
            visit(l);
      }
  }

  void addPatch(const std::vector<std::uint32_t>& members,
                std::vector<LevelPatch>& patches) const
  {
    const double cell = fine_.cellSize();
    const auto n = static_cast<double>(members.size());
    if (n * cell * cell < stair_priors.min_area)
      return;
    LevelPatch patch;
    double squares = 0;
    double flat = 0; // cells that are no edges of risers: theirs is the height
    for (const std::uint32_t k : members)
      flat += levels_[k].is_riser ? 0 : 1;
    for (const std::uint32_t k : members) {
      patch.cells.push_back(levels_[k].at);
      patch.middle += patch.cells.back() / n;
      patch.box.extend(patch.cells.back());
      if (flat == 0 || !levels_[k].is_riser)
        patch.z += levels_[k].z / (flat == 0 ? n : flat);
    }
    Eigen::Matrix2d scatter = n * cell * cell / 12 * Eigen::Matrix2d::Identity();
    for (const std::uint32_t k : members) {
      const Eigen::Vector2d d = levels_[k].at - patch.middle;
      scatter += d * d.transpose();
      squares += std::pow(levels_[k].z - patch.z, 2) / n;
    }
    if (squares > stair_priors.flatness * stair_priors.flatness ||
        floors_.near(patch.middle, patch.z).room != 0)
      return;        // a ramp, cushions; a part of a floor
    patch.is_tread = // as deep as a rectangle of that scatter
        std::sqrt(12 * symmetricEigen(scatter).values[0] / n) <= stair_priors.deepest;
    patches.push_back(std::move(patch));
  }

  const VoxelColumns& fine_;
  const RoomFloors& floors_;
  std::vector<std::uint32_t> first_; ///< of the levels of a column
  std::vector<Level> levels_;
};

} // namespace

std::vector<LevelPatch>
levelPatches(const PointView& points,
             const std::vector<int>& indices,
             const VoxelColumns& fine,
             const RoomFloors& floors)
{
  return PatchFinder(points, indices, fine, floors).find();
}

} // namespace pcl::sedr
