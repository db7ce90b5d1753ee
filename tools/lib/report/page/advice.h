// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/report_data.h"

#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief Something to know before the model is trusted, in plain words. */
struct Advice {
  std::string finding; ///< what is so, with numbers
  std::string remedy;  ///< what to look at or which option to turn; may be empty
};

/** @brief What was not seen, what was repaired and how much, what is not closed, what
 * the distances say; then the warnings of the run that say something else. Nothing
 * amiss: nothing. */
std::vector<Advice> adviceOn(const ReportData& data);

/** @brief What would have to be known to say that nothing is amiss, and is not: in a
 * run without a mesh, or without report.json. "whether all rooms are closed, ...";
 * empty if all is known. */
std::string unknownOf(const ReportData& data);

} // namespace tools
} // namespace sedr
} // namespace pcl
