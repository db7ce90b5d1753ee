// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "opening_weights.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>

#include <pcl/types.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief One side of a wall, as one room has it, led on over bays at its ends that are
 * drawn to their panes. */
struct WallSide {
  std::size_t room = 0;           ///< index into Floorplan::rooms
  PlanElement line;               ///< the room is to its left
  std::size_t element = 0;        ///< of the loop
  int column = -1;                ///< the loop, of the room's columns; -1: its boundary
  bool may_have_openings = false; ///< long enough, and no side of a column
  double floor = 0;               ///< minimum along it, metres
  double ceiling = 0;             ///< maximum along it, metres
  double foot = 0;                ///< height at which its line lies, metres

  bool isWall() const { return column < 0; }

  /** @brief Returns the element of a plan that it is a side of. */
  template <typename Plan>
  auto& in(Plan& plan) const
  {
    auto& of = plan.rooms[room];
    return (isWall() ? of.boundary : of.columns[static_cast<std::size_t>(column)])
        .elements[element];
  }

  /** @brief Returns the distance of a place before (above 0) or behind its line. */
  double offset(const Eigen::Vector2d& p) const;

  /** @brief Returns the level distance of a point before or behind the side, which may
   * be tilted. */
  double offset(const Eigen::Vector3d& p) const
  {
    return offset(Eigen::Vector2d(p.head<2>())) - (p.z() - foot) * std::tan(line.tilt);
  }
};

/** @brief Returns the sides of all walls and columns of a plan. O(sides squared). */
std::vector<WallSide> wallSides(const Floorplan& plan, const OpeningSizes& sizes);

/** @brief What a side behind another one is. */
enum class BehindKind {
  Opposite, ///< it faces away: the other face of the wall
  Own       ///< it belongs to the same room and faces the same way: a bay or niche
};

/** @brief A side behind a place of another one. */
struct SideBehind {
  std::size_t side = 0; ///< index
  double depth = 0;     ///< metres from the place
};

/** @brief Returns the sides of a kind behind a place of a side, at most `max_depth`
 * metres away and a metre or more of them at its heights, by their depths. */
std::vector<SideBehind> sidesBehind(const std::vector<WallSide>& sides,
                                    const WallSide& side,
                                    double along,
                                    BehindKind kind,
                                    double max_depth);

/** @brief The sides behind one side, at steps along it. */
class Backs {
public:
  Backs(const std::vector<WallSide>& sides,
        std::size_t side,
        BehindKind kind,
        double max_depth);

  /** @brief Returns the sides behind a place of any height, by their depths. */
  const std::vector<SideBehind>& at(double along) const;

  /** @brief Returns the nearest side behind a place at a height, of a room above or
   * below where there is none at the height; null: none at all. */
  const SideBehind* at(double along, double height) const;

private:
  const std::vector<WallSide>& sides_;
  std::vector<std::vector<SideBehind>> behind_;
};

/** @brief A rectangle on a map, metres. */
struct WallRectangle {
  double from = 0; ///< along the side
  double to = 0;
  double bottom = 0;
  double top = 0;                     ///< of an arched head: its highest point
  std::array<OpeningEdge, 4> edges{}; ///< from, to, bottom, top
  double rise = 0;                    ///< of an arched head
  double deviation = 0; ///< distance from its edges of 95 % of what shows them
};

/** @brief Returns where the openings of a plan lie on a side. */
std::vector<WallRectangle> openingsOn(const Floorplan& plan, const WallSide& side);

/** @brief A point beside a wall, in metres. */
struct SidePoint {
  float along;
  float height; ///< z
  float offset; ///< before the face, below 0 behind it
};

/** @brief Returns the points of a scan beside each side: up to `before` metres before
 * and `behind` behind it, between floor and ceiling.
 * @param indices of the points to use; null: all */
std::vector<std::vector<SidePoint>> pointsBeside(const std::vector<WallSide>& sides,
                                                 const PointView& points,
                                                 const pcl::Indices* indices,
                                                 double before,
                                                 double behind);

} // namespace pcl::sedr
