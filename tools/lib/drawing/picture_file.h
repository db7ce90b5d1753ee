// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"
#include "picture.h"
#include "tool_cloud.h"

#include <string>

namespace pcl::sedr::tools {

/** @brief Adds the option `--picture FILE.png` to a stage's program. */
void addPictureOption(Options& options, std::string& path);

/** @brief Throws ToolError if `path` is not empty and cannot be written or does not end
 * in .png. To be called before the work. */
void checkPictureOutput(const std::string& path);

/** @brief The files of a stage's program: a cloud in, one out, and a picture. */
struct StageFiles {
  std::string input;
  std::string output;
  std::string picture;

  /** @brief Declares --picture. */
  void addOptions(Options& options);

  /** @brief Throws ToolError if an output cannot be written. To be called before the
   * work. */
  void check() const;

  void save(const ToolCloud& cloud) const;
};

/** @brief Writes a picture as PNG, completely or not at all. */
void savePicture(const std::string& path, const Picture& picture);

} // namespace pcl::sedr::tools
