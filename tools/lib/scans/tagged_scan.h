// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "joint_scan.h"

#include <cstdint>
#include <functional>
#include <string>

namespace pcl::sedr::tools {

/** @brief What a point of a scan was found to be. */
struct PointTag {
  std::uint32_t label = 0; ///< StructureLabel
  std::uint32_t room = 0;  ///< of the label, 0 none
  std::uint32_t owner = 0; ///< room whose air the point bounds, 0 none
};

/** @brief Returns the tag of a place in the frame of a scan's rows; thread-safe. */
using TagOf = std::function<PointTag(const Eigen::Vector3f&)>;

/** @brief Throws ToolError if a scan with tags cannot be written at `path`, or its name
 * does not end in .las or .pcd. To be called before the work. */
void checkTaggedOutput(const std::string& path);

/** @brief Writes all points of a scan in their order, each with its tag, while reading
 * it piece by piece; completely or not at all.
 *
 * PCD: all fields of the rows, then `label`, `room` and `owner`. LAS: the class of
 * ASPRS (2 ground, 6 building, 1 else), and label, room and owner as extra bytes. A
 * scan that is LAS keeps all else: version, format, times, returns, flags, coordinate
 * system. Others become LAS 1.4 (format 6, 7 with colours), to 0.1 mm, without points
 * that are not finite, which LAS does not know, with a warning. Throws ToolError on
 * failure.
 * @param threads 0: all processors */
void saveTagged(const std::string& path,
                const JointScan& scan,
                const TagOf& tag_of,
                unsigned threads);

} // namespace pcl::sedr::tools
