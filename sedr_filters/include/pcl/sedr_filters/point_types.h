// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_types.h>
#include <pcl/register_point_struct.h>

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

} // namespace pcl::sedr

namespace pcl {

struct EIGEN_ALIGN16 _PointStructure {
  PCL_ADD_POINT4D
  PCL_ADD_NORMAL4D
  std::uint32_t label; ///< a pcl::sedr::StructureLabel
  std::uint32_t room;  ///< 0 none, rooms count from 1
  float curvature;
  float padding;
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

/** @brief A point of the reconstructed structure: position and normal (metres, z up,
 * the normal into the room), label and room. */
struct PointStructure : public _PointStructure {
  PointStructure()
  {
    x = y = z = normal_x = normal_y = normal_z = 0.f;
    data[3] = 1.f;
    data_n[3] = 0.f;
    label = room = 0;
    curvature = padding = 0.f;
  }
};

} // namespace pcl

POINT_CLOUD_REGISTER_POINT_STRUCT(
    pcl::_PointStructure,
    (float, x, x)(float, y, y)(float, z, z)(float, normal_x, normal_x)(float,
                                                                       normal_y,
                                                                       normal_y)(
        float,
        normal_z,
        normal_z)(float, curvature, curvature)(std::uint32_t,
                                               label,
                                               label)(std::uint32_t, room, room))
POINT_CLOUD_REGISTER_POINT_WRAPPER(pcl::PointStructure, pcl::_PointStructure)

/** @brief The point types with compiled classes. For any other type with x, y and z
 * include the class's impl/ header. */
#define SEDR_POINT_TYPES                                                               \
  (pcl::PointXYZ)(pcl::PointXYZI)(pcl::PointXYZL)(pcl::PointXYZRGB)(                   \
      pcl::PointXYZRGBA)(pcl::PointNormal)(pcl::PointXYZRGBNormal)(                    \
      pcl::PointStructure)
