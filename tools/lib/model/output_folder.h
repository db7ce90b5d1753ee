// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief A result folder. It is checked before the work, created when there is
 * something to write, and removed again if it was created here and writing fails.
 * Throws ToolError if it cannot be written. */
class OutputFolder {
public:
  /** @param path may be missing, including parent folders
   * @param names of the files that will be written */
  OutputFolder(const std::string& path, std::vector<std::string> names);

  /** @brief Throws ToolError if a file to be written is the input. */
  void spare(const std::string& input) const;

  std::string file(const std::string& name) const { return (path_ / name).string(); }

  /** @brief Adds names of files that will be written. */
  void add(const std::vector<std::string>& names);

  /** @brief Returns the sorted names of files that match a regular expression
   * completely; none if there is no folder. */
  std::vector<std::string> filesLike(const std::string& expression) const;

  /** @brief Creates the folder and calls `write`, which fills it. */
  void fill(const std::function<void()>& write) const;

  /** @brief Removes files of an earlier run, except `input`, and folders that become
   * empty. */
  void remove(const std::vector<std::string>& names, const std::string& input) const;

private:
  [[noreturn]] void refuse(const std::string& reason) const;

  std::filesystem::path path_;
  std::vector<std::string> names_;
  std::vector<std::filesystem::path> missing_; ///< folders to create, innermost first
};

} // namespace pcl::sedr::tools
