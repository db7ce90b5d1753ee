// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief What an opening is to be; what is empty stays as it is. Metres. */
struct OpeningChange {
  std::optional<OpeningKind> kind{};
  std::optional<double> width{}; ///< its middle stays
  std::optional<double> height{};
  std::optional<double> sill{};         ///< above the floor, see sillOf()
  std::optional<std::string> leaf{};    ///< left, right, double or none, see leafOf()
  std::optional<std::uint32_t> swing{}; ///< room that the leaf opens into
};

/** @brief Changes a floor plan by hand: valid plans in, valid plans out. Drawings,
 * solid and IFC are made from the changed plan, without the scan.
 *
 * Each call returns false if it cannot be done; the plan is then as before, and
 * getErrorMessage() tells why; getSentence() tells what was done. Openings, stairs and
 * storeys follow: what lost a room leads outside, and what was in a removed wall goes.
 * Walls are numbered from 1, as in drawings ("3.12" is wall 12 of room 3), openings are
 * named by their numbers ("D3"). Lengths in metres. O(elements squared).
 *
 * @code
 * PlanEditor editor(plan);
 * if (!editor.merge(3, 5))
 *   std::cerr << editor.getErrorMessage() << '\n';
 * editor.name(3, "Kitchen");
 * @endcode */
class PlanEditor {
public:
  /** @brief Numbers the openings that have no number, see numberOpenings().
   * @param max_wall maximum thickness of a wall between two rooms, metres */
  explicit PlanEditor(Floorplan plan, double max_wall = Priors().max_wall);

  /** @brief Names a room; an empty text removes its name. */
  bool name(std::uint32_t room, const std::string& text);

  /** @brief Joins the second room to the first, which it touches or is parted from by
   * walls: they are taken out. A floor or ceiling of the second that lies elsewhere
   * becomes a part of that of the first. */
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

  /** @brief Moves a straight wall outwards, or inwards if the distance is below 0.
   * Walls beside it that would run backwards vanish. */
  bool moveWall(std::uint32_t room, std::size_t wall, double distance);

  /** @brief Removes the jog that a wall makes between two parallel ones, of which the
   * shorter moves into the line of the longer; or the notch or bay that it ends. */
  bool removeJog(std::uint32_t room, std::size_t wall);

  /** @brief Adds an opening to a wall.
   * @param at of its middle, from the start of the wall along it
   * @param size has width and height; sill 0 and a door unless given */
  bool addOpening(std::uint32_t room,
                  std::size_t wall,
                  double at,
                  const OpeningChange& size);

  /** @brief Changes an opening, whose confidence is 1 then. */
  bool setOpening(const std::string& number, const OpeningChange& change);

  /** @brief Tells that somebody looked at a wall ("3.12") or an opening ("D3") and it
   * is right: it counts as sure, until it is edited. */
  bool confirm(const std::string& number);

  /** @brief Takes an opening out: the wall is closed there. */
  bool closeOpening(const std::string& number);

  /** @brief Sets z of the floor in the middle of a room, with its slopes; platforms and
   * pits stay. Openings that stood on it still do. */
  bool setFloor(std::uint32_t room, double z);

  /** @brief Sets z of the ceiling likewise; beams, soffits and coffers stay. */
  bool setCeiling(std::uint32_t room, double z);

  /** @brief Moves all rooms of a storey up or down, so that its usual floor, see
   * usualFloor(), has this z; stairs to other storeys get steps of another rise. */
  bool setStorey(std::uint32_t number, double z);

  /** @brief Removes a part of a room, by its name in the solid: "room_3_column_2",
   * "room_3_floor_detail_1" (a platform or pit), "room_3_detail_4" (a beam, soffit or
   * coffer), "room_3_niche_1". Those behind it count one less. What is beside a slope
   * or vault goes on where it was. */
  bool remove(const std::string& part);

  const Floorplan& getFloorplan() const { return plan_; }

  /** @brief Returns why the last call failed; empty after one that did not. */
  const std::string& getErrorMessage() const { return problem_; }

  /** @brief Returns what the last call did, with numbers. */
  const std::string& getSentence() const { return sentence_; }

  /** @brief Returns sentences about the openings and flights of stairs that the last
   * call left out, or longer than their walls, or led through a wall. */
  const std::vector<std::string>& getWarnings() const { return warnings_; }

private:
  /** @brief Applies a change to a copy of the plan, and keeps it if `change` returns no
   * reason against it, outlines of rooms are loops that do not cross, no two rooms
   * overlap more than before, and floorplanFromJson() would read it. */
  bool apply(const std::function<std::string(Floorplan&)>& change);

  /** @brief As above, for a change of a room. */
  bool apply(std::uint32_t room,
             const std::function<std::string(Floorplan&, PlanRoom&)>& change);

  /** @brief As above, for a change of one of its walls. */
  bool
  apply(std::uint32_t room,
        std::size_t wall,
        const std::function<std::string(Floorplan&, PlanRoom&, std::size_t)>& change);

  Floorplan plan_;
  double max_wall_;
  std::string problem_;
  std::string sentence_;
  std::vector<std::string> warnings_;
};

/** @brief Returns what is wrong with an outline: "crosses itself near (1.0, 2.0)", "is
 * clockwise"; empty if nothing. O(elements squared). */
std::string outlineProblem(const PlanLoop& loop);

} // namespace pcl::sedr
