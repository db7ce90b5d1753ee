// SPDX-License-Identifier: BSD-3-Clause
#include "csv_file.h"

#include "tool_error.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <system_error>

namespace pcl::sedr::benchmark {

namespace {

using tools::ToolError;
namespace fs = std::filesystem;

/** @brief Returns the text of a file up to the end of its last complete line. */
std::string
wholeLinesOf(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  if (!file || fs::is_directory(path))
    throw ToolError("cannot read '" + path +
                    "': " + (file ? "it is a folder" : std::strerror(errno)));
  std::string text{std::istreambuf_iterator<char>(file),
                   std::istreambuf_iterator<char>()};
  const std::size_t last = text.rfind('\n');
  text.resize(last == std::string::npos ? 0 : last + 1);
  return text;
}

} // namespace

std::vector<std::string>
linesToContinue(const std::string& path)
{
  std::error_code error;
  if (!fs::exists(path, error))
    return {};
  std::istringstream text(wholeLinesOf(path));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);)
    lines.push_back(line);
  if (lines.empty())
    return {};
  if (lines.front() != csvHeader())
    throw ToolError("'" + path +
                    "' has other columns than the rows that would be added to it");
  lines.erase(lines.begin());
  return lines;
}

void
appendRow(const std::string& path, const RunRow& row)
{
  std::error_code error;
  const bool is_there = fs::exists(path, error);
  const std::string lines = is_there ? wholeLinesOf(path) : "";
  if (is_there)
    fs::resize_file(path, lines.size(), error);
  std::ofstream file(path, std::ios::binary | std::ios::app);
  file << (lines.empty() ? csvHeader() + "\n" : "") + toCsv(row) + "\n" << std::flush;
  if (error || !file)
    throw ToolError("cannot write to '" + path +
                    "': " + (error ? error.message() : std::strerror(errno)));
}

} // namespace pcl::sedr::benchmark
