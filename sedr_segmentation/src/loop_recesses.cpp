// SPDX-License-Identifier: BSD-3-Clause
#include "loop_recesses.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace pcl {
namespace sedr {

namespace {

constexpr double deepest = 0.6; // metres

/** @brief Share of the 10 cm cells of an upright rectangle in which a point is on it;
 * a cell at both ends, where other walls are, is left out.
 * @param low, high metres above the floor
 * @param tolerance metres */
double
shareSeen(const PlanElement& e,
          double low,
          double high,
          double tolerance,
          const PlanSlab& floor,
          const PointView& points,
          const std::vector<int>& indices)
{
  constexpr double cell = 0.1;
  const Eigen::Vector2d along = (e.end - e.start) / e.length();
  const double length = e.length() - 2 * cell;
  if (!(length > 0) || !(high > low))
    return 0;
  const auto columns = static_cast<std::size_t>(std::ceil(length / cell));
  const auto rows = static_cast<std::size_t>(std::ceil((high - low) / cell));
  std::vector<std::uint8_t> is_seen(columns * rows, 0);
  for (const int i : indices) {
    const Eigen::Vector3d p = points[static_cast<std::size_t>(i)].cast<double>();
    const Eigen::Vector2d to = p.head<2>() - e.start;
    const double s = along.dot(to) - cell;
    const double z = p.z() - floor.heightAt(p.head<2>()) - low;
    if (std::abs(along.x() * to.y() - along.y() * to.x()) > tolerance || !(s >= 0) ||
        !(s < length) || !(z >= 0) || !(z < high - low))
      continue;
    is_seen[std::min(rows - 1, static_cast<std::size_t>(z / cell)) * columns +
            std::min(columns - 1, static_cast<std::size_t>(s / cell))] = 1;
  }
  return static_cast<double>(std::count(is_seen.begin(), is_seen.end(), 1)) /
         static_cast<double>(is_seen.size());
}

/** @brief Five elements of a loop of which the first and the last are stretches of one
 * wall, and the others a recess in it. */
struct Recess {
  PlanElement before;
  PlanElement back;
  PlanElement after;

  /** @param first position of the first one */
  Recess(const PlanLoop& loop, std::size_t first)
      : before(at(loop, first))
      , back(at(loop, first + 2))
      , after(at(loop, first + 4))
      , is_straight_(!before.isArc() && !at(loop, first + 1).isArc() && !back.isArc() &&
                     !at(loop, first + 3).isArc() && !after.isArc())
  {}

  static const PlanElement& at(const PlanLoop& loop, std::size_t i)
  {
    return loop.elements[i % loop.elements.size()];
  }

  bool isOne() const
  {
    constexpr double in_line = 0.04; // metres
    constexpr double shallowest = 0.03;
    constexpr double narrowest = 0.4;
    if (!is_straight_)
      return false;
    const double depth = -aside(back.start);
    return std::abs(aside(after.start)) < in_line && back.length() > narrowest &&
           along(before).dot(along(after)) > 0.99 &&
           along(before).dot(along(back)) > 0.99 && depth > shallowest &&
           depth < deepest && std::abs(depth + aside(back.end)) < in_line;
  }

  /** @brief What closes it. */
  PlanElement mouth() const { return straight(before.end, after.start); }

  PlanElement wall() const { return straight(before.start, after.end); }

private:
  static PlanElement straight(const Eigen::Vector2d& start, const Eigen::Vector2d& end)
  {
    PlanElement e;
    e.start = start;
    e.end = end;
    return e;
  }

  static Eigen::Vector2d along(const PlanElement& e)
  {
    return (e.end - e.start).normalized();
  }

  /** @brief How far to the left of the wall a place is. */
  double aside(const Eigen::Vector2d& p) const
  {
    const Eigen::Vector2d way = along(before);
    const Eigen::Vector2d to = p - before.end;
    return way.x() * to.y() - way.y() * to.x();
  }

  bool is_straight_;
};

} // namespace

int
closeRecesses(PlanRoom& room, const PointView& points, const std::vector<int>& indices)
{
  constexpr double wall_low = 0.1; // metres above the floor
  constexpr double wall_high = 0.4;
  constexpr double least_wall = 0.5;
  constexpr double on_wall = 0.03; // furniture may be nearly flush with it
  constexpr double near_back = 0.05;
  constexpr double unseen = 0.05;
  int closed = 0;
  std::vector<PlanElement>& elements = room.boundary.elements;
  for (std::size_t i = 0; elements.size() > 6 && i < elements.size(); ++i) {
    const Recess recess(room.boundary, i);
    if (!recess.isOne())
      continue;
    const Eigen::Vector2d& place = recess.back.start;
    const double top = room.ceiling.heightAt(place) - room.floor.heightAt(place);
    const bool is_above_wall = shareSeen(recess.mouth(), wall_low, wall_high, on_wall,
                                         room.floor, points, indices) >= least_wall;
    if (!is_above_wall && shareSeen(recess.back, wall_low, top - wall_low, near_back,
                                    room.floor, points, indices) >= unseen)
      continue;
    const PlanElement wall = recess.wall();
    std::rotate(elements.begin(), elements.begin() + static_cast<std::ptrdiff_t>(i),
                elements.end());
    elements.erase(elements.begin(), elements.begin() + 4);
    elements.front() = wall;
    ++closed;
    i = static_cast<std::size_t>(-1); // it may end at the next one
  }
  return closed;
}

} // namespace sedr
} // namespace pcl
