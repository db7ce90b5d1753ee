// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/priors.h>

#include <string>

namespace pcl::sedr::tools {

/** @brief Returns the priors requested on a command line; throws ToolError if invalid.
 * @param list name=value, separated by commas */
Priors priorsOf(const std::string& list);

/** @brief Returns the priors in use as a text table: value, unit, range, source, place
 * of use. */
std::string explained(const Priors& priors);

} // namespace pcl::sedr::tools
