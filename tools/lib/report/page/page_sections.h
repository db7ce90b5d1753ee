// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/report_data.h"
#include "results/result_folder.h"

#include <string>

namespace pcl {
namespace sedr {
namespace tools {

// The parts of the page that need numbers only, as HTML; each empty where nothing is
// known.

/** @brief Rooms, area, volume, accuracy, at a glance. */
std::string figuresPart(const ReportData& data);

/** @brief What to know before the model is trusted. */
std::string advicePart(const ReportData& data);

/** @brief The storeys, where there are several. */
std::string storeysPart(const ReportData& data);

/** @brief The plan as a drawing to scale, one a storey. */
std::string planPart(const ReportData& data);

/** @brief The rooms, a table a storey. */
std::string roomsPart(const ReportData& data);

/** @brief How much of the floor that was seen was modelled, and what was left out. */
std::string coveragePart(const ReportData& data);

/** @brief Histogram and figures of the distances.
 * @param range distance that has the last colour, metres */
std::string histogramPart(const ReportData& data, double range);

/** @brief The files of the folder, with what opens each. */
std::string deliverablesPart(const ResultFolder& folder, const ReportData& data);

std::string stagesPart(const ReportData& data);

std::string parametersPart(const ReportData& data);

} // namespace tools
} // namespace sedr
} // namespace pcl
