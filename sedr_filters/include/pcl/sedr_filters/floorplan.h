// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/slab_curve.h>
#include <pcl/sedr_filters/structure_label.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief What a scan shows of the surface that stands on an element, in shares of it;
 * all 0 where that was not looked at, or nothing stands there. See measureEvidence().
 */
struct ElementEvidence {
  double seen = 0;    ///< points lie on it
  double hidden = 0;  ///< something stands before it
  double opening = 0; ///< nothing is there: a door, a window

  bool isKnown() const { return seen + hidden + opening > 0; }
};

/** @brief A straight segment or a circular arc of a plan, metres. */
struct PlanElement {
  Eigen::Vector2d start = Eigen::Vector2d::Zero();
  Eigen::Vector2d end = Eigen::Vector2d::Zero();
  Eigen::Vector2d centre = Eigen::Vector2d::Zero(); ///< of an arc
  double radius = 0;             ///< of an arc; 0 says that this is a segment
  bool counter_clockwise = true; ///< sense in which an arc runs from start to end

  std::size_t inliers = 0;  ///< points that the element was fitted to
  double residual = 0;      ///< their root mean square distance from it, metres
  ElementEvidence evidence; ///< what was seen of it

  bool isArc() const { return radius > 0; }

  /** @brief Signed angle an arc runs through, radians, positive counter-clockwise:
   * above 0 and at most 2 pi in size.
   *
   * By design an arc whose ends coincide (to 1e-9 m, or 1e-9 of a radius above 1 m) is
   * a whole circle, never nothing: a round column or a rotunda is a loop of one such
   * arc. An arc that has shrunk to a point therefore has to be taken out of its loop by
   * whoever made it. */
  double sweep() const;

  double length() const;

  /** @brief Point at distance `s` from the start along the element. */
  Eigen::Vector2d pointAt(double s) const;

  /** @brief Unit normal at distance `s`, to the left of the way from start to end. */
  Eigen::Vector2d normalAt(double s) const;

  /** @brief Distance along the element of its point nearest to `p`, within [0,
   * length()]. */
  double project(const Eigen::Vector2d& p) const;

  double distance(const Eigen::Vector2d& p) const;

  /** @brief Whether the element has a point whose normal leads to `p`: of an arc,
   * whether it runs through the direction in which its centre sees `p`. */
  bool isBeside(const Eigen::Vector2d& p) const;

  /** @brief The part of the element between two distances from its start. */
  PlanElement part(double from, double to) const;

  /** @brief Signed area between the element and the chords from the origin, so that
   * those of a closed loop add up to its area. */
  double areaUnder() const;
};

/** @brief A box that holds an element; of an arc, that of its whole circle. */
Eigen::AlignedBox2d boxAround(const PlanElement& element);

/** @brief A closed loop of elements: each ends where the next starts, the last where
 * the first starts. Outer loops run counter-clockwise, loops of columns clockwise: the
 * room is always on the left. */
struct PlanLoop {
  std::vector<PlanElement> elements;

  /** @brief Positive where the loop runs counter-clockwise, square metres. */
  double area() const;

  double length() const;

  /** @brief Whether `p` lies inside, by the winding number; whichever way the loop
   * runs. */
  bool contains(const Eigen::Vector2d& p) const;

  /** @brief Distance of `p` from the nearest element; infinite for an empty loop. */
  double distance(const Eigen::Vector2d& p) const;

  /** @brief Index of the element nearest to `p`. */
  std::size_t nearest(const Eigen::Vector2d& p) const;

  /** @brief Corners in order, arcs replaced by chords that stay within `tolerance`
   * metres (at least 1e-6), but by no more than 10000 chords each. */
  std::vector<Eigen::Vector2d> polygon(double tolerance) const;
};

/** @brief The same loop, run the other way. */
PlanLoop reversed(const PlanLoop& loop);

/** @brief A floor or ceiling, or a part of one: a plane that is not vertical, a x + b y
 * + c z + d = 0 with unit normal, c > 0; or a curve. */
struct PlanSlab {
  Eigen::Vector4d plane = Eigen::Vector4d(0, 0, 1, 0); ///< of a curve, the one nearest
  std::size_t inliers = 0;
  double residual = 0; ///< root mean square distance of the inliers, metres
  double inferred = 0; ///< of a facet: share of its area of which nothing was seen
  std::shared_ptr<const SlabCurve> curve{}; ///< of a vault, a dome; null: a plane

  double heightAt(const Eigen::Vector2d& p) const
  {
    return curve ? curve->heightAt(p)
                 : -(plane[0] * p.x() + plane[1] * p.y() + plane[3]) / plane[2];
  }

  /** @brief Unit normal, upwards. */
  Eigen::Vector3d normalAt(const Eigen::Vector2d& p) const;
};

/** @brief A part of the ceiling at a height of its own: soffit, beam, recess or coffer;
 * or a facet of a ceiling that is not level, such as the slope of a roof. Where details
 * overlap, the later one of a room's list is what is there. */
struct PlanDetail {
  PlanLoop boundary; ///< counter-clockwise
  std::vector<PlanLoop>
      holes; ///< clockwise: a soffit that runs around the room has one
  PlanSlab slab;
  bool is_facet = false; ///< its points are labelled as those of the ceiling

  bool contains(const Eigen::Vector2d& p) const;
};

/** @brief A closed recess in a wall between two heights: it lies outside of the room's
 * boundary, to which it is open along a part of its own. */
struct PlanNiche {
  PlanLoop boundary; ///< counter-clockwise
  PlanSlab bottom;
  PlanSlab top;
};

/** @brief A room: its walls and columns in plan, its floor and its ceiling. */
struct PlanRoom {
  std::uint32_t id = 0; ///< the `room` of its points, from 1
  PlanLoop boundary;    ///< counter-clockwise
  std::vector<PlanLoop> columns;
  PlanSlab floor;
  PlanSlab ceiling;
  std::vector<PlanDetail> details;       ///< of the ceiling, facets first
  std::vector<PlanDetail> floor_details; ///< steps, platforms, pits: parts of the floor
  std::vector<PlanNiche> niches;

  /** @brief Whether its ceiling is more than level planes: a slope, a curve, or facets.
   */
  bool hasFacets() const;

  /** @brief Whether `p` lies in the room: inside the boundary, outside every column. */
  bool contains(const Eigen::Vector2d& p) const;

  /** @brief Index of the detail above `p`, or -1 below the main ceiling. */
  int detailAt(const Eigen::Vector2d& p) const;

  /** @brief The slab of detail `detail`; of -1 the main ceiling. */
  const PlanSlab& ceilingSlab(int detail) const
  {
    return detail < 0 ? ceiling : details[static_cast<std::size_t>(detail)].slab;
  }

  /** @brief Height of whatever ceiling is above `p`. */
  double ceilingAt(const Eigen::Vector2d& p) const;

  /** @brief Index of the floor detail below `p`, or -1 above the main floor. */
  int floorDetailAt(const Eigen::Vector2d& p) const;

  /** @brief The slab of floor detail `detail`; of -1 the main floor. */
  const PlanSlab& floorSlab(int detail) const
  {
    return detail < 0 ? floor : floor_details[static_cast<std::size_t>(detail)].slab;
  }

  /** @brief Height of whatever floor is below `p`. */
  double floorAt(const Eigen::Vector2d& p) const;

  /** @brief Index of the niche around `p`, or -1. */
  int nicheAt(const Eigen::Vector2d& p) const;

  /** @brief Floor area without columns and niches, square metres. */
  double area() const;

  /** @brief Length of the outer loop, metres. */
  double perimeter() const { return boundary.length(); }
};

/** @brief A storey of a building: rooms that one walks between without stairs. */
struct PlanStorey {
  std::uint32_t number = 1;         ///< from the lowest up, from 1
  std::string name = "storey 1";    ///< for people: drawings, tables
  double floor = 0;                 ///< the lowest of its rooms' floors, metres
  double ceiling = 0;               ///< the highest of its rooms' ceilings, metres
  std::vector<std::uint32_t> rooms; ///< PlanRoom::id, increasing
};

/** @brief Where one walks from a room into another one, or out of the building. */
struct PlanDoorway {
  std::array<std::uint32_t, 2> rooms{}; ///< ids of those on its two sides, 0 outside
  Eigen::Vector2d start = Eigen::Vector2d::Zero(); ///< in the middle of the wall
  Eigen::Vector2d end = Eigen::Vector2d::Zero();   ///< likewise
  double bottom = 0;                               ///< metres
  double top = 0;                                  ///< metres

  double width() const { return (end - start).norm(); }
};

/** @brief Where one climbs from a room to one that lies higher. */
struct PlanStair {
  std::array<std::uint32_t, 2> rooms{};         ///< ids of the lower, the upper one
  Eigen::Vector2d at = Eigen::Vector2d::Zero(); ///< in plan
  double bottom = 0;                            ///< metres
  double top = 0;                               ///< metres
};

/** @brief The floor plan: the rooms of a scan (paper, section 2.4 and Figure 7), and
 * how they hang together where that is known. */
struct Floorplan {
  std::vector<PlanRoom> rooms;
  std::vector<PlanStorey> storeys{};   ///< from the lowest up; empty: see storeysOf()
  std::vector<PlanDoorway> doorways{}; ///< those that were found
  std::vector<PlanStair> stairs{};     ///< likewise
};

} // namespace sedr
} // namespace pcl
