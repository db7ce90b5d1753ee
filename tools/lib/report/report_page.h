// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/plan_review.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <set>
#include <string>

namespace pcl::sedr::tools {

/** @brief Returns the subjects of the first `most` doubts that a report.json tells. */
std::set<std::string> subjectsIn(const nlohmann::ordered_json& report,
                                 std::size_t most = leading_doubts);

/** @brief Settings of a page. */
struct PageSettings {
  std::string name; ///< of the model; empty: that of the folder
  std::string scan; ///< raw scan; empty: from report.json
  std::string three = "/usr/share/javascript/three"; ///< folder of three.js
  std::size_t max_triangles = 150000;                ///< of the interactive mesh
  double range = 0.05; ///< distance with the last colour, metres
};

/** @brief Makes one self-contained HTML page on a result folder of pcl_sedr: plan,
 * rooms, model, distances, stages, parameters, and advice before using it. The page is
 * page.html with styles, scripts and one JSON in it, and loads nothing. Missing parts
 * are omitted with a note. Throws ToolError if a file cannot be read.
 * @param folder result folder of pcl_sedr */
std::string makePage(const std::string& folder, const PageSettings& settings);

/** @brief Writes the page as report.html into the folder, completely or not at all.
 * @return the path of the file */
std::string writePage(const std::string& folder, const PageSettings& settings);

} // namespace pcl::sedr::tools
