// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/report_data.h"

#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief A caveat of the model for users. */
struct Advice {
  std::string finding; ///< observation, with numbers
  std::string remedy;  ///< what to check or which option to change; may be empty
};

/** @brief Returns caveats: parts that were not seen, repaired shares, meshes that are
 * not closed, large distances. Other warnings of the run follow. Empty if there are
 * none. */
std::vector<Advice> adviceOn(const ReportData& data);

/** @brief Returns what is unknown, but required to say that there are no caveats, in a
 * run without a mesh or without report.json. "whether all rooms are closed, ..."; empty
 * if all is known. */
std::string unknownOf(const ReportData& data);

} // namespace pcl::sedr::tools
