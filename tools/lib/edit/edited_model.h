// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/plan_editor.h>

#include <functional>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Edits a plan; returns what was done, in sentences. */
using EditPlan = std::function<std::vector<std::string>(PlanEditor&)>;

/** @brief Edits the plan in a folder of pcl_sedr and writes all of its files that
 * follow from it, as a set; the plan and the report before are kept as floorplan.json~
 * and report.json~, with more tildes for later ones. Throws ToolError on failure.
 * @return the names of the files that are still those of the scan */
std::vector<std::string> editModel(const std::string& path, const EditPlan& edit);

/** @brief Goes back to the plan and the report that were kept last. */
std::vector<std::string> undoEdit(const std::string& path);

} // namespace pcl::sedr::tools
