// SPDX-License-Identifier: BSD-3-Clause
/** @file A scene to scan: plain structures, all lengths in metres, angles in radians, z
 * up. Outlines are the loops of segments and arcs of the floor plan; they run
 * counter-clockwise. It is independent of how a scene is meshed or scanned. */
#pragma once

#include "sedr_filters/src/base/plane_fit.h"
#include "sedr_filters/src/plan/plan_geometry.h"
#include "sedr_segmentation/src/shapes/shape_fit.h"
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_types.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace pcl::sedr::sim {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Element = PlanElement;
using Loop = PlanLoop;
using Box2 = Eigen::AlignedBox2d;

constexpr double pi = M_PI;

/** @brief Maximum distance between a curve and the chords or facets that stand for it
 * in the mesh of a scene, metres. */
constexpr double kCurveTolerance = 1e-4;

/** @brief Points of the plan closer than this are the same, metres. */
constexpr double kSamePoint = 1e-6;

/** @brief Returns @p a rotated counter-clockwise by @p angle. */
inline Vec2
rotated(const Vec2& a, double angle)
{
  return Eigen::Rotation2Dd(angle) * a;
}

/** @brief Returns the angle of a vector from x, counter-clockwise. */
inline double
directionOf(const Vec2& v)
{
  return std::atan2(v.y(), v.x());
}

/** @brief Returns the position of @p p in the plan. */
inline Vec2
plan(const Vec3& p)
{
  return p.head<2>();
}

/** @brief Returns @p p at the height @p z. */
inline Vec3
lifted(const Vec2& p, double z)
{
  return {p.x(), p.y(), z};
}

/** @brief Returns a point as " at (x, y)". */
std::string placeText(const Vec2& point);

/** @brief Throws std::invalid_argument with the sentence that the parts make up. */
template <typename... Parts>
[[noreturn]] void
fail(const Parts&... parts)
{
  std::ostringstream text;
  (text << ... << parts);
  throw std::invalid_argument(text.str());
}

/** @brief Returns the arc from @p start to @p end; a segment if @p bulge is 0.
 * @param bulge tan(included angle / 4), positive if the arc turns left */
Element elementBetween(const Vec2& start, const Vec2& end, double bulge = 0.0);

/** @brief Returns a circle of two half circles. */
Loop circleLoop(const Vec2& centre, double radius);

/** @brief Returns the point @p s along an element, @p distance to its right; beyond its
 * ends on the line or circle of the element. */
Vec2 pointBeside(const Element& element, double s, double distance);

/** @brief Returns the element moved by @p distance to its right. */
Element offsetRight(const Element& element, double distance);

/** @brief Returns metres along the element to @p point if that is on it. */
std::optional<double>
locate(const Element& element, const Vec2& point, double tolerance = kSamePoint);

/** @brief Returns where an element is cut into chords: increasing distances along it.
 *
 * These are its ends, @p cuts, and on arcs places whose direction from the centre is a
 * multiple of a fixed step, so that two arcs of one circle are cut at the same
 * places. */
std::vector<double> chordEnds(const Element& element, std::vector<double> cuts = {});

/** @brief Returns the ends of the chords; the outermost are exactly the element's. */
std::vector<Vec2> chordPoints(const Element& element, std::vector<double> cuts = {});

/** @brief Returns a point just inside a loop that runs in either direction. */
Vec2 pointInside(const Loop& loop);

using Label = StructureLabel;

/** @brief A floor or ceiling: a plane. */
using Slab = PlanSlab;

/** @brief Returns the plane higher by a distance. */
inline Slab
raised(Slab slab, double distance)
{
  slab.plane[3] -= slab.plane[2] * distance;
  return slab;
}

/** @brief Returns the rise of a plane in metres per metre along x and y. */
inline Vec2
gradientOf(const Slab& slab)
{
  return -slab.plane.head<2>() / slab.plane[2];
}

/** @brief A rectangle on a wall, behind which there is a space of some depth. */
struct WallGap {
  std::size_t wall = 0; ///< element of the room's outline
  double from = 0.0;    ///< start along the element
  double to = 0.0;      ///< end along the element
  double sill = 0.0;    ///< lower z
  double head = 0.0;    ///< upper z
  double depth = 0.0;   ///< behind the wall's face
};

/** @brief The pane of a window, in the middle of the reveal. */
struct Glazing {
  double return_share = 0.03; ///< share of the rays that end on the pane
  double mirror_share = 0.01; ///< share that is reflected and yields a mirrored point
};

/** @brief The leaf of a door, as large as its opening, or two of half its width. */
struct Leaf {
  std::string hinge = "from"; ///< end of the opening it hangs at: from, to, or both
  double angle = 0.0;         ///< radians into the room; 0: shut
};

/** @brief A door, window or passage, with its reveal; the depth is the thickness of the
 * wall. */
struct Opening : WallGap {
  /// Room behind the wall, whose wall gets the same opening; empty: the
  /// outside.
  std::optional<std::size_t> leads_to = std::nullopt;
  std::optional<Glazing> glazing = std::nullopt;
  std::optional<Leaf> leaf = std::nullopt;
  double rise = 0.0;  ///< of an arched head, half of an ellipse; 0: flat
  double blind = 0.0; ///< share of its height that a blind covers, from the head down
  std::uint32_t number = 0; ///< in the scene, from 1

  /** @brief Returns true if a leaf shuts it. */
  bool isShut() const { return leaf && leaf->angle == 0.0; }
};

/** @brief A hole in a ceiling: a stairwell, an atrium, a missing tile. */
struct CeilingVoid {
  Loop loop;
  /// Room above, whose floor gets the same hole; empty: the plenum of the room
  /// itself.
  std::optional<std::size_t> leads_to = std::nullopt;
};

/** @brief A room: the space enclosed by floor, walls, ceiling and columns.
 *
 * Parts of ceiling and floor are independent of each other. What reaches out of the
 * room is cut off. */
struct Room : PlanRoom {
  std::vector<Opening> openings;
  std::vector<WallGap> wall_niches; ///< with back, sides, bottom and lid
  std::vector<CeilingVoid> voids;
  double plenum = 0.0; ///< height of the closed space above the ceiling; 0: none
  std::optional<std::size_t> storey = std::nullopt; ///< from 1; empty: from its height
};

/** @brief An upright prism over a convex polygon: a box, a cylinder in facets. */
struct Prism {
  std::vector<Vec2> corners; ///< counter-clockwise
  double low = 0.0;
  double high = 0.0;
};

/** @brief An object that is no structure: furniture, a door leaf, a tree, a facade. */
struct Object {
  std::string name{};
  std::vector<Prism> parts{};
};

/** @brief A scanner and its stations.
 *
 * Every station sends its rays at equal steps of azimuth and elevation, as a
 * terrestrial scanner does. A walk with a backpack is a scanner of many stations with
 * few rays each. */
struct Scanner {
  std::vector<Vec3> stations;
  std::size_t rays_per_station = 0;
  double jitter = 0.1; ///< random share of an angular step
  double max_range = 60.0;
  double noise = 0.0; ///< standard deviation along the ray
};

/** @brief The transform from the scene's frame to that of the files. */
struct Placement {
  double yaw = 0.0; ///< degrees about z, applied before the shift
  Vec3 shift = Vec3::Zero();
};

/** @brief A complete scene. */
struct Scene {
  std::string name;
  std::string summary; ///< a one-line description
  std::vector<Room> rooms;
  std::vector<Object> furniture; ///< inside the rooms
  std::vector<Object> outside;   ///< seen through openings
  std::vector<Scanner> scanners;
  Placement placement;
};

/** @brief Returns @p point in the frame of the files. */
inline Vec3
placed(const Placement& placement, const Vec3& point)
{
  return lifted(rotated(plan(point), placement.yaw * pi / 180.0), point.z()) +
         placement.shift;
}

inline Vec2
placed(const Placement& placement, const Vec2& point)
{
  return plan(placed(placement, lifted(point, 0.0)));
}

/** @brief Returns the loop in the frame of the files. */
inline Loop
placed(const Placement& placement, Loop loop)
{
  for (Element& element : loop.elements)
    for (Vec2* point : {&element.start, &element.end, &element.centre})
      *point = placed(placement, *point);
  return loop;
}

/** @brief Returns the number of the room around @p point in the plan, from 1; 0: none.
 *
 * If rooms lie above each other, the one nearest in height is returned. */
std::uint32_t roomAt(const Scene& scene, const Vec3& point);

/** @brief Returns the place of an element of a list, as in "rooms[2]". */
std::string placeOf(const std::string& list, std::size_t index);

/** @brief Returns the part of a wall's face that a gap cuts. */
Element faceOf(const Room& room, const WallGap& gap);

/** @brief Returns the far side of an opening: a part of the wall of the room that it
 * leads to, which runs as that wall does.
 * @throw std::invalid_argument if that room has no wall there */
Element backOf(const Scene& scene, const Room& room, const Opening& opening);

/** @brief Returns the holes in every room's floor: voids that lead to it from below. */
std::vector<std::vector<Loop>> floorVoidsOf(const Scene& scene);

/** @brief A scene file that is part of the simulator's library. */
struct BuiltInScene {
  std::string name;
  std::string text; ///< of its file: see parseScene()
};

/** @brief Parses a scene and checks that it is physically possible.
 *
 * Every room can be meshed: see meshOf(). Scanners are in a room and in no object.
 * @param source the name of the text in messages
 * @throw std::invalid_argument with a sentence about the first fault, which begins with
 * its place, as in "rooms[2].openings[0]" */
Scene parseScene(const std::string& text, const std::string& source);

/** @brief Returns the files of tools/simulator/scenes. */
const std::vector<BuiltInScene>& builtInScenes();

/** @brief Returns all built-in scenes. */
std::vector<Scene> allScenes();

/** @brief Returns the text of a built-in scene, or of a file if the name ends in .json.
 * @throw std::invalid_argument naming the known scenes, or the file */
std::string sceneText(const std::string& name_or_path);

/** @brief Returns a built-in scene, or that of a file if the name ends in .json.
 * @throw std::invalid_argument naming the known scenes, or the fault of the file */
Scene sceneNamed(const std::string& name_or_path);

} // namespace pcl::sedr::sim
