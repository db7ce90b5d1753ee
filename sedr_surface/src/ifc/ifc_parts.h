// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../walls/plan_walls.h"
#include "ifc_document.h"

#include <vector>

namespace pcl {
namespace sedr {
namespace ifc {

/** @brief A wall that stands in the file. */
struct WrittenWall {
  PlanWall wall;
  std::string name;
  std::size_t storey = 0;
  StepRef ref{};
  StepRef placement{}; ///< of its frame, z from its bottom
  double bottom = 0;   ///< metres
  double top = 0;
};

/** @brief A space a room, with quantities. */
void writeSpaces(IfcDocument& document);

/** @brief The walls, with the spaces' boundaries on them. */
std::vector<WrittenWall> writeWalls(IfcDocument& document);

/** @brief Openings of doorways, recesses of niches. */
void writeOpenings(IfcDocument& document, const std::vector<WrittenWall>& walls);

/** @brief Slabs of floors and of ceilings that no room is above. */
void writeSlabs(IfcDocument& document);

/** @brief Columns, coverings, beams, platforms. */
void writeDetails(IfcDocument& document);

/** @brief What a space ends at. */
struct BoundaryKind {
  const char* element = "PHYSICAL"; ///< or "VIRTUAL", where nothing is built
  const char* side = "INTERNAL";    ///< or "NOTDEFINED": the other side was not seen
};

/** @brief A first-level boundary of a space.
 * @param geometry where they meet, or none */
void writeBoundary(IfcDocument& document,
                   std::size_t room,
                   const std::string& element_name,
                   StepRef element,
                   StepRef geometry,
                   const BoundaryKind& kind = {});

/** @brief A vertical rectangle that a space ends at, in the place of its storey.
 * @param from,to its ends in plan, the space to the left of the way */
StepRef rectangleOf(IfcDocument& document,
                    const Eigen::Vector2d& from,
                    const Eigen::Vector2d& to,
                    double bottom,
                    double height);

/** @brief The triangles of a room's solid that are on some of its parts, by the names
 * of SolidElement. */
std::vector<std::size_t> trianglesOn(const IfcRoom& room,
                                     const std::vector<std::string>& names);

/** @brief The name of a room's part: "room_1_wall". */
std::string nameIn(const PlanRoom& room, const std::string& part);

} // namespace ifc
} // namespace sedr
} // namespace pcl
