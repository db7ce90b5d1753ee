// SPDX-License-Identifier: BSD-3-Clause
#include "whole_file.h"

#include "tool_error.h"

#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/predicate.hpp>

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace pcl::sedr::tools {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void
refuse(const std::string& path, const std::string& reason)
{
  throw ToolError("cannot write '" + path + "': " + reason);
}

/** @brief Returns the target of a path. Links are followed, so that they stay links. */
fs::path
targetOf(const std::string& path)
{
  std::error_code error;
  const fs::path target = fs::weakly_canonical(path, error);
  return error ? fs::path(path) : target;
}

} // namespace

void
checkWritable(const std::string& path)
{
  if (path.empty())
    throw ToolError("cannot write a file without a name");
  std::error_code error;
  const fs::path target = targetOf(path);
  const fs::path folder =
      target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error))
    refuse(path, "there is no folder '" + folder.string() + "'");
  if (fs::is_directory(target, error))
    refuse(path, "that is a folder");
  if (fs::exists(target, error) && !fs::is_regular_file(target, error))
    refuse(path, "that is no ordinary file");
  if (access(folder.c_str(), W_OK) != 0)
    refuse(path, "the folder is not writable: " + std::string(std::strerror(errno)));
}

bool
hasExtension(const std::string& path, const std::string& extension)
{
  return path.size() > extension.size() && boost::iends_with(path, extension);
}

void
checkOutput(const std::string& path,
            const std::string& what,
            const std::vector<std::string>& extensions)
{
  if (std::none_of(extensions.begin(), extensions.end(),
                   [&](const std::string& one) { return hasExtension(path, one); }))
    refuse(path, "the name of " + what + " ends in " + boost::join(extensions, " or "));
  checkWritable(path);
}

void
writeWhole(const std::string& path, const std::function<void(std::ostream&)>& write)
{
  checkWritable(path);
  const fs::path target = targetOf(path);
  const fs::path beside = target.string() + ".part" + std::to_string(getpid());
  try {
    errno = 0;
    std::ofstream stream(beside, std::ios::binary | std::ios::trunc);
    if (!stream)
      refuse(path, std::strerror(errno));
    write(stream);
    stream.close();
    if (!stream)
      refuse(path, errno != 0 ? std::strerror(errno) : "the disk may be full");
    std::error_code error;
    fs::rename(beside, target, error);
    if (error)
      refuse(path, error.message());
  }
  catch (...) {
    std::error_code ignored;
    fs::remove(beside, ignored);
    throw;
  }
}

void
writeWhole(const std::string& path, const std::string& text)
{
  writeWhole(path, [&](std::ostream& stream) { stream << text; });
}

} // namespace pcl::sedr::tools
