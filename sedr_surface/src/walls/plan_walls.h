// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Whether a loop within a room is an island, so that there are walls around it,
 * as about the core of an office floor, and no column: a column is at most four times
 * as deep as it is wide, and at least three times as high as it is deep (EN 1992-1-1,
 * 5.3.1). Width and depth are those of the smallest rectangle along one of its sides.
 */
bool isIsland(const PlanRoom& room, const PlanLoop& column);

/** @brief The boundary of a room, and its islands. */
std::vector<PlanLoop> wallLoops(const PlanRoom& room);

/** @brief What one room sees of a wall: indices into Floorplan::rooms and into the
 * elements of the room's boundary, or of one of its islands. */
struct WallFace {
  std::size_t room = 0;
  std::size_t element = 0;
  std::size_t loop = 0; ///< 0: the boundary; else of island `loop - 1` of the columns

  bool operator==(const WallFace& o) const
  {
    return room == o.room && element == o.element && loop == o.loop;
  }
  bool operator<(const WallFace& o) const
  {
    return std::tie(room, loop, element) < std::tie(o.room, o.loop, o.element);
  }
};

/** @brief The loop that a face is part of. */
const PlanLoop& wallLoop(const Floorplan& plan, const WallFace& face);

const PlanElement& elementOf(const Floorplan& plan, const WallFace& face);

/** @brief All faces of a plan, loop by loop. */
std::vector<WallFace> wallFaces(const Floorplan& plan);

/** @brief Along an element: metres from its start. Ends beyond those of the element are
 * on its straight continuation. */
struct Stretch {
  double from = 0;
  double to = 0;

  double length() const { return to - from; }
  double middle() const { return (from + to) / 2; }
};

/** @brief A wall: two faces with a thickness, or one and an assumed thickness. It
 * stands behind its face: to the right of the way of the face's element. */
struct PlanWall {
  WallFace face;
  std::optional<WallFace> other; ///< the face of its other side, where one was seen
  Stretch stretch;               ///< of the face's element
  double thickness = 0;          ///< metres; the mean
  /** @brief Of a straight wall: its plan in the frame whose origin is the start of the
   * stretch on the face, x along the face, y into the room: the two ends of the face,
   * then the far sides of the end and of the start. */
  std::array<Eigen::Vector2d, 4> outline{};

  bool isAssumed() const { return !other; }
};

/** @brief What is believed of walls, metres. */
struct WallParameters {
  double assumed_thickness = 0.2; ///< of a wall of which one face was seen
  double greatest_thickness =
      0.6; ///< farther faces are those of two walls, as wallThickness() has it
  double least_thickness = 0.02; ///< nearer faces have no wall between them
};

/** @brief The walls of a plan, from pairs of faces: each face, and each part of one, is
 * of one wall. Faces are of one wall where they are parallel (to 5 degrees; arcs about
 * one centre to 10 cm), face away from each other and are nearest to each other. What
 * remains of a face at an end of such a wall, up to 0.7 m, is where other walls meet
 * it: the wall goes on there. Straight walls that one room sees at a corner are cut at
 * a mitre. Faces nearer than the least thickness have no wall, nor has a face with
 * another room so near behind it; but where a doorway with a lintel leads from one to
 * the other, and one of them is the end of a reveal, the wall is as thick as that is
 * deep.
 * Cost: faces squared. */
std::vector<PlanWall> findWalls(const Floorplan& plan,
                                const WallParameters& parameters = {});

/** @brief The frame of a straight wall: its origin in plan, and the way of its x. */
struct WallFrame {
  Eigen::Vector2d origin;
  Eigen::Vector2d way;

  Eigen::Vector2d left() const { return {-way.y(), way.x()}; }
  Eigen::Vector2d toPlan(const Eigen::Vector2d& p) const
  {
    return origin + p.x() * way + p.y() * left();
  }
  Eigen::Vector2d toLocal(const Eigen::Vector2d& p) const
  {
    return {(p - origin).dot(way), (p - origin).dot(left())};
  }
};

/** @brief Of a straight wall as PlanWall::outline has it; of a curved one at the start
 * of its stretch, along the chord of it. */
WallFrame frameOf(const Floorplan& plan, const PlanWall& wall);

/** @brief A place on the face, `s` metres from the start of its element, and the way
 * into the room there. */
std::pair<Eigen::Vector2d, Eigen::Vector2d> faceAt(const PlanElement& element,
                                                   double s);

} // namespace sedr
} // namespace pcl
