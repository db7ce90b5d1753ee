// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/hidden_ceiling.h>

#include <pcl/sedr_segmentation/cell_count.h>

#include <algorithm>

namespace pcl {
namespace sedr {

namespace {

/** @brief How far from the ceiling that was seen its wall may be, metres. */
constexpr double deepest = 0.6;

/** @brief A gap of the ceiling along a wall that noise leaves is no deeper, metres. */
constexpr double least_depth = 0.12;

/** @brief Gaps within the ceiling are closed up to this far, metres. */
constexpr double gap_radius = 0.1;

class HiddenStrips {
public:
  HiddenStrips(const CellGrid& grid,
               const ColumnTable& columns,
               const PlanSlab& ceiling,
               const PlanSlab& floor)
      : grid_(grid)
      , columns_(columns)
      , ceiling_(ceiling)
      , floor_(floor)
  {}

  CellMask find(const CellMask& room, const CellMask& others) const
  {
    const double gap = cellsFor(gap_radius, grid_.size());
    const CellMask closed = eroded(dilated(room, gap), gap);
    const CellMask solid = unite(closed, enclosedCells(closed));
    const CellMask open = freeAround(solid, others);
    const CellMask walls = wallsAround(open);
    const CellMask beside_others = dilated(others, 2.5); // noise spreads a face
    const std::vector<float> from_room = squaredDistances(solid);
    const std::vector<float> from_wall = squaredDistances(walls);
    const MaskRegions regions = labelRegions(open, false);

    std::vector<Strip> strips(regions.sizes.size());
    for (std::size_t i = 0; i < open.values().size(); ++i)
      if (regions.label[i] >= 0)
        strips[static_cast<std::size_t>(regions.label[i])].add(
            *this, open.cellAt(i),
            {solid, open, beside_others, from_room[i], from_wall[i]});
    const auto depth = static_cast<float>(least_depth / grid_.size());
    CellMask hidden(room.box());
    for (std::size_t i = 0; i < open.values().size(); ++i)
      if (regions.label[i] >= 0 &&
          strips[static_cast<std::size_t>(regions.label[i])].isHidden(depth))
        hidden.values()[i] = 1;
    return hidden;
  }

private:
  /** @brief What is known around a cell of a strip. */
  struct Surroundings {
    const CellMask& room;
    const CellMask& strips;
    const CellMask& beside_others; ///< other rooms, and two cells around them
    float from_room;               ///< squared, cells
    float from_wall;
  };

  /** @brief Counts of a strip. */
  struct Strip {
    std::size_t inner_edges = 0; ///< towards the room
    std::size_t inner_walls = 0;
    std::size_t outer_edges = 0;
    std::size_t outer_walls = 0;
    std::size_t before_wall = 0; ///< cells just before its wall
    std::size_t covered = 0;     ///< those of them with something in the upper half
    float deepest = 0;           ///< squared, cells

    void add(const HiddenStrips& scene, Cell cell, const Surroundings& around)
    {
      constexpr float at_wall = 1.5F * 1.5F;
      constexpr float near_wall = 3.5F * 3.5F;
      for (const Cell near : {Cell{cell.x + 1, cell.y}, Cell{cell.x - 1, cell.y},
                              Cell{cell.x, cell.y + 1}, Cell{cell.x, cell.y - 1}}) {
        if (around.strips.at(near))
          continue;
        const bool is_inner = around.room.at(near) != 0;
        // What a wall shows to another room is no end of this one.
        const bool is_wall =
            scene.isWall(near, 1) && (is_inner || !around.beside_others.at(near));
        (is_inner ? inner_edges : outer_edges) += 1;
        (is_inner ? inner_walls : outer_walls) += is_wall ? 1 : 0;
      }
      if (around.from_wall > at_wall && around.from_wall <= near_wall) {
        ++before_wall;
        covered += scene.isCovered(cell) ? 1 : 0;
      }
      deepest = std::max(deepest, around.from_room);
    }

    bool isHidden(float in_cells) const
    {
      return deepest >= in_cells * in_cells && 10 * outer_walls >= 8 * outer_edges &&
             10 * inner_walls <= 2 * inner_edges && 10 * covered <= 4 * before_wall;
    }
  };

  /** @brief Whether a wall stands in the column, or within `radius` cells: in the upper
   * half of the room, as furniture hides the lower, as far up as it can be seen below
   * what hides the ceiling; or above a window, where it passes the ceiling, which then
   * ends before it: a slot for a curtain. */
  bool isWall(Cell cell, int radius) const
  {
    const auto [middle, top] = upperHalf(cell);
    return columns_.share(cell, middle, top - 0.4, 5, radius) >= 0.6 ||
           columns_.share(cell, top - 0.05, top + 0.1, 3, radius) >= 1;
  }

  /** @brief Whether the upper half of the column holds anything. */
  bool isCovered(Cell cell) const
  {
    const auto [middle, top] = upperHalf(cell);
    return columns_.hasWithin(cell, middle, top + 0.1);
  }

  std::pair<double, double> upperHalf(Cell cell) const
  {
    const Eigen::Vector2d place = grid_.centre(cell);
    const double top = ceiling_.heightAt(place);
    return {(floor_.heightAt(place) + top) / 2, top};
  }

  /** @brief The cells to which a way of cells without walls leads from the room. */
  CellMask freeAround(const CellMask& room, const CellMask& others) const
  {
    const int steps = cellsFor(deepest, grid_.size());
    CellMask domain = subtract(dilated(room, steps), others);
    for (std::size_t i = 0; i < domain.values().size(); ++i)
      if (domain.values()[i] && !room.values()[i] && isWall(domain.cellAt(i), 0))
        domain.values()[i] = 0;
    std::vector<std::int32_t> label(domain.values().size(), -1);
    for (std::size_t i = 0; i < label.size(); ++i)
      label[i] = room.values()[i] ? 0 : -1;
    growLabels(domain, steps, label);
    CellMask open(room.box());
    for (std::size_t i = 0; i < label.size(); ++i)
      open.values()[i] = label[i] == 0 && !room.values()[i] ? 1 : 0;
    return open;
  }

  CellMask wallsAround(const CellMask& strips) const
  {
    CellMask walls = subtract(dilated(strips, 2), strips);
    for (std::size_t i = 0; i < walls.values().size(); ++i)
      if (walls.values()[i] && !isWall(walls.cellAt(i), 0))
        walls.values()[i] = 0;
    return walls;
  }

  const CellGrid& grid_;
  const ColumnTable& columns_;
  const PlanSlab& ceiling_;
  const PlanSlab& floor_;
};

} // namespace

CellMask
hiddenCeiling(const CellMask& room,
              const CellMask& others,
              const CellGrid& grid,
              const ColumnTable& columns,
              const PlanSlab& ceiling,
              const PlanSlab& floor)
{
  return HiddenStrips(grid, columns, ceiling, floor).find(room, others);
}

} // namespace sedr
} // namespace pcl
