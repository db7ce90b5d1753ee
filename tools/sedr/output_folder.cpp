// SPDX-License-Identifier: BSD-3-Clause
#include "output_folder.h"

#include "tool_error.h"
#include "whole_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace pcl {
namespace sedr {
namespace tools {

namespace fs = std::filesystem;

OutputFolder::OutputFolder(const std::string& path, std::vector<std::string> names)
    : path_(path.empty() ? throw ToolError("the output folder has no name")
                         : fs::absolute(path))
    , names_(std::move(names))
{
  fs::path parent = path_;
  std::error_code error;
  while (!fs::exists(fs::symlink_status(parent, error)) &&
         parent != parent.root_path()) {
    missing_.push_back(parent);
    parent = parent.parent_path();
  }
  if (!fs::is_directory(parent, error))
    refuse("'" + parent.string() + "' is no folder");
  if (access(parent.c_str(), W_OK | X_OK) != 0)
    refuse("'" + parent.string() + "' is not writable: " + std::strerror(errno));
  if (missing_.empty())
    for (const auto& name : names_)
      checkWritable(file(name));
}

void
OutputFolder::spare(const std::string& input) const
{
  std::error_code error; // a file that is missing is equivalent to none
  for (const auto& name : names_)
    if (fs::equivalent(file(name), input, error))
      throw ToolError("'" + input + "' would be written over by the result " + name +
                      ": choose another output folder");
}

void
OutputFolder::fill(const std::function<void()>& write) const
{
  std::error_code error;
  fs::create_directories(path_, error);
  try {
    if (error)
      refuse(error.message());
    write();
  }
  catch (...) {
    if (!missing_.empty())
      for (const auto& name : names_)
        fs::remove(file(name), error);
    for (const auto& folder : missing_)
      fs::remove(folder, error); // only where it is empty
    throw;
  }
}

void
OutputFolder::remove(const std::vector<std::string>& names,
                     const std::string& input) const
{
  std::error_code error;
  for (const auto& name : names) {
    const fs::path path = file(name);
    const bool leads_elsewhere =
        fs::is_symlink(path, error) && fs::is_directory(path, error);
    if (!leads_elsewhere && !fs::equivalent(path, input, error))
      fs::remove(path, error);
  }
}

void
OutputFolder::refuse(const std::string& reason) const
{
  throw ToolError("the output folder '" + path_.string() +
                  "' cannot be written to: " + reason);
}

} // namespace tools
} // namespace sedr
} // namespace pcl
