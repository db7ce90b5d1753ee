// SPDX-License-Identifier: BSD-3-Clause
#include "height_lines.h"

#include "line_pieces.h"
#include "sedr_filters/src/plan/room_lookup.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace pcl::sedr {

namespace {

constexpr double usual_step = 0.05;    ///< metres between samples
constexpr std::size_t max_steps = 400; ///< along the longer side of a room

/** @brief Heights of a ceiling above the floor, on a grid over a room. */
struct HeightGrid {
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  double step = usual_step;
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::vector<double> height; ///< NaN outside the room, but not beside it
  std::vector<int> ceiling;   ///< the detail that is shown, or `outside`
  std::vector<int> floor;     ///< detail of the floor

  Eigen::Vector2d placeOf(std::size_t k) const
  {
    return origin + step * Eigen::Vector2d(static_cast<double>(k % columns),
                                           static_cast<double>(k / columns));
  }
};

constexpr int outside = -2; ///< of the room; others are as of PlanRoom::detailAt()

/** @brief Lets details go on one sample out of the room, so that lines reach its walls.
 */
void
passWalls(HeightGrid& grid)
{
  const auto stride = static_cast<std::ptrdiff_t>(grid.columns);
  const std::vector<int> in_room = grid.ceiling;
  for (std::size_t k = 0; k < in_room.size(); ++k)
    for (const std::ptrdiff_t way :
         {std::ptrdiff_t{-1}, std::ptrdiff_t{1}, -stride, stride, -stride - 1,
          -stride + 1, stride - 1, stride + 1}) {
      const auto other = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(k) + way);
      if (grid.ceiling[k] == outside && other < in_room.size())
        grid.ceiling[k] = in_room[other];
    }
}

HeightGrid
heightsOf(const PlanRoom& room, const CeilingLines& ceiling)
{
  HeightGrid grid;
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& corner : room.boundary.polygon(0.001))
    box.extend(corner);
  if (box.isEmpty())
    return grid;
  grid.step = std::max(usual_step, box.sizes().maxCoeff() / max_steps);
  // Shifted, or the first and last samples would lie on the walls.
  grid.origin = box.min() - Eigen::Vector2d::Constant(grid.step / 2);
  grid.columns = static_cast<std::size_t>(box.sizes().x() / grid.step) + 3;
  grid.rows = static_cast<std::size_t>(box.sizes().y() / grid.step) + 3;
  const RoomLookup lookup(room);
  for (std::size_t k = 0; k < grid.columns * grid.rows; ++k) {
    const Eigen::Vector2d p = grid.placeOf(k);
    grid.ceiling.push_back(lookup.contains(p) ? ceiling.shownFor(lookup.detailAt(p))
                                              : outside);
    grid.floor.push_back(lookup.floorDetailAt(p));
  }
  passWalls(grid);
  for (std::size_t k = 0; k < grid.ceiling.size(); ++k) {
    const Eigen::Vector2d p = grid.placeOf(k);
    grid.height.push_back(grid.ceiling[k] == outside
                              ? std::numeric_limits<double>::quiet_NaN()
                              : room.ceilingSlab(grid.ceiling[k]).heightAt(p) -
                                    room.floorSlab(grid.floor[k]).heightAt(p));
  }
  return grid;
}

/** @brief A side of a grid square: its first sample, and whether it runs along x. */
using Side = std::pair<std::size_t, bool>;

/** @brief Joins the crossings of a height with the sides of squares into lines. */
class LineTracer {
public:
  LineTracer(const PlanRoom& room,
             const CeilingLines& ceiling,
             const HeightGrid& grid,
             double height)
      : room_(room)
      , ceiling_(ceiling)
      , grid_(grid)
      , height_(height)
  {}

  std::vector<std::vector<Eigen::Vector2d>> run()
  {
    for (std::size_t y = 0; y + 1 < grid_.rows; ++y)
      for (std::size_t x = 0; x + 1 < grid_.columns; ++x)
        addSquare(y * grid_.columns + x);
    std::vector<std::vector<Eigen::Vector2d>> lines;
    // Open lines from their ends, then closed ones.
    for (const std::size_t ends : {1U, 2U})
      for (const auto& [side, others] : next_)
        if (others.size() == ends && !is_used_[side])
          lines.push_back(follow(side));
    return lines;
  }

private:
  bool isAbove(std::size_t k) const { return grid_.height[k] > height_; }

  void addSquare(std::size_t k)
  {
    const std::array<std::size_t, 4> corners{k, k + 1, k + grid_.columns + 1,
                                             k + grid_.columns};
    for (const std::size_t corner : corners)
      if (!std::isfinite(grid_.height[corner]))
        return;
    const std::array<Side, 4> sides{
        {{k, true}, {k + 1, false}, {k + grid_.columns, true}, {k, false}}};
    std::vector<Side> crossed;
    for (std::size_t i = 0; i < 4; ++i)
      if (isAbove(corners[i]) != isAbove(corners[(i + 1) % 4]) && !isStep(sides[i]))
        crossed.push_back(sides[i]);
    for (std::size_t i = 0; i + 1 < crossed.size(); i += 2) {
      next_[crossed[i]].push_back(crossed[i + 1]);
      next_[crossed[i + 1]].push_back(crossed[i]);
    }
  }

  std::size_t otherEnd(const Side& side) const
  {
    return side.first + (side.second ? 1 : grid_.columns);
  }

  /** @brief Returns whether a step of ceiling or floor is drawn between two samples. */
  bool isStep(const Side& side) const
  {
    const std::size_t other = otherEnd(side);
    const int a = grid_.ceiling[side.first];
    const int b = grid_.ceiling[other];
    const auto isFacet = [&](int k) {
      return k < 0 || room_.details[static_cast<std::size_t>(k)].is_facet;
    };
    if (grid_.floor[side.first] != grid_.floor[other] ||
        (a != b && !(isFacet(a) && isFacet(b))))
      return true;
    return a != b && ceiling_.isStep(
                         a, b, (grid_.placeOf(side.first) + grid_.placeOf(other)) / 2);
  }

  Eigen::Vector2d placeOf(const Side& side) const
  {
    const std::size_t other = otherEnd(side);
    const Eigen::Vector2d from = grid_.placeOf(side.first);
    const Eigen::Vector2d to = grid_.placeOf(other);
    const double low = grid_.height[side.first];
    const double high = grid_.height[other];
    const int detail = grid_.ceiling[side.first];
    const PlanSlab& ceiling = room_.ceilingSlab(detail);
    const Eigen::Vector2d straight =
        from + (height_ - low) / (high - low) * (to - from);
    if (!ceiling.curve || detail != grid_.ceiling[other])
      return straight;
    // A steep vault is far from its chord, even on a few centimetres.
    const double level = height_ - low + ceiling.heightAt(from);
    Eigen::Vector2d below = low < high ? from : to;
    Eigen::Vector2d above = low < high ? to : from;
    for (int k = 0; k < 12; ++k) {
      const Eigen::Vector2d middle = (below + above) / 2;
      (ceiling.heightAt(middle) > level ? above : below) = middle;
    }
    return (below + above) / 2;
  }

  std::vector<Eigen::Vector2d> follow(Side side)
  {
    const Side first = side;
    std::vector<Eigen::Vector2d> line;
    for (bool goes_on = true; goes_on;) {
      is_used_[side] = true;
      line.push_back(placeOf(side));
      goes_on = false;
      for (const Side& other : next_[side])
        if (!is_used_[other]) {
          side = other;
          goes_on = true;
          break;
        }
    }
    const std::vector<Side>& ends = next_[side];
    if (line.size() > 2 && std::find(ends.begin(), ends.end(), first) != ends.end())
      line.push_back(line.front());
    return line;
  }

  const PlanRoom& room_;
  const CeilingLines& ceiling_;
  const HeightGrid& grid_;
  double height_;
  std::map<Side, std::vector<Side>> next_;
  std::map<Side, bool> is_used_;
};

} // namespace

std::vector<PlanElement>
heightLines(const PlanRoom& room, const CeilingLines& ceiling, double height)
{
  std::vector<PlanElement> pieces;
  if (!room.hasFacets())
    return pieces;
  const HeightGrid grid = heightsOf(room, ceiling);
  if (grid.columns < 2 || grid.rows < 2)
    return pieces;
  constexpr double tolerance = 0.005;
  for (const auto& line : LineTracer(room, ceiling, grid, height).run())
    for (const PlanElement& piece : piecesOf(line, tolerance))
      pieces.push_back(piece);
  return pieces;
}

std::pair<double, double>
heightRange(const PlanRoom& room, const CeilingLines& ceiling)
{
  const RoomLookup lookup(room);
  std::pair<double, double> range(std::numeric_limits<double>::infinity(),
                                  -std::numeric_limits<double>::infinity());
  const auto add = [&](double height) {
    range.first = std::min(range.first, height);
    range.second = std::max(range.second, height);
  };
  const auto isShown = [&](const Eigen::Vector2d& p) {
    const int detail = lookup.detailAt(p);
    return lookup.contains(p) && ceiling.shownFor(detail) == detail;
  };
  const HeightGrid grid = heightsOf(room, ceiling);
  for (std::size_t k = 0; k < grid.height.size(); ++k)
    if (isShown(grid.placeOf(k)))
      add(grid.height[k]);
  // Eaves and ridges lie on the borders of facets, whose loops end at the walls only
  // within tolerance: what is above a wall is asked for beside it.
  for (const PlanElement& wall : room.boundary.elements)
    for (const double share : {0.02, 0.5, 0.98}) {
      const double s = share * wall.length();
      const Eigen::Vector2d p = wall.pointAt(s) + beside_border * wall.normalAt(s);
      if (isShown(p))
        add(room.ceilingSlab(lookup.detailAt(p)).heightAt(wall.pointAt(s)) -
            lookup.floorAt(p));
    }
  for (std::size_t d = 0; d < room.details.size(); ++d)
    for (const PlanElement& border : room.details[d].boundary.elements) {
      const Eigen::Vector2d p = border.pointAt(border.length() / 2);
      const int detail = static_cast<int>(d);
      if (ceiling.shownFor(detail) == detail && room.contains(p))
        add(room.details[d].slab.heightAt(p) - lookup.floorAt(p));
    }
  return range;
}

} // namespace pcl::sedr
