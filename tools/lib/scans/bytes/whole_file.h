// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <ostream>
#include <string>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief Throws a ToolError, one sentence, if no file can be written at `path`: its
 * folder is missing or read-only, or it is a folder or device itself. To be asked
 * before the work. */
void checkWritable(const std::string& path);

/** @brief Writes a file whole or not at all: `write` fills a file beside it, which is
 * then renamed. Whatever fails, a full disk too, is a ToolError, and the old file
 * stays. */
void writeWhole(const std::string& path,
                const std::function<void(std::ostream&)>& write);

} // namespace tools
} // namespace sedr
} // namespace pcl
