// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstdint>

namespace pcl::sedr {

/** @brief The structural class of a point: the value of the field `label` in files. */
enum class StructureLabel : std::uint32_t {
  Other = 0,
  Ceiling = 1,
  Floor = 2,
  Wall = 3,
  Detail = 4, ///< underside and risers of a soffit, recess, coffer or beam
  Column = 5
};

/** @brief Returns the name of a label in lower case, "other" for unknown values. */
inline const char*
toString(StructureLabel label)
{
  constexpr const char* names[] = {"other", "ceiling", "floor",
                                   "wall",  "detail",  "column"};
  return names[label <= StructureLabel::Column ? static_cast<std::uint32_t>(label) : 0];
}

/** @brief The kind of a vertical surface of a room. */
enum class VerticalKind {
  Wall,           ///< from the floor to the ceiling, or to a niche
  WallAboveNiche, ///< from the top of a niche to the ceiling
  ColumnFace,
  CeilingRiser, ///< between two heights of the ceiling
  FloorRiser,   ///< between two heights of the floor
  NicheSide     ///< a side or the back of a niche
};

/** @brief A point of the structure, in double precision. */
struct SurfacePoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ(); ///< unit, into the room
  StructureLabel label = StructureLabel::Other;
  std::uint32_t room = 0;
};

} // namespace pcl::sedr
