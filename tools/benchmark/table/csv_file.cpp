// SPDX-License-Identifier: BSD-3-Clause
#include "csv_file.h"

#include "tool_error.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
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

std::vector<RunRow>
readRows(const std::string& path)
{
  std::istringstream lines(wholeLinesOf(path));
  std::string header;
  std::getline(lines, header);
  if (header.compare(0, 6, "scene,") != 0)
    throw ToolError("'" + path +
                    "' is no table of runs: its first column is no 'scene'");
  std::vector<RunRow> rows;
  for (std::string line; std::getline(lines, line);)
    try {
      rows.push_back(rowFromCsv(header, line));
    }
    catch (const std::invalid_argument& error) {
      throw ToolError("'" + path + "', line " + std::to_string(rows.size() + 2) + ": " +
                      error.what());
    }
  return rows;
}

std::vector<RunRow>
rowsToContinue(const std::string& path)
{
  std::error_code error;
  if (!fs::exists(path, error) || wholeLinesOf(path).empty())
    return {};
  const std::string text = wholeLinesOf(path);
  if (text.substr(0, text.find('\n')) != csvHeader())
    throw ToolError("'" + path +
                    "' has other columns than the rows that would be added to it");
  return readRows(path);
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
