// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief Returns the names of a solid's elements, "room_1_wall_3", by the number in
 * its triangles. They come from the comments of elementComments() in the header of a
 * PLY file. Empty if there are none. */
std::map<std::uint32_t, std::string> solidNames(const std::string& path);

} // namespace tools
} // namespace sedr
} // namespace pcl
