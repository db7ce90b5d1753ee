// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/report_data.h"
#include "results/result_folder.h"

#include <string>

namespace pcl::sedr::tools {

// Parts of the page that consist of numbers, as HTML; each is empty without data.

/** @brief Returns rooms, area, volume and accuracy at a glance. */
std::string figuresPart(const ReportData& data);

/** @brief Returns the caveats of the model. */
std::string advicePart(const ReportData& data);

/** @brief Returns the storeys, if there are several. */
std::string storeysPart(const ReportData& data);

/** @brief Returns the plan as a drawing to scale, one per storey. */
std::string planPart(const ReportData& data);

/** @brief Returns the rooms, a table per storey. */
std::string roomsPart(const ReportData& data);

/** @brief Returns how much of the scanned floor was modelled, and what was left out. */
std::string coveragePart(const ReportData& data);

/** @brief Returns histogram and statistics of the distances.
 * @param range distance with the last colour, metres */
std::string histogramPart(const ReportData& data, double range);

/** @brief Returns the files of the folder, with the programs that open them. */
std::string deliverablesPart(const ResultFolder& folder, const ReportData& data);

std::string stagesPart(const ReportData& data);

std::string parametersPart(const ReportData& data);

} // namespace pcl::sedr::tools
