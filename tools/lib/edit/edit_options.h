// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"

#include <pcl/sedr_filters/plan_editor.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief The options that change a plan, of pcl_floorplan_edit. */
class EditOptions {
public:
  EditOptions();
  EditOptions(const EditOptions&) = delete;
  EditOptions& operator=(const EditOptions&) = delete;

  void declare(Options& options);

  /** @brief Returns whether any edit is given. */
  bool isGiven() const;

  /** @brief Makes all edits, kind by kind. Throws ToolError with the first that fails.
   * @return what each did, a sentence with numbers */
  std::vector<std::string> apply(PlanEditor& editor);

private:
  /** @brief A kind of edit. */
  struct Kind {
    const char* option;
    const char* help;
    const char* wanted;                     ///< form of an edit
    std::function<bool(std::string&)> read; ///< false: it has another form
    std::function<bool(PlanEditor&, const std::string&)> apply; ///< rest of its text
    std::string given; ///< several, parted by semicolons
  };

  std::vector<Kind> kinds_;
  unsigned a_ = 0; ///< what an edit tells, as are the next ones
  unsigned b_ = 0;
  std::array<double, 1> length_{};
  std::array<double, 4> line_{};
  std::string mark_;
  OpeningChange opening_;
};

} // namespace pcl::sedr::tools
