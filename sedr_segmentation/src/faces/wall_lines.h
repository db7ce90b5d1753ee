// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief What is at a place along the line of a wall. */
enum class AlongLine : std::uint8_t {
  Surface, ///< a surface was seen
  Gap,     ///< between two parts of the surface: a door, a window
  Lower,   ///< beside a part, the surface goes on below: a window next to a corner
  Ended,   ///< beyond its ends, or in a wide gap
  Nothing  ///< farther away
};

/** @brief The line of the surfaces of walls, normal . p = offset, and what is along it:
 * one value per `cell` metres from `start` on, in the direction (-normal.y, normal.x).
 */
struct WallLine {
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();
  double offset = 0;
  double start = 0;
  double cell = 0.05;
  std::vector<AlongLine> places;
  std::vector<std::uint32_t> owner; ///< room whose surface was seen at each place

  /** @brief Returns the place on the line at a number of cells from its start. */
  Eigen::Vector2d at(double cells) const
  {
    return offset * normal +
           (start + cells * cell) * Eigen::Vector2d(-normal.y(), normal.x());
  }
};

/** @brief Parameters of the search for lines; metres and degrees. */
struct WallLineParameters {
  double cell = 0.05;        ///< of the places along a line; that of the plan's cells
  double tolerance = 0.02;   ///< places this near to a line are on it
  double neighbours = 0.25;  ///< radius in which a place gets its normal
  double min_part = 0.15;    ///< of a surface; shorter parts are strays
  double max_hole = 0.1;     ///< in a part of a surface
  double max_gap = 4;        ///< the widest opening between two parts
  double beyond = 6;         ///< so far a line goes on beyond the ends of its surface
  double min_oblique = 0.6;  ///< part of a line along no main direction
  double snap = 6;           ///< lines this near to a main direction may be along it
  double same_direction = 1; ///< scatter of the directions of lines that are parallel
};

/** @brief Returns the main directions of lines, modulo 90 degrees, radians: at most
 * `most`, each with at least `least` of the weight of the first. */
std::vector<double> mainAngles(const std::vector<double>& angles,
                               const std::vector<double>& weights,
                               std::size_t most,
                               double least);

/** @brief Returns the angle from the nearest of `axes` modulo 90 degrees, radians; a
 * quarter turn without axes. */
double angleOff(double angle, const std::vector<double>& axes);

/** @brief A place on a surface, and the room that sees it. */
struct SurfacePlace {
  Eigen::Vector2d at;
  std::uint32_t room;
};

/** @brief Finds the lines on which the places of surfaces lie. O(places x lines).
 * Deterministic.
 * @param places on surfaces up to the ceiling
 * @param lower centres of cells with surfaces below any sill */
std::vector<WallLine> wallLines(std::vector<SurfacePlace> places,
                                const std::vector<SurfacePlace>& lower,
                                const WallLineParameters& parameters = {});

} // namespace pcl::sedr
