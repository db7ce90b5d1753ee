// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief Whether a name stands for the standard input: "-". */
inline bool
isStandardInput(const std::string& path)
{
  return path == "-";
}

/** @brief Opens what comes by the standard input as a file that has no name, in TMPDIR
 * or /tmp: it is read to its end once in a process, and gone when that ends. What
 * fails, a terminal too, is a ToolError.
 * @return a descriptor to be closed */
int openStandardInput();

} // namespace tools
} // namespace sedr
} // namespace pcl
