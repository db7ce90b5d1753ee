// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"

#include <pcl/sedr_filters/plan_editor.h>

#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief The options that change a plan, of pcl_floorplan_edit. */
class EditOptions {
public:
  void declare(Options& options);

  /** @brief Returns whether any edit is given. */
  bool isGiven() const;

  /** @brief Makes all edits, kind by kind. Throws ToolError with the first that fails.
   * @return what each did, a sentence with numbers */
  std::vector<std::string> apply(PlanEditor& editor) const;

private:
  std::vector<std::string> given_; ///< by kind; several, parted by semicolons
};

} // namespace pcl::sedr::tools
