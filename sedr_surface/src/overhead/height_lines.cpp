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
  std::vector<double> floor;  ///< z
  std::vector<const PlanSlab*> ceiling;

  Eigen::Vector2d placeOf(std::size_t k) const
  {
    return origin + step * Eigen::Vector2d(static_cast<double>(k % columns),
                                           static_cast<double>(k / columns));
  }
};

constexpr int outside = -3; ///< of the room
constexpr int given = -2;   ///< to a neighbour; others are as of PlanRoom::detailAt()

bool
isGiven(const std::vector<bool>& is_given, int detail)
{
  return is_given[static_cast<std::size_t>(detail + 1)];
}

/** @brief Lets details go on over what is given to them, and one sample out of the
 * room, so that lines reach its walls. */
void
spreadDetails(const HeightGrid& grid, std::vector<int>& detail)
{
  const auto stride = static_cast<std::ptrdiff_t>(grid.columns);
  std::vector<std::size_t> wave;
  for (std::size_t k = 0; k < detail.size(); ++k)
    if (detail[k] > given)
      wave.push_back(k);
  const std::vector<int> in_room = detail;
  for (std::size_t next = 0; next < wave.size(); ++next) {
    const std::size_t k = wave[next];
    if (in_room[k] == outside)
      continue;
    for (const std::ptrdiff_t way :
         {std::ptrdiff_t{-1}, std::ptrdiff_t{1}, -stride, stride, -stride - 1,
          -stride + 1, stride - 1, stride + 1}) {
      const auto other = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(k) + way);
      if (other >= detail.size() || detail[other] > given)
        continue;
      detail[other] = detail[k];
      wave.push_back(other);
    }
  }
}

HeightGrid
heightsOf(const PlanRoom& room, const std::vector<bool>& is_given)
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
  std::vector<int> detail;
  for (std::size_t k = 0; k < grid.columns * grid.rows; ++k) {
    const Eigen::Vector2d p = grid.placeOf(k);
    const int at = lookup.contains(p) ? lookup.detailAt(p) : outside;
    detail.push_back(at != outside && isGiven(is_given, at) ? given : at);
  }
  spreadDetails(grid, detail);
  for (std::size_t k = 0; k < detail.size(); ++k) {
    const Eigen::Vector2d p = grid.placeOf(k);
    const bool is_known = detail[k] > given;
    grid.ceiling.push_back(is_known ? &room.ceilingSlab(detail[k]) : nullptr);
    grid.floor.push_back(lookup.floorAt(p));
    grid.height.push_back(is_known ? grid.ceiling.back()->heightAt(p) - grid.floor[k]
                                   : std::numeric_limits<double>::quiet_NaN());
  }
  return grid;
}

/** @brief A side of a grid square: its first sample, and whether it runs along x. */
using Side = std::pair<std::size_t, bool>;

/** @brief Joins the crossings of a height with the sides of squares into lines. */
class LineTracer {
public:
  LineTracer(const HeightGrid& grid, double height)
      : grid_(grid)
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

  /** @brief Returns whether ceiling or floor step between two samples: that edge is
   * drawn as such. */
  bool isStep(const Side& side) const
  {
    constexpr double min_step = 0.03;
    const std::size_t other = otherEnd(side);
    const Eigen::Vector2d p = (grid_.placeOf(side.first) + grid_.placeOf(other)) / 2;
    const auto heightAt = [&](std::size_t k) {
      return grid_.ceiling[k]->heightAt(p) - grid_.floor[k];
    };
    return std::abs(heightAt(side.first) - heightAt(other)) > min_step;
  }

  Eigen::Vector2d placeOf(const Side& side) const
  {
    const std::size_t other = otherEnd(side);
    const Eigen::Vector2d from = grid_.placeOf(side.first);
    const Eigen::Vector2d to = grid_.placeOf(other);
    const double low = grid_.height[side.first];
    const double high = grid_.height[other];
    const PlanSlab* ceiling = grid_.ceiling[side.first];
    const Eigen::Vector2d straight =
        from + (height_ - low) / (high - low) * (to - from);
    if (!ceiling->curve || ceiling != grid_.ceiling[other])
      return straight;
    // A steep vault is far from its chord, even on a few centimetres.
    const double level = height_ - low + ceiling->heightAt(from);
    Eigen::Vector2d below = low < high ? from : to;
    Eigen::Vector2d above = low < high ? to : from;
    for (int k = 0; k < 12; ++k) {
      const Eigen::Vector2d middle = (below + above) / 2;
      (ceiling->heightAt(middle) > level ? above : below) = middle;
    }
    return (below + above) / 2;
  }

  std::vector<Eigen::Vector2d> follow(Side side)
  {
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
    return line;
  }

  const HeightGrid& grid_;
  double height_;
  std::map<Side, std::vector<Side>> next_;
  std::map<Side, bool> is_used_;
};

} // namespace

std::vector<PlanElement>
heightLines(const PlanRoom& room, const std::vector<bool>& is_given, double height)
{
  std::vector<PlanElement> pieces;
  if (!room.hasFacets())
    return pieces;
  const HeightGrid grid = heightsOf(room, is_given);
  if (grid.columns < 2 || grid.rows < 2)
    return pieces;
  constexpr double tolerance = 0.005;
  for (const auto& line : LineTracer(grid, height).run())
    for (const PlanElement& piece : piecesOf(line, tolerance))
      pieces.push_back(piece);
  return pieces;
}

std::pair<double, double>
heightRange(const PlanRoom& room, const std::vector<bool>& is_given)
{
  const RoomLookup lookup(room);
  std::pair<double, double> range(std::numeric_limits<double>::infinity(),
                                  -std::numeric_limits<double>::infinity());
  const auto add = [&](double height) {
    range.first = std::min(range.first, height);
    range.second = std::max(range.second, height);
  };
  const HeightGrid grid = heightsOf(room, is_given);
  for (std::size_t k = 0; k < grid.height.size(); ++k)
    if (std::isfinite(grid.height[k]) && lookup.contains(grid.placeOf(k)))
      add(grid.height[k]);
  // Eaves and ridges lie on the borders of facets, whose loops end at the walls only
  // within tolerance: what is above a wall is asked for beside it.
  for (const PlanElement& wall : room.boundary.elements)
    for (const double share : {0.02, 0.5, 0.98}) {
      const double s = share * wall.length();
      const Eigen::Vector2d p = wall.pointAt(s) + beside_border * wall.normalAt(s);
      const int detail = room.detailAt(p);
      if (room.contains(p) && !isGiven(is_given, detail))
        add(room.ceilingSlab(detail).heightAt(wall.pointAt(s)) - lookup.floorAt(p));
    }
  for (std::size_t d = 0; d < room.details.size(); ++d)
    for (const PlanElement& border : room.details[d].boundary.elements) {
      const Eigen::Vector2d p = border.pointAt(border.length() / 2);
      if (!is_given[d + 1] && room.contains(p))
        add(room.details[d].slab.heightAt(p) - lookup.floorAt(p));
    }
  return range;
}

} // namespace pcl::sedr
