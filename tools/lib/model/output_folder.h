// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <csignal>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace pcl::sedr::tools {

/** @brief A result folder whose files are exchanged as a set: they are written into a
 * hidden folder within it and moved at the end, while interrupts wait. An interrupted
 * run removes the hidden folder and says so; what a run that was killed has left of it
 * is removed by the next run or, if the exchange had begun, moved. Only one run at a
 * time; a second one is refused. Throws ToolError if the folder cannot be written. */
class OutputFolder {
public:
  /** @param path may be missing, including parent folders; removed again if nothing is
   * put into it
   * @param inputs files that stay as they are */
  OutputFolder(const std::string& path, std::vector<std::string> inputs);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /** @brief Throws ToolError if a file with one of these names cannot be replaced: it
   * is an input, or a folder. To be called before the work. */
  void check(const std::vector<std::string>& names) const;

  /** @brief Returns where to write a file; its name may begin with a folder. */
  std::string file(const std::string& name) const;

  /** @brief Returns the sorted names of the files written and not yet moved. */
  std::vector<std::string> written() const;

  /** @brief Moves all files into the folder, and removes those of an earlier run, which
   * its report.json lists, except inputs; a plan that was edited since is kept.
   * @param removed names of others to remove */
  void exchange(std::vector<std::string> removed = {});

private:
  void lock();
  void clean() const;
  void startAwaiting(const sigset_t& awaited);
  void awaitInterrupt(sigset_t awaited);
  bool isInput(const std::filesystem::path& file) const;
  void removeHidden() const;

  std::filesystem::path path_;
  std::filesystem::path part_; ///< the hidden folder
  std::vector<std::string> inputs_;
  std::vector<std::filesystem::path> missing_; ///< folders created, innermost first
  int lock_ = -1;
  sigset_t blocked_before_{};
  std::mutex moving_;     ///< held while files are moved, or removed
  bool is_moved_ = false; ///< or will be by the next program
  std::thread interrupts_;
};

} // namespace pcl::sedr::tools
