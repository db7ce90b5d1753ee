// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief Returns whether a loop within a room is an island, surrounded by walls like
 * the core of an office floor, and no column. A column is at most four times as deep as
 * wide and at least three times as high as deep (EN 1992-1-1, 5.3.1). Width and depth
 * are those of the smallest rectangle along one of its sides. */
bool isIsland(const PlanRoom& room, const PlanLoop& column);

/** @brief Returns the boundary of a room, and its islands. */
std::vector<PlanLoop> wallLoops(const PlanRoom& room);

/** @brief A wall face: indices into Floorplan::rooms and into the elements of the
 * room's boundary or of one of its islands. */
struct WallFace {
  std::size_t room = 0;
  std::size_t element = 0;
  std::size_t loop = 0; ///< 0: the boundary; else island `loop - 1` of the columns

  bool operator==(const WallFace& o) const
  {
    return room == o.room && element == o.element && loop == o.loop;
  }
  bool operator<(const WallFace& o) const
  {
    return std::tie(room, loop, element) < std::tie(o.room, o.loop, o.element);
  }
};

/** @brief Returns the loop that a face belongs to. */
const PlanLoop& wallLoop(const Floorplan& plan, const WallFace& face);

const PlanElement& elementOf(const Floorplan& plan, const WallFace& face);

/** @brief Returns all faces of a plan, loop by loop. */
std::vector<WallFace> wallFaces(const Floorplan& plan);

/** @brief Checks whether hardly anything of a face was measured; of islands that is not
 * known. */
bool isGuess(const Floorplan& plan, const WallFace& face);

/** @brief A range along an element: metres from its start. Ends beyond the element lie
 * on its straight continuation. */
struct Stretch {
  double from = 0;
  double to = 0;

  double length() const { return to - from; }
  double middle() const { return (from + to) / 2; }
};

/** @brief From what the thickness of a wall is known. */
enum class ThicknessSource {
  Faces,   ///< both were seen
  Reveals, ///< those of an opening in it, seen from the one face
  Storey,  ///< the reveals of other walls of its storey that lead outside
  Assumed
};

/** @brief A wall: two faces with a thickness, or one with the thickness that reveals
 * show, else an assumed one. It lies behind its face: to the right of the element's
 * direction. */
struct PlanWall {
  WallFace face;
  std::optional<WallFace> other; ///< the opposite face, if it was seen
  Stretch stretch;               ///< on the face's element
  double thickness = 0;          ///< mean, metres
  ThicknessSource source = ThicknessSource::Faces;
  /** @brief Outline of a straight wall: both ends of the face, then the far sides of
   * the end and of the start. Frame: origin at the start of the stretch on the face, x
   * along the face, y into the room. */
  std::array<Eigen::Vector2d, 4> outline{};

  bool isAssumed() const { return source == ThicknessSource::Assumed; }
};

/** @brief Parameters of walls, metres. */
struct WallParameters {
  double max_thickness = Priors().max_wall;          ///< maximum distance of two faces
  double max_depth_at_opening = 1.5 * max_thickness; ///< likewise, beside an opening
  double assumed_thickness = 0.2;                    ///< of a wall with one face seen
  double min_assumed_share = 0.25; ///< of it that is left before a room near behind the
                                   ///< face: 5 cm, the thinnest partition that is built
  double min_thickness = 0.02;     ///< nearer faces have no wall between them
  bool with_touching = false;      ///< nearer faces, overlapping ones too, are pairs
};

/** @brief Finds the walls of a plan from pairs of faces; each part of a face belongs to
 * one wall at most. Faces farther apart than walls usually are belong to one if a
 * opening leads from one to the other.
 *
 * Faces belong to one wall if they are parallel (5 degrees; arcs concentric within 10
 * cm), face away from each other and are nearest to each other. A remainder of a face
 * at the end of such a wall, up to 0.7 m, is where other walls join; the wall is
 * extended over it. Straight walls that meet at a corner of a room are mitred. Faces
 * nearer than the minimum thickness have no wall, nor has a face with another room that
 * near behind it.
 *
 * A reveal that leads outside ends at a pane or at the outer face, so a wall is at
 * least as thick as the deepest of its own, and as the usual one of its storey. Cost:
 * faces squared.
 */
std::vector<PlanWall> findWalls(const Floorplan& plan,
                                const WallParameters& parameters = {});

/** @brief Frame of a straight wall: its origin in plan, and the direction of x. */
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

/** @brief Returns the frame of PlanWall::outline; for a curved wall, at the start of
 * its stretch along its chord. */
WallFrame frameOf(const Floorplan& plan, const PlanWall& wall);

/** @brief Returns the point on a face `s` metres from the start of its element, and the
 * direction into the room there. */
std::pair<Eigen::Vector2d, Eigen::Vector2d> faceAt(const PlanElement& element,
                                                   double s);

/** @brief The faces of a plan that are the two sides of one wall, and the others. */
struct FacePairs {
  std::vector<PlanWall> walls; ///< with both faces, without outlines
  std::vector<PlanWall> free;  ///< unpaired stretches, in the order of the faces
};

/** @brief Pairs faces, the nearest first. Cost: faces squared. */
FacePairs pairFaces(const Floorplan& plan, const WallParameters& parameters);

/** @brief Checks whether any wall of a room is tilted. */
bool isTilted(const PlanRoom& room);

/** @brief Returns a room with the same feet and vertical walls. */
PlanRoom withVerticalWalls(PlanRoom room);

/** @brief Returns a wall of a room at height `z`. It ends where it meets the walls
 * beside it there. */
PlanElement wallAt(const PlanRoom& room, std::size_t wall, double z);

/** @brief Returns the boundary of a room at height `z`, with all walls at their
 * position there. If a wall has no length at that height, the loop crosses itself. */
PlanLoop boundaryAt(const PlanRoom& room, double z);

/** @brief Returns the maximum height of the top of a wall. */
double headOf(const PlanRoom& room, std::size_t wall);

/** @brief Returns the maximum height of the tops of a room's tilted walls. */
double headOf(const PlanRoom& room);

/** @brief Returns the boundary of a room with walls that tilt out of it at their heads
 * and all others at their feet: neither floor nor ceiling reaches farther. */
PlanLoop outermostBoundary(PlanRoom room);

/** @brief Returns the maximum distance of a room's walls from their feet in plan. */
double tiltReach(const PlanRoom& room);

/** @brief Moves the ends of moved elements and their neighbours to where they meet. */
void rejoin(PlanLoop& loop, const std::vector<bool>& is_moved);

} // namespace pcl::sedr
