// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief A folder of results: asked for before the work, made when there is something
 * to write, and gone again, if it was made here, when writing fails. What cannot be
 * written to is a ToolError. */
class OutputFolder {
public:
  /** @param path it may be missing, and so may the folders above it
   * @param names of the files that will be in it */
  OutputFolder(const std::string& path, std::vector<std::string> names);

  /** @brief Refuses to write over a file that is read. */
  void spare(const std::string& input) const;

  std::string file(const std::string& name) const { return (path_ / name).string(); }

  /** @brief Further files that will be in it. */
  void add(const std::vector<std::string>& names);

  /** @brief The names of the files in it that an expression matches as a whole, in
   * their order; none where there is no folder. */
  std::vector<std::string> filesLike(const std::string& expression) const;

  /** @brief Makes the folder and calls `write`, which fills it. */
  void fill(const std::function<void()>& write) const;

  /** @brief Removes what an earlier run has left: files, and folders that are empty by
   * then, where they are. What the run has read, `input`, stays. */
  void remove(const std::vector<std::string>& names, const std::string& input) const;

private:
  [[noreturn]] void refuse(const std::string& reason) const;

  std::filesystem::path path_;
  std::vector<std::string> names_;
  std::vector<std::filesystem::path> missing_; ///< what must be made, innermost first
};

} // namespace tools
} // namespace sedr
} // namespace pcl
