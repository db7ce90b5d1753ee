// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/priors.h>

#include <string>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief The priors that a command line asks for; throws ToolError with what is wrong.
 * @param list name=value, with commas between them; these come after the file's
 * @param path file with a line of name = value for each, # begins a comment; may be
 * empty */
Priors priorsOf(const std::string& list, const std::string& path = {});

/** @brief The priors in use as a table of text: value, unit, range, source, where. */
std::string explained(const Priors& priors);

} // namespace tools
} // namespace sedr
} // namespace pcl
