// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Returns the names of columns in a line such as "//X [m],Y [m],Z [m],R,G,B",
 * or an option's value: in lower case, without units and quotes, and those that other
 * programs use as PCL's fields, such as easting as x. */
std::vector<std::string> columnNames(std::string_view line);

/** @brief Returns whether each of x, y and z is there once. */
bool namesCoordinates(const std::vector<std::string>& names);

/** @brief Returns the names that the lines before the first numbers give to `columns`
 * columns; empty if they are only comments or numbers. Throws ToolError if a line can
 * only be names, but not of x, y and z. */
std::vector<std::string> namesBefore(const std::vector<std::string>& lines,
                                     std::size_t columns,
                                     const std::string& path);

} // namespace pcl::sedr::tools
