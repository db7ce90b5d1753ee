// SPDX-License-Identifier: BSD-3-Clause
#include "output_folder.h"

#include "bytes/whole_file.h"
#include "tool_error.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <regex>
#include <utility>

namespace pcl::sedr::tools {

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
  std::error_code error; // a missing file is equivalent to none
  for (const auto& name : names_)
    if (fs::equivalent(file(name), input, error))
      throw ToolError("'" + input + "' would be written over by the result " + name +
                      ": choose another output folder");
}

void
OutputFolder::add(const std::vector<std::string>& names)
{
  names_.insert(names_.end(), names.begin(), names.end());
}

std::vector<std::string>
OutputFolder::filesLike(const std::string& expression) const
{
  const std::regex wanted(expression);
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(path_, error))
    if (std::regex_match(entry.path().filename().string(), wanted))
      names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
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
      fs::remove(folder, error); // only if it is empty
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

} // namespace pcl::sedr::tools
