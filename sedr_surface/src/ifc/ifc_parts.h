// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../walls/plan_area.h"
#include "ifc_document.h"
#include "sedr_filters/src/plan/plan_bounds.h"
#include "sedr_filters/src/plan/plan_segment.h"
#include "sedr_filters/src/walls/plan_walls.h"
#include "wall_body.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace pcl::sedr::ifc {

/** @brief Returns the confidence of a surface, 0 to 1: the share of it that was seen,
 * reduced where points lie off it. A residual of up to 2 cm is normal for scanners and
 * plaster; at twice that the confidence is half of the share.
 * @param seen share; below 0 if unknown, which is then the result
 * @param residual root mean square distance of the points, metres */
inline double
confidence(double seen, double residual)
{
  constexpr double tolerance = 0.02;
  return seen * std::min(1.0, tolerance / std::max(residual, tolerance));
}

/** @brief Returns the confidence of a wall face; -1 if nothing is known of it. */
inline double
confidenceOf(const PlanElement& face)
{
  return face.evidence.isKnown() ? confidence(face.evidence.seen, face.residual) : -1;
}

/** @brief Appends the accuracy of a surface to the properties of an element. */
void appendAccuracy(const SurfaceAccuracy& accuracy, std::vector<Property>& properties);

/** @brief A wall in the file. */
struct WrittenWall {
  PlanWall wall;
  std::string name;
  std::size_t storey = 0;
  WallFrame frame{};
  StepRef ref{};
  StepRef placement{}; ///< of the frame, z from the wall's bottom
  double bottom = 0;   ///< metres
  double top = 0;
  WallHeights heights{};
  std::vector<WallCut> cuts{}; ///< openings and niches in it
  bool is_external = false;
  std::string number{}; ///< on the sheet
  WallRuns runs{};      ///< of a tilted wall
  PlanArea profile{};   ///< in the frame
};

/** @brief Adds a space with quantities for each room. */
void writeSpaces(IfcDocument& document);

/** @brief Adds the walls and the space boundaries on them. */
std::vector<WrittenWall> writeWalls(IfcDocument& document);

/** @brief Returns whether nothing of a wall is left: rooms cover its plan, or an
 * opening takes it from bottom to top. */
bool isWhollyOpen(const Floorplan& plan, const WrittenWall& wall);

/** @brief What an opening takes of a wall, with z from the wall's bottom. */
struct OpeningBox {
  /** @brief In the frame of the wall: that frame itself; in a curved wall, the centre
   * of its arc and the way of the opening. */
  WallFrame frame{Eigen::Vector2d::Zero(), Eigen::Vector2d::UnitX()};
  Eigen::AlignedBox2d plan; ///< in `frame`
  double bottom = 0;
  double top = 0;

  /** @brief Returns the outline in the frame of the wall. */
  PlanLoop loop() const
  {
    PlanLoop loop = loopAround(plan);
    for (PlanElement& e : loop.elements)
      e = segment(frame.toPlan(e.start), frame.toPlan(e.end));
    return loop;
  }
};

/** @brief A gap in a wall that was written. */
struct WrittenGap {
  const WrittenWall* wall = nullptr;
  StepRef opening;
  OpeningBox box;
};

/** @brief Adds an opening of a body to a wall. */
StepRef writeOpening(IfcDocument& document,
                     WrittenWall& wall,
                     const std::string& name,
                     const IfcBody& body,
                     const WallCut& cut);

/** @brief Adds openings, what fills them, and recesses for niches. */
void writeOpenings(IfcDocument& document, std::vector<WrittenWall>& walls);

/** @brief Adds quantities and properties of walls, and their schedule. */
void describeWalls(IfcDocument& document, const std::vector<WrittenWall>& walls);

/** @brief Adds recesses for niches, but for those within gaps of openings. */
void writeNiches(IfcDocument& document,
                 std::vector<WrittenWall>& walls,
                 const std::vector<WrittenGap>& gaps);

/** @brief Adds slabs for floors, and for ceilings without a room above. */
void writeSlabs(IfcDocument& document);

/** @brief Adds columns, coverings, beams and platforms. */
void writeDetails(IfcDocument& document);

/** @brief Adds the stairs whose flights were seen. */
void writeStairs(IfcDocument& document);

/** @brief Adds a first-level boundary of a space, without geometry.
 * @param side "INTERNAL", or "NOTDEFINED" if the other side was not seen
 * @param kind "PHYSICAL", or "VIRTUAL" where nothing is built */
void writeBoundary(IfcDocument& document,
                   std::size_t room,
                   const std::string& element_name,
                   StepRef element,
                   const char* side = "INTERNAL",
                   const char* kind = "PHYSICAL");

/** @brief Returns the triangles of a room's solid that belong to some of its parts, by
 * the names of SolidElement. */
std::vector<std::size_t> trianglesOn(const IfcRoom& room,
                                     const std::vector<std::string>& names);

/** @brief Returns the triangles of a room's floors in plan; those of niches are not
 * floors. None if the body of its space is swept from its plan. */
std::vector<PlanLoop> floorTriangles(const IfcRoom& room);

/** @brief Returns the triangles in plan of the top of a room's solid all corners of
 * which satisfy a condition. */
std::vector<PlanLoop>
topTriangles(const IfcRoom& room,
             const std::function<bool(const Eigen::Vector3d&)>& isTop);

/** @brief Returns the name of a part of a room: "room_1_wall". */
std::string nameIn(const PlanRoom& room, const std::string& part);

} // namespace pcl::sedr::ifc
