// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief Changes a floor plan by hand: valid plans in, valid plans out. Drawings,
 * solid and IFC are made from the changed plan, without the scan.
 *
 * Each call returns false if it cannot be done; the plan is then as before, and
 * getErrorMessage() tells why. Openings, stairs and storeys follow: what lost
 * a room leads outside, and what was in a removed wall goes. Walls are numbered from 1,
 * as in drawings ("3.12" is wall 12 of room 3). Lengths in metres. O(elements squared).
 *
 * @code
 * PlanEditor editor(plan);
 * if (!editor.merge(3, 5))
 *   std::cerr << editor.getErrorMessage() << '\n';
 * editor.name(3, "Kitchen");
 * @endcode */
class PlanEditor {
public:
  explicit PlanEditor(Floorplan plan)
      : plan_(std::move(plan))
  {}

  /** @brief Names a room; an empty text removes its name. */
  bool name(std::uint32_t room, const std::string& text);

  /** @brief Joins the second room to the first: the longest straight wall between them
   * is taken out, the floor and the ceiling are those of the first. */
  bool merge(std::uint32_t room, std::uint32_t other);

  /** @brief Parts a room by the line from one place to another, which must cross its
   * outline twice. The part to the right of the line gets the first unused number. */
  bool
  split(std::uint32_t room, const Eigen::Vector2d& from, const Eigen::Vector2d& to);

  /** @brief Removes a room. */
  bool drop(std::uint32_t room);

  /** @brief Makes walls that are parallel or perpendicular to the longest one within 10
   * degrees exactly so; they turn about their middles, arcs stay. */
  bool square(std::uint32_t room);

  /** @brief Moves a straight wall outwards, or inwards if the distance is below 0. */
  bool moveWall(std::uint32_t room, std::size_t wall, double distance);

  /** @brief Says what the opening of a room is whose middle is nearest to a place, at
   * most a metre from it: a door, a window or a passage; its confidence is 1 then. */
  bool setOpening(std::uint32_t room, const Eigen::Vector2d& place, OpeningKind kind);

  /** @brief Takes such an opening out: the wall is closed there. */
  bool closeOpening(std::uint32_t room, const Eigen::Vector2d& place);

  const Floorplan& getFloorplan() const { return plan_; }

  /** @brief Returns why the last call failed; empty after one that did not. */
  const std::string& getErrorMessage() const { return problem_; }

  /** @brief Returns sentences about the openings and flights of stairs that the last
   * call left out, or longer than their walls, or led through a wall. */
  const std::vector<std::string>& getWarnings() const { return warnings_; }

private:
  /** @brief Applies a change to a copy of the plan, and keeps it if `change` returns no
   * reason against it and the outlines of rooms are loops that do not cross. */
  bool apply(std::uint32_t room,
             const std::function<std::string(Floorplan&, PlanRoom&)>& change);

  Floorplan plan_;
  std::string problem_;
  std::vector<std::string> warnings_;
};

/** @brief Returns what is wrong with an outline: "crosses itself near (1.0, 2.0)", "is
 * clockwise"; empty if nothing. O(elements squared). */
std::string outlineProblem(const PlanLoop& loop);

} // namespace pcl::sedr
