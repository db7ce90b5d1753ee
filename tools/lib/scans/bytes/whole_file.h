// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Throws ToolError if no file can be written at `path`: its folder is missing
 * or read-only, or it is a folder or device. To be called before the work. */
void checkWritable(const std::string& path);

/** @brief Returns whether a file's name ends in `extension`, such as ".ply". */
bool hasExtension(const std::string& path, const std::string& extension);

/** @brief As checkWritable(); throws as well if the name does not end in one of some
 * extensions, which protects scans.
 * @param what "a picture" */
void checkOutput(const std::string& path,
                 const std::string& what,
                 const std::vector<std::string>& extensions);

/** @brief Writes a file completely or not at all: `write` fills a temporary file beside
 * it, which is then renamed. On failure, such as a full disk, throws ToolError and
 * keeps the old file. */
void writeWhole(const std::string& path,
                const std::function<void(std::ostream&)>& write);

/** @brief As above for a text. */
void writeWhole(const std::string& path, const std::string& text);

} // namespace pcl::sedr::tools
