// SPDX-License-Identifier: BSD-3-Clause
#include "loop_recesses.h"

#include "../niches/niche_fit.h"
#include "sedr_filters/src/base/middle_value.h"
#include "sedr_filters/src/base/plane_fit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace pcl {
namespace sedr {

namespace {

/** @brief A point as a wall sees it, metres: along the wall, out of the room, above the
 * floor. */
struct WallPlace {
  WallPlace(const Eigen::Vector3f& point,
            const PlanElement& wall,
            const PlanSlab& floor)
  {
    const Eigen::Vector3d p = point.cast<double>();
    const Eigen::Vector2d way = (wall.end - wall.start) / wall.length();
    const Eigen::Vector2d to = p.head<2>() - wall.start;
    along = way.dot(to);
    out = way.y() * to.x() - way.x() * to.y();
    height = p.z() - floor.heightAt(p.head<2>());
  }

  double along;
  double out;
  double height;
};

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
          const std::vector<int>& indices,
          const Priors& priors)
{
  const double cell = priors.evidence_cell;
  const double length = e.length() - 2 * cell;
  if (!(length > 0) || !(high > low))
    return 0;
  const auto columns = static_cast<std::size_t>(std::ceil(length / cell));
  const auto rows = static_cast<std::size_t>(std::ceil((high - low) / cell));
  std::vector<std::uint8_t> is_seen(columns * rows, 0);
  for (const int i : indices) {
    const WallPlace place(points[static_cast<std::size_t>(i)], e, floor);
    const double s = place.along - cell;
    const double z = place.height - low;
    if (std::abs(place.out) > tolerance || !(s >= 0) || !(s < length) || !(z >= 0) ||
        !(z < high - low))
      continue;
    is_seen[std::min(rows - 1, static_cast<std::size_t>(z / cell)) * columns +
            std::min(columns - 1, static_cast<std::size_t>(s / cell))] = 1;
  }
  return static_cast<double>(std::count(is_seen.begin(), is_seen.end(), 1)) /
         static_cast<double>(is_seen.size());
}

/** @brief How high the wall below a recess goes, metres above the floor: the middle of
 * where it ends in strips of 10 cm, and of the points seen on what is on it. */
double
heightOfSill(const PlanElement& mouth,
             double depth,
             double tolerance,
             const PlanSlab& floor,
             const PointView& points,
             const std::vector<int>& indices,
             const Priors& priors)
{
  const double strip = priors.evidence_cell;
  std::vector<std::vector<double>> on_wall(
      static_cast<std::size_t>(std::ceil(mouth.length() / strip)));
  std::vector<double> behind;
  for (const int i : indices) {
    const WallPlace place(points[static_cast<std::size_t>(i)], mouth, floor);
    if (!(place.along >= 0) || !(place.along < mouth.length()) || !(place.height >= 0))
      continue;
    if (std::abs(place.out) <= tolerance)
      on_wall[std::min(on_wall.size() - 1,
                       static_cast<std::size_t>(place.along / strip))]
          .push_back(place.height);
    else if (place.out > strip / 2 && place.out < depth - strip / 2)
      behind.push_back(place.height);
  }
  std::vector<double> tops;
  for (std::vector<double>& heights : on_wall) {
    std::sort(heights.begin(), heights.end());
    double top = 0;
    for (const double z : heights)
      top = z < top + priors.run_gap ? z : top;
    tops.push_back(top);
  }
  const double top = middleValue(std::move(tops));
  std::vector<double> near;
  for (const double z : behind)
    if (std::abs(z - top) < strip)
      near.push_back(z);
  return near.size() < 5 ? top : middleValue(std::move(near));
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

  bool isOne(const Priors& priors) const
  {
    const double in_line = priors.min_wall;
    constexpr double cosine = 0.99;
    if (!is_straight_)
      return false;
    return std::abs(aside(after.start)) < in_line &&
           back.length() > priors.max_pilaster &&
           along(before).dot(along(after)) > cosine &&
           along(before).dot(along(back)) > cosine &&
           depth() > priors.min_ceiling_step && depth() < priors.max_wall &&
           std::abs(depth() + aside(back.end)) < in_line;
  }

  double depth() const { return -aside(back.start); }

  /** @brief What closes it. */
  PlanElement mouth() const { return straight(before.end, after.start); }

  /** @brief Around it, counter-clockwise; its mouth on the wall that closes it. */
  PlanLoop loop() const
  {
    const PlanElement on = wall();
    const Eigen::Vector2d start = on.pointAt(on.project(before.end));
    const Eigen::Vector2d end = on.pointAt(on.project(after.start));
    return {{straight(start, back.start), straight(back.start, back.end),
             straight(back.end, end), straight(end, start)}};
  }

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

std::vector<PlanNiche>
closeRecesses(PlanRoom& room,
              const PointView& points,
              const std::vector<int>& indices,
              const Priors& priors)
{
  const double wall_low = priors.surface_band;    // above the floor
  const double on_wall = priors.min_ceiling_step; // furniture may be flush with it
  const double near_back = priors.wall_band;
  const double least_depth = priors.min_niche_depth;
  const auto seen = [&](const PlanElement& e, double low, double high, double off) {
    return shareSeen(e, low, high, off, room.floor, points, indices, priors);
  };
  std::vector<PlanNiche> niches;
  std::vector<PlanElement>& elements = room.boundary.elements;
  for (std::size_t i = 0; elements.size() > 6 && i < elements.size(); ++i) {
    const Recess recess(room.boundary, i);
    if (!recess.isOne(priors))
      continue;
    const Eigen::Vector2d& place = recess.back.start;
    const double top = room.ceiling.heightAt(place) - room.floor.heightAt(place);
    const bool is_above_wall =
        seen(recess.mouth(), wall_low, priors.low_wall, on_wall) >= priors.share_half;
    if (!is_above_wall &&
        seen(recess.back, wall_low, top - wall_low, near_back) >= priors.share_unseen)
      continue;
    if (is_above_wall && recess.depth() >= least_depth) {
      const double sill = heightOfSill(recess.mouth(), recess.depth(), on_wall,
                                       room.floor, points, indices, priors);
      // Beside a window, and below and above it, the back is closed.
      if (seen(recess.back, sill + wall_low, top - wall_low, near_back) >=
          priors.share_half)
        niches.push_back({recess.loop(),
                          horizontalSlab(room.floor.heightAt(place) + sill),
                          room.ceiling});
    }
    const PlanElement wall = recess.wall();
    std::rotate(elements.begin(), elements.begin() + static_cast<std::ptrdiff_t>(i),
                elements.end());
    elements.erase(elements.begin(), elements.begin() + 4);
    elements.front() = wall;
    i = static_cast<std::size_t>(-1); // it may end at the next one
  }
  return niches;
}

} // namespace sedr
} // namespace pcl
