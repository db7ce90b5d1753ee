// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pcl::sedr::tools {

/** @brief Returns whether a name means the standard input: "-". */
inline bool
isStandardInput(const std::string& path)
{
  return path == "-";
}

/** @brief Copies the standard input to an unnamed file in TMPDIR or /tmp, once per
 * process; it vanishes with the process. Throws ToolError on failure or for a terminal.
 * @return a descriptor to be closed */
int openStandardInput();

} // namespace pcl::sedr::tools
