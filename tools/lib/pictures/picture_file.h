// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bytes/whole_file.h"
#include "options.h"
#include "picture.h"
#include "tool_cloud.h"

#include <string>

namespace pcl::sedr::tools {

/** @brief The picture that a program is asked for by --picture. */
struct PictureFile {
  std::string path; ///< empty: none

  void declare(Options& options)
  {
    options.text("picture", path, "PNG file for a picture of what was decided");
  }

  /** @brief Throws ToolError if the file cannot be written or does not end in .png. To
   * be called before the work. */
  void check() const;

  /** @brief Writes what `draw` returns, completely or not at all, if it is asked for.
   */
  template <typename Draw>
  void write(Draw draw) const
  {
    if (!path.empty())
      writeWhole(path, draw().png());
  }
};

/** @brief The files of a stage's program: a cloud in, one out, and a picture. */
struct StageFiles {
  std::string input;
  std::string output;
  PictureFile picture;

  /** @brief Declares INPUT, OUTPUT and --picture.
   * @param plan gets PLAN.json, which is between them, if given */
  void declare(Options& options, const std::string& help, std::string* plan = nullptr);

  /** @brief Throws ToolError if an output cannot be written. To be called before the
   * work. */
  void check() const;

  /** @brief Writes the cloud, and the picture of what became of the input.
   * @param reading of the input */
  void save(const ToolCloud& cloud, const ScanSettings& reading = {}) const;
};

} // namespace pcl::sedr::tools
