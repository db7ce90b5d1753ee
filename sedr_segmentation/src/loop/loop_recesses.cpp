// SPDX-License-Identifier: BSD-3-Clause
#include "loop_recesses.h"

#include "loop_bumps.h"

#include "../niches/niche_fit.h"
#include "../walls/wall_cells.h"
#include "sedr_filters/src/base/middle_value.h"
#include "sedr_filters/src/base/plane_fit.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Share of the 10 cm cells of a vertical rectangle in which a point is on it;
 * a cell at both ends, where other walls are, is left out. A stray or two is none.
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
  WallCells cells(cell, e.length() - cell, low, high, cell);
  double count = 0;
  for (const int i : indices) {
    const WallPoint p = seenFrom(e, floor, points[static_cast<std::size_t>(i)]);
    if (std::abs(p.behind) > tolerance || p.up >= high)
      continue;
    cells.add(p.along, p.up);
    if (p.along >= cell && p.along < e.length() - cell && p.up >= low)
      ++count;
  }
  return count < priors.min_evidence ? 0 : cells.shareSeen();
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
    const WallPoint place = seenFrom(mouth, floor, points[static_cast<std::size_t>(i)]);
    if (!(place.along >= 0) || !(place.along < mouth.length()) || !(place.up >= 0))
      continue;
    if (std::abs(place.behind) <= tolerance)
      on_wall[std::min(on_wall.size() - 1,
                       static_cast<std::size_t>(place.along / strip))]
          .push_back(place.up);
    else if (place.behind > strip / 2 && place.behind < depth - strip / 2)
      behind.push_back(place.up);
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

/** @brief Height of the ceiling before a recess, metres above the floor: the middle of
 * the highest points in strips of 10 cm. Beside a step or below a beam it is lower than
 * the room's. */
double
heightBefore(const PlanElement& mouth,
             double top,
             const PlanSlab& floor,
             const PointView& points,
             const std::vector<int>& indices,
             const Priors& priors)
{
  const double strip = priors.evidence_cell;
  std::vector<double> highest(
      static_cast<std::size_t>(std::ceil(mouth.length() / strip)), 0);
  for (const int i : indices) {
    const WallPoint p = seenFrom(mouth, floor, points[static_cast<std::size_t>(i)]);
    if (p.along >= 0 && p.along < mouth.length() && p.behind < -priors.wall_band &&
        p.behind > -2 * strip && p.up < top + priors.wall_band) {
      double& high = highest[std::min(highest.size() - 1,
                                      static_cast<std::size_t>(p.along / strip))];
      high = std::max(high, p.up);
    }
  }
  highest.erase(std::remove_if(highest.begin(), highest.end(),
                               [&](double high) { return high < top / 2; }),
                highest.end()); // there the ceiling was not seen
  return highest.empty() ? top : std::min(top, middleValue(std::move(highest)));
}

/** @brief Share of the height of a recess at which one of its sides goes on behind its
 * back: a pane and its frame stand within an opening of the wall, whose jambs are
 * deeper. There most points are on the line of the side; of a surface that is parallel
 * to the back twice as many are beside it.
 * @param end metres along the back, of that side */
double
shareGoingOn(const PlanElement& back,
             double end,
             double low,
             double high,
             const PlanSlab& floor,
             const PointView& points,
             const std::vector<int>& indices,
             const Priors& priors)
{
  const double band = priors.wall_band;
  const double strip = 2 * priors.evidence_cell;
  WallCells on(0, strip, low, high, strip);
  WallCells beside(0, strip, low, high, strip);
  for (const int i : indices) {
    const WallPoint p = seenFrom(back, floor, points[static_cast<std::size_t>(i)]);
    const double off = std::abs(p.along - end);
    if (p.behind > band && p.behind <= viewBehind(priors) && p.up < high &&
        off <= 3 * band)
      (off <= band ? on : beside).add(0, p.up);
  }
  const std::size_t count = on.counts().size();
  std::size_t is_side = 0;
  for (std::size_t k = 0; k < count; ++k)
    is_side += on.counts()[k] > beside.counts()[k] ? 1 : 0;
  return static_cast<double>(is_side) /
         static_cast<double>(std::max<std::size_t>(1, count));
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
      , on_wall_(longest().start)
      , way_(along(longest()))
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
    const auto isInLine = [&](const PlanElement& e) {
      return std::abs(aside(e.start)) < in_line && std::abs(aside(e.end)) < in_line &&
             way_.dot(e.end - e.start) > 0;
    };
    return isInLine(before) && isInLine(mouth()) && isInLine(after) &&
           way_.dot(along(back)) > cosine && depth() > priors.min_ceiling_step &&
           depth() < priors.max_wall && std::abs(depth() + aside(back.end)) < in_line;
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

  /** @brief On the line of least squares of the wall beside it: a short stretch tells
   * where the wall is, but not its direction. */
  PlanElement wall() const
  {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    double length = 0;
    for (const PlanElement* e : {&before, &after}) {
      middle += e->length() * (e->start + e->end) / 2;
      length += e->length();
    }
    middle /= length;
    Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
    for (const PlanElement* e : {&before, &after}) {
      const Eigen::Vector2d off = (e->start + e->end) / 2 - middle;
      const Eigen::Vector2d chord = e->end - e->start;
      squares += e->length() * (off * off.transpose() + chord * chord.transpose() / 12);
    }
    const Eigen::Vector2d way =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(squares).eigenvectors().col(1);
    const auto onLine = [&](const Eigen::Vector2d& p) -> Eigen::Vector2d {
      return middle + way.dot(p - middle) * way;
    };
    return straight(onLine(before.start), onLine(after.end));
  }

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

  /** @brief The longest of the stretches of the wall and what closes the recess: a jamb
   * of a few centimetres has an end on the wall, but no direction. */
  PlanElement longest() const
  {
    const PlanElement parts[] = {before, after, mouth()};
    return *std::max_element(std::begin(parts), std::end(parts),
                             [](const PlanElement& a, const PlanElement& b) {
                               return a.length() < b.length();
                             });
  }

  /** @brief How far to the left of the wall a place is. */
  double aside(const Eigen::Vector2d& p) const
  {
    const Eigen::Vector2d to = p - on_wall_;
    return way_.x() * to.y() - way_.y() * to.x();
  }

  bool is_straight_;
  Eigen::Vector2d on_wall_;
  Eigen::Vector2d way_; ///< of the wall
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
  const double min_depth = priors.min_niche_depth;
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
    const double top = heightBefore(
        recess.mouth(), room.ceiling.heightAt(place) - room.floor.heightAt(place),
        room.floor, points, indices, priors);
    const bool is_above_wall =
        seen(recess.mouth(), wall_low, priors.low_wall, on_wall) >= priors.share_half;
    const double head = top - wall_low; // of a door or a window there is a lintel above
    const bool is_below_wall = seen(recess.mouth(), head - priors.evidence_cell, head,
                                    on_wall) >= priors.share_half;
    const auto goesOn = [&](double end) {
      return shareGoingOn(recess.back, end, wall_low, top - wall_low, room.floor,
                          points, indices, priors) >= priors.share_some;
    };
    const bool is_solid =
        seen(recess.back, wall_low, top - wall_low, near_back) >= priors.share_unseen &&
        !(goesOn(0) && goesOn(recess.back.length()));
    const bool is_narrow = recess.back.length() <= priors.max_pilaster;
    if (!is_below_wall && (is_narrow || (!is_above_wall && is_solid)))
      continue;
    if (is_above_wall && recess.depth() >= min_depth) {
      const double sill = heightOfSill(recess.mouth(), recess.depth(), on_wall,
                                       room.floor, points, indices, priors);
      // Beside a window, and below and above it, the back is closed.
      if (seen(recess.back, sill + wall_low, top - wall_low, near_back) >=
          priors.share_half)
        niches.push_back({recess.loop(),
                          horizontalSlab(room.floor.heightAt(place) + sill),
                          room.ceiling});
    }
    PlanElement wall = recess.wall();
    std::rotate(elements.begin(), elements.begin() + static_cast<std::ptrdiff_t>(i),
                elements.end());
    elements.erase(elements.begin(), elements.begin() + 4);
    if (elements.back().isArc())
      wall.start = recess.before.start;
    if (elements[1].isArc())
      wall.end = recess.after.end;
    elements.back().end = wall.start;
    elements[1].start = wall.end;
    elements.front() = wall;
    i = static_cast<std::size_t>(-1); // it may end at the next one
  }
  return niches;
}

std::vector<PlanNiche>
straightenWalls(PlanRoom& room,
                const PointView& points,
                const std::vector<int>& indices,
                double minimum_length,
                const Priors& priors)
{
  std::vector<PlanNiche> niches = closeRecesses(room, points, indices, priors);
  dropBumps(room.boundary, minimum_length);
  for (PlanNiche& niche : closeRecesses(room, points, indices, priors))
    niches.push_back(std::move(niche));
  return niches;
}

} // namespace pcl::sedr
