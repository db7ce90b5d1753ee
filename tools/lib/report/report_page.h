// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief What a page is made with. */
struct PageSettings {
  std::string scan; ///< the raw scan; empty: as report.json names it
  std::string three = "/usr/share/javascript/three"; ///< folder of three.js
  std::size_t most_triangles = 150000;               ///< of the mesh that can be turned
  double range = 0.05; ///< distance that has the last colour, metres
};

/** @brief One self-contained HTML page on what a run of pcl_sedr has left: plan, rooms,
 * model, distances, stages, parameters, and what to know before trusting it. It loads
 * nothing from anywhere. What is missing in the folder is left out, and told. What
 * cannot be read is a ToolError.
 * @param folder as pcl_sedr left it */
std::string makePage(const std::string& folder, const PageSettings& settings);

/** @brief Writes the page as report.html into the folder, whole or not at all.
 * @return the path of the file */
std::string writePage(const std::string& folder, const PageSettings& settings);

} // namespace tools
} // namespace sedr
} // namespace pcl
