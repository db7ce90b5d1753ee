// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../walls/wall_band.h"
#include "sedr_filters/src/walls/plan_walls.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace pcl::sedr::ifc {

/** @brief Returns the closed body between some triangles of a mesh, none of them
 * vertical, and other heights above or below their vertices: a slab on a ceiling, a
 * soffit below it. Its faces are directed outwards. O(n log n).
 * @param triangles indices; none: an empty mesh
 * @param height_at the other height at a vertex, at least a millimetre away and on the
 * same side everywhere */
TriangleMesh prismOn(const TriangleMesh& mesh,
                     const std::vector<std::size_t>& triangles,
                     const std::function<double(const Eigen::Vector3d&)>& height_at);

/** @brief As above between all triangles of a mesh and other heights. */
TriangleMesh prismOn(const TriangleMesh& mesh,
                     const std::function<double(const Eigen::Vector3d&)>& height_at);

/** @brief Returns a mesh with z relative to a height. */
TriangleMesh lowered(TriangleMesh mesh, double height);

/** @brief Returns the height of a slab over a box if it is level to a millimetre. It is
 * sampled, since a curve may be level at the corners only. */
std::optional<double> levelOf(const PlanSlab& slab, const Eigen::AlignedBox2d& box);

/** @brief Returns whether a room's ceiling or a part of it is not level. */
bool hasSlopingCeiling(const PlanRoom& room);

/** @brief Compares the heights of a detail and a slab at the middle of the detail's
 * box.
 * @return 1 if the detail is above, -1 if below, 0 if at the same height */
int sideOf(const PlanDetail& detail, const PlanSlab& slab);

/** @brief The heights of a wall. */
struct WallHeights {
  struct Top {
    double along = 0; ///< share of its length, 0 to 1
    double height = 0;
  };

  double bottom = 0;     ///< of the floor that most of it stands on, metres
  std::vector<Top> tops; ///< two of equal height if it is level
  /** @brief Metres, in the mean, by which it is higher than from floor to ceiling, as
   * beside steps of these. */
  double surplus = 0;

  /** @brief Returns whether the wall has one height along its whole face. */
  bool isLevel() const { return tops.size() == 2 && tops[0].height == tops[1].height; }

  double highest() const;
  double mean() const; ///< from its bottom, along it
  /** @brief Returns the height of the top at a share of the length, on the line between
   * two of `tops`; beyond the ends, that of the end. */
  double topAt(double along) const;
};

/** @brief Returns the height from which on a room below, at a place behind a face, is
 * open to the ceiling before the face. */
double
openHeight(const Floorplan& plan, const WallFace& face, const Eigen::Vector2d& p);

/** @brief A wall and what is around it in plan. */
struct WallSite {
  const Floorplan& plan;
  const PlanWall& wall;
  WallFrame frame;
  PlanArea band;                 ///< between its face and its far side, in the frame
  std::vector<std::size_t> near; ///< rooms whose boxes meet that of the band

  /** @param boxes of the rooms */
  WallSite(const Floorplan& plan,
           const PlanWall& wall,
           const std::vector<Eigen::AlignedBox2d>& boxes);

  /** @brief Returns what a room takes of the plan, in the frame. */
  PlanArea areaOf(const PlanRoom& room) const;
};

struct StandingWall {
  WallSite site;
  WallHeights heights;
};

/** @brief Returns walls with their heights: from the floor that most of a wall stands
 * on, the lower one of both sides, to the higher ceiling beside it, without soffits.
 * Below a sloping ceiling its top slopes too. It ends at the ceilings of rooms below
 * most of it, at the floors of rooms above, as one of its own rooms may reach into the
 * storey of others, and, between two rooms, at walls of others in the same place, as
 * behind a hall. O(walls squared).
 * @param walls of the plan; the result refers to both */
std::vector<StandingWall> standingWalls(const Floorplan& plan,
                                        const std::vector<PlanWall>& walls);

/** @brief How far the sides of a wall are tilted: metres along y for each metre up. */
struct WallRuns {
  double near = 0; ///< of its face
  double far = 0;  ///< of the other side

  /** @brief Returns whether the wall is as thick at any height. */
  bool areAlike() const { return std::abs(near - far) < 0.01; } // half a degree
};

/** @brief Returns the runs of a straight wall. The other side of a wall with one known
 * face is tilted like that. */
WallRuns runsOf(const Floorplan& plan, const PlanWall& wall);

constexpr double no_area =
    0.001; ///< smaller openings and walls are none, square metres
constexpr double min_wall_height = 0.01; ///< lower walls are none, metres

/** @brief What is cut out of a wall between two heights. */
struct WallCut {
  PlanLoop plan; ///< in the frame of the wall, at its bottom if it is tilted
  PlanSlab bottom;
  PlanSlab top;
  bool is_recess = false; ///< not all through the wall
};

/** @brief A wall as a body in its frame, with z from its bottom. */
struct WallBody {
  PlanWall wall;
  WallFrame frame{};
  WallHeights heights{};
  WallRuns runs{};    ///< of a tilted wall
  PlanArea profile{}; ///< its plan in the frame, without rooms

  /** @brief Returns a wall whose top is not level, or with sides of different runs. */
  TriangleMesh mesh(const Floorplan& plan) const;

  /** @brief Returns the volume without cuts, which may overlap and reach beyond the
   * wall, cubic metres. */
  double volume(const Floorplan& plan, const std::vector<WallCut>& cuts) const;
};

} // namespace pcl::sedr::ifc
