// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/plan_opening.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief The shape of a floor or ceiling that is not a plane. */
enum class CurveKind {
  Cylinder,  ///< upper half of a horizontal cylinder: a barrel vault
  Ellipsoid, ///< upper half of an ellipsoid, axis vertical: dome, spherical cap
  Relief     ///< a grid of heights
};

/** @brief A height field in closed form or on a grid; lengths in metres, z up.
 *
 * @code
 * SlabCurve vault; // a barrel of 2 m radius whose axis runs along x, 1 m up
 * vault.base = 1;
 * vault.across = vault.up = 2;
 * vault.heightAt({5, 0}); // 3
 * @endcode */
struct SlabCurve {
  CurveKind kind = CurveKind::Cylinder;
  Eigen::Vector2d centre =
      Eigen::Vector2d::Zero(); ///< on the axis; relief: first height
  double base = 0;             ///< z of the axis or the centre
  Eigen::Vector2d axis =
      Eigen::Vector2d::UnitX(); ///< unit, in plan; direction of `along`, of a row
  double along = 0;             ///< of an ellipsoid: half extent along `axis`
  double across = 1;            ///< half extent across the axis: the radius
  double up = 1; ///< half extent upwards: the radius if the section is round

  double spacing = 1;          ///< of a relief: distance between its heights
  std::size_t columns = 0;     ///< of a relief: heights in a row, along the axis
  std::vector<double> heights; ///< of a relief: z values, row by row

  /** @brief Returns z at a place in plan. Beside a cylinder or ellipsoid it is `base`,
   * beside a relief the height of its nearest edge. */
  double heightAt(const Eigen::Vector2d& p) const;

  /** @brief Returns the gradient of heightAt(), limited to 1000 where vertical. */
  Eigen::Vector2d gradientAt(const Eigen::Vector2d& p) const;

  /** @brief Returns the distance of a point from the surface, positive above or
   * outside. To first order; exact for a round cylinder and a sphere. */
  double distanceAbove(const Eigen::Vector3d& p) const;

  /** @brief Returns the direction of the axis, radians, counter-clockwise from x. */
  double direction() const { return std::atan2(axis.y(), axis.x()); }

  void setDirection(double radians)
  {
    axis = Eigen::Vector2d(std::cos(radians), std::sin(radians));
  }

  /** @brief Returns the maximum z. */
  double highest() const;

  /** @brief Returns the number of heights of a relief in a column, across the axis. */
  std::size_t rows() const { return columns == 0 ? 0 : heights.size() / columns; }

  /** @brief Checks whether the cross-section is a circle. */
  bool isRound() const { return across == up; }

  /** @brief Checks whether the surface is a spherical cap. */
  bool isSphere() const
  {
    return kind == CurveKind::Ellipsoid && across == up && along == up;
  }

  bool isFinite() const;
};

/** @brief Returns the curve rotated by `angle` radians about the vertical axis through
 * the origin, counter-clockwise, then shifted. */
SlabCurve moved(SlabCurve curve, double angle, const Eigen::Vector3d& shift);

/** @brief The shares of a plan element's surface that a scan shows; all 0 if not
 * measured or if there is no surface. See pcl::OpeningDetection. */
struct ElementEvidence {
  double seen = 0;    ///< share with points on it
  double hidden = 0;  ///< share hidden by something in front of it
  double opening = 0; ///< share where nothing is, such as a door or window

  bool isKnown() const { return seen + hidden + opening > 0; }
};

/** @brief How accurately a scan shows where a surface of a plan is, metres; both 0 if
 * it was not measured, but guessed or set by hand. See levelOfAccuracy(). */
struct SurfaceAccuracy {
  double standard_error = 0; ///< of its place in its middle, across it
  double deviation_95 = 0;   ///< distance within which 95 % of the points beside it lie

  bool isKnown() const { return standard_error > 0; }
};

/** @brief Returns the accuracy of two surfaces together: that of the worse one, none if
 * one was not measured. */
SurfaceAccuracy worse(const SurfaceAccuracy& a, const SurfaceAccuracy& b);

/** @brief A straight segment or a circular arc of a plan, metres. That of a tilted wall
 * is its foot, at the height of the floor's main plane; the wall is a plane on a
 * segment, a cone on an arc. */
struct PlanElement {
  Eigen::Vector2d start = Eigen::Vector2d::Zero();
  Eigen::Vector2d end = Eigen::Vector2d::Zero();
  Eigen::Vector2d centre = Eigen::Vector2d::Zero(); ///< of an arc
  double radius = 0;                                ///< of an arc; 0 for a segment
  bool counter_clockwise = true;                    ///< of an arc, from start to end

  std::size_t inliers = 0;  ///< number of points that the element was fitted to
  double residual = 0;      ///< root mean square distance of these points, metres
  ElementEvidence evidence; ///< shares seen, hidden and open
  SurfaceAccuracy accuracy; ///< of its place
  double tilt = 0; ///< of a wall, radians from the vertical, positive into the room
  bool is_confirmed = false; ///< somebody looked, and it is as the plan has it

  bool isArc() const { return radius > 0; }

  /** @brief Returns the signed angle of an arc, radians, positive counter-clockwise;
   * its magnitude is above 0 and at most 2 pi.
   *
   * By design an arc whose ends coincide (to 1e-9 m, or 1e-9 of a radius above 1 m) is
   * a whole circle. A round column or a rotunda is a loop of one such arc. Code that
   * shrinks an arc to a point must therefore remove it from its loop. */
  double sweep() const;

  double length() const;

  /** @brief Returns the point at distance `s` from the start along the element. */
  Eigen::Vector2d pointAt(double s) const;

  /** @brief Returns the unit normal at distance `s`, to the left of the element. */
  Eigen::Vector2d normalAt(double s) const;

  /** @brief Returns the distance from the start, along the element, of its point
   * nearest to `p`; within [0, length()]. */
  double project(const Eigen::Vector2d& p) const;

  double distance(const Eigen::Vector2d& p) const;

  /** @brief Checks whether the normal of some point of the element passes through `p`.
   * For an arc: whether the direction from its centre to `p` lies within the arc. */
  bool isBeside(const Eigen::Vector2d& p) const;

  /** @brief Returns the part of the element between two distances from its start. */
  PlanElement part(double from, double to) const;

  /** @brief Returns the signed area between the element and the lines from the origin
   * to its ends. The sum over a closed loop is the area of the loop. */
  double areaUnder() const;
};

/** @brief A closed loop of elements: each ends where the next starts, and the last ends
 * where the first starts. Boundaries run counter-clockwise, loops of columns clockwise,
 * so the room is always on the left. */
struct PlanLoop {
  std::vector<PlanElement> elements;

  /** @brief Returns the area, square metres; positive if counter-clockwise. */
  double area() const;

  double length() const;

  /** @brief Checks whether `p` lies inside, by the winding number, for either direction
   * of the loop. */
  bool contains(const Eigen::Vector2d& p) const;

  /** @brief Returns the distance of `p` from the loop; infinite if it is empty. */
  double distance(const Eigen::Vector2d& p) const;

  /** @brief Returns the index of the element nearest to `p`. */
  std::size_t nearest(const Eigen::Vector2d& p) const;

  /** @brief Returns the corners in order. Arcs are replaced by chords that stay within
   * `tolerance` metres (at least 1e-6), at most 10000 chords each. */
  std::vector<Eigen::Vector2d> polygon(double tolerance) const;
};

/** @brief Returns the loop in the opposite direction. */
PlanLoop reversed(const PlanLoop& loop);

/** @brief A floor or ceiling, or a part of one. Either a plane that is not vertical, a
 * x + b y + c z + d = 0 with unit normal and c > 0, or a curve. */
struct PlanSlab {
  Eigen::Vector4d plane = Eigen::Vector4d(0, 0, 1, 0); ///< curve: nearest plane
  std::size_t inliers = 0;
  double residual = 0; ///< root mean square distance of the inliers, metres
  double inferred = 0; ///< share of the area that was not seen
  std::shared_ptr<const SlabCurve> curve{}; ///< shape of a vault or dome; null: a plane
  SurfaceAccuracy accuracy{};               ///< of its place

  double heightAt(const Eigen::Vector2d& p) const
  {
    return curve ? curve->heightAt(p)
                 : -(plane[0] * p.x() + plane[1] * p.y() + plane[3]) / plane[2];
  }

  /** @brief Returns the unit normal, upwards. */
  Eigen::Vector3d normalAt(const Eigen::Vector2d& p) const;
};

/** @brief A part of the ceiling at its own height (soffit, beam, recess or coffer), or
 * a facet of a ceiling that is not level, such as a roof slope. Where details overlap,
 * the later one in the room's list holds. */
struct PlanDetail {
  PlanLoop boundary;           ///< counter-clockwise
  std::vector<PlanLoop> holes; ///< clockwise; of a soffit all around a room
  PlanSlab slab;
  bool is_facet = false; ///< its points have the label of the ceiling

  bool contains(const Eigen::Vector2d& p) const;
};

/** @brief A closed recess in a wall between two heights. It lies outside the boundary
 * of the room and is open to it along a part of its own boundary. */
struct PlanNiche {
  PlanLoop boundary; ///< counter-clockwise
  PlanSlab bottom;
  PlanSlab top;
};

/** @brief A room: walls and columns in plan, floor and ceiling. */
struct PlanRoom {
  std::uint32_t id = 0; ///< value of the field `room` of its points, from 1
  PlanLoop boundary;    ///< counter-clockwise
  std::vector<PlanLoop> columns;
  PlanSlab floor;
  PlanSlab ceiling;
  std::vector<PlanDetail> details;       ///< of the ceiling, facets first
  std::vector<PlanDetail> floor_details; ///< steps, platforms, pits: parts of the floor
  std::vector<PlanNiche> niches;
  std::string name; ///< given by hand, such as "Kitchen"; usually empty

  /** @brief Checks whether the ceiling has a slope, a curve or facets, not only level
   * planes. */
  bool hasFacets() const;

  /** @brief Checks whether `p` lies inside the boundary and outside every column. */
  bool contains(const Eigen::Vector2d& p) const;

  /** @brief Returns the index of the detail above `p`; -1: the main ceiling. */
  int detailAt(const Eigen::Vector2d& p) const;

  /** @brief Returns the slab of a detail; for -1 the main ceiling. */
  const PlanSlab& ceilingSlab(int detail) const
  {
    return detail < 0 ? ceiling : details[static_cast<std::size_t>(detail)].slab;
  }

  /** @brief Returns the height of the ceiling above `p`, details included. */
  double ceilingAt(const Eigen::Vector2d& p) const;

  /** @brief Returns the index of the floor detail below `p`; -1: the main floor. */
  int floorDetailAt(const Eigen::Vector2d& p) const;

  /** @brief Returns the slab of a floor detail; for -1 the main floor. */
  const PlanSlab& floorSlab(int detail) const
  {
    return detail < 0 ? floor : floor_details[static_cast<std::size_t>(detail)].slab;
  }

  /** @brief Returns the height of the floor below `p`, details included. */
  double floorAt(const Eigen::Vector2d& p) const;

  /** @brief Returns the index of the niche that contains `p`, or -1. */
  int nicheAt(const Eigen::Vector2d& p) const;

  /** @brief Returns the floor area without columns and niches, square metres. */
  double area() const;

  /** @brief Returns the length of the boundary, metres. */
  double perimeter() const { return boundary.length(); }
};

/** @brief A storey of a building: rooms connected without stairs. */
struct PlanStorey {
  std::uint32_t number = 1;         ///< from the lowest up, from 1
  std::string name = "storey 1";    ///< for drawings and tables
  double floor = 0;                 ///< minimum floor height of its rooms, metres
  double ceiling = 0;               ///< maximum ceiling height of its rooms, metres
  std::vector<std::uint32_t> rooms; ///< PlanRoom::id, increasing
};

/** @brief A flight of a stair: its risers in plan, from the foot up. Between two of
 * them lies a tread; the last one leads to a landing or a floor. */
struct PlanFlight {
  using Riser = std::array<Eigen::Vector2d, 2>; ///< its left and its right end

  std::vector<Riser> risers; ///< seen by one who climbs
  double bottom = 0;         ///< of the floor or landing at its foot, metres
  double rise = 0;           ///< of each step, metres

  std::size_t steps() const { return risers.size(); }
  double top() const { return bottom + rise * static_cast<double>(steps()); }

  /** @brief The middle of a riser: the line on which one walks. */
  Eigen::Vector2d middle(std::size_t riser) const;

  /** @brief Returns the mean depth of its treads on that line, metres. */
  double going() const;

  /** @brief Returns the outline of its treads, counter-clockwise. */
  std::vector<Eigen::Vector2d> outline() const;
};

/** @brief A stair from a room to a higher one, or within a room. */
struct PlanStair {
  std::array<std::uint32_t, 2> rooms{};         ///< ids of the lower and the upper room
  Eigen::Vector2d at = Eigen::Vector2d::Zero(); ///< in plan
  double bottom = 0;                            ///< metres
  double top = 0;                               ///< metres
  std::vector<PlanFlight> flights{};            ///< from the foot up; none: not seen

  /** @brief Whether it joins two rooms, or two levels of one that were seen. */
  bool leadsSomewhere() const
  {
    return rooms[0] != rooms[1] || (rooms[0] != 0 && !flights.empty());
  }
};

/** @brief The floor plan: the rooms of a scan (paper, section 2.4 and Figure 7), and
 * their connections where known. */
struct Floorplan {
  std::vector<PlanRoom> rooms;
  std::vector<PlanStorey> storeys{};   ///< from the lowest up; empty: see storeysOf()
  std::vector<PlanStair> stairs{};     ///< those that were found
  std::vector<PlanOpening> openings{}; ///< see OpeningDetection
};

/** @brief Returns a room by its id; null if the plan does not have it. */
const PlanRoom* findRoom(const Floorplan& plan, std::uint32_t id);
PlanRoom* findRoom(Floorplan& plan, std::uint32_t id);

/** @brief Returns the plan rotated by `angle` radians about the vertical axis through
 * the origin, counter-clockwise, then shifted. O(elements). */
Floorplan moved(Floorplan plan, double angle, const Eigen::Vector3d& shift);

} // namespace pcl::sedr
