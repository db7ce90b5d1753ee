// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ceiling_beside.h"
#include "wall_sides.h"

#include "sedr_filters/src/rays/sight_lines.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace pcl::sedr {

/** @brief What a scan shows of a cell of a wall's side. */
enum class WallCell : std::uint8_t {
  Beyond,  ///< above the ceiling or below the floor
  Seen,    ///< points on the face
  Within,  ///< points behind the face, not as deep as the wall
  Through, ///< rays that went on behind the face
  Hidden,  ///< points before the face only, or rays that ended before it
  Leaf,    ///< points of a leaf that stands ajar before the face
  Empty,   ///< nothing
  Shaded   ///< nothing; something before the face is as near as it stands before it
};

/** @brief Whether a scan shows nothing of a cell. */
inline bool
isNothing(WallCell state)
{
  return state == WallCell::Empty || state == WallCell::Shaded;
}

/** @brief Returns how many states there are. */
constexpr std::size_t
wallCellStates()
{
  return static_cast<std::size_t>(WallCell::Shaded) + 1;
}

/** @brief Whether something before the face hides it. */
inline bool
isHidden(WallCell state)
{
  return state == WallCell::Hidden || state == WallCell::Leaf;
}

/** @brief What a scan shows of a side of a wall, in cells of arc length and height. */
class WallMap {
public:
  /** @brief Sorts points into cells whose size follows from their spacing.
   * @param points before and behind the side; those that it keeps are near the face
   * @param rays of the scanners; none: unknown
   * @param thickness returns how far behind it another face is known at a place along
   * it and a height; infinite: nowhere */
  WallMap(const PlanRoom& room,
          const WallSide& side,
          std::vector<SidePoint> points,
          const OpeningSizes& sizes,
          const std::vector<SightLine>& rays,
          const std::function<double(double, double)>& thickness);

  double cell() const { return cell_; }
  std::size_t columns() const { return columns_; }
  std::size_t rows() const { return rows_; }
  /** @brief Returns z of the lower edge of a row; the floor is in the middle of the
   * first one. */
  double heightOf(std::size_t row) const
  {
    return base_ + cell_ * static_cast<double>(row);
  }
  WallCell at(std::size_t column, std::size_t row) const
  {
    return cells_[column * rows_ + row];
  }
  /** @brief Returns the state at a place; Beyond if it is not on the map. */
  WallCell at(double along, double height) const;

  /** @brief Returns how far before the plan's surface lies what is nearest to it in a
   * cell, metres: 0 on it, else of what is before it, else, below 0, of what is behind
   * it; minus infinity where there is nothing. */
  float offsetAt(std::size_t column, std::size_t row) const
  {
    return offsets_[column * rows_ + row];
  }

  /** @brief Returns likewise what is farthest behind the surface in a cell, before the
   * other face of the wall where that is known; 0: nothing. */
  float farthestAt(std::size_t column, std::size_t row) const
  {
    return farthest_[column * rows_ + row];
  }

  /** @brief Returns the ceiling before and behind the surface, by columns. */
  const CeilingBeside& ceiling() const { return ceiling_; }

  /** @brief Returns up to which distance from floor and ceiling points are theirs,
   * metres. */
  double slabBand() const { return std::max(opening_numbers.slab_band, cell_ / 2); }

  /** @brief Returns the share of the cells of a rectangle that are in a state. */
  double
  shareOf(WallCell state, double from, double to, double bottom, double top) const;

  /** @brief Returns the height of the cells of a column that were seen, metres. */
  double seenHeight(double along) const;

  /** @brief Returns whether the face was seen up to a distance below the ceiling. */
  bool reachesCeiling(double along, double distance) const;

  /** @brief Returns how far points of the face are off it, three standard deviations.
   */
  double tolerance() const { return tolerance_; }
  /** @brief Returns the thickness of the wall, at most, at a place; likewise beside the
   * map. */
  double depthAt(double along, double height) const;
  /** @brief Returns the points before the face, on it and within the wall. */
  const std::vector<SidePoint>& points() const { return points_; }

private:
  void centreFace();
  void chooseCell();
  void findExtent(const PlanRoom& room, const WallSide& side);
  void count(const WallSide& side,
             const std::vector<SightLine>& rays,
             const std::vector<SidePoint>& of_leaves);
  void findOffsets(const PlanElement& line);
  void follow(const WallSide& side,
              const SightLine& ray,
              std::vector<std::uint32_t>& through,
              std::vector<std::uint32_t>& before) const;
  void spread(std::vector<float>& shade) const;
  void closeGaps();
  std::vector<bool> recessedCells() const;
  std::size_t indexOf(const SidePoint& p) const;

  double length_;
  double base_ = 0;
  double top_ = 0;
  double cell_ = 0.05;
  std::size_t columns_ = 0;
  std::size_t rows_ = 0;
  double tolerance_ = 0.02;
  double centre_ = 0; ///< of the face before the plan's surface
  double before_;
  std::vector<SidePoint> points_;
  std::vector<double> floors_;   ///< of each column
  std::vector<double> ceilings_; ///< of each column
  std::vector<float> depths_;    ///< of each cell
  std::vector<float> faces_;     ///< of each cell, depth of the other face
  std::vector<WallCell> cells_;
  std::vector<float> offsets_;
  std::vector<float> farthest_;
  CeilingBeside ceiling_;
};

} // namespace pcl::sedr
