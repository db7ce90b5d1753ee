// SPDX-License-Identifier: BSD-3-Clause
#include "scan_parts.h"

#include "bytes/standard_input.h"
#include "tool_error.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

namespace pcl {
namespace sedr {
namespace tools {

namespace fs = std::filesystem;

namespace {

bool
isScanName(const fs::path& path)
{
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return extension == ".pcd" || extension == ".ply" || extension == ".e57" ||
         extension == ".las";
}

std::vector<std::string>
scansIn(const std::string& folder)
{
  std::vector<std::string> paths;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    if (isScanName(entry->path()) && !fs::is_directory(entry->path(), error))
      paths.push_back(entry->path().string());
  if (error)
    throw ToolError("cannot read the folder '" + folder + "': " + error.message());
  if (paths.empty())
    throw ToolError("the folder '" + folder + "' has no .pcd, .ply, .e57 or .las file");
  std::sort(paths.begin(), paths.end());
  return paths;
}

} // namespace

std::string
textOf(const std::vector<RowRange>& ranges)
{
  if (ranges.empty())
    return "no rows";
  constexpr std::size_t most = 3;
  const std::size_t named = ranges.size() > most ? most - 1 : ranges.size();
  std::string text;
  for (std::size_t i = 0; i < named; ++i) {
    const RowRange& range = ranges[i];
    text += i == 0 ? "" : i + 1 == ranges.size() ? " and " : ", ";
    text += "rows " + std::to_string(range.begin) + " to " +
            std::to_string(range.end - 1) + " of '" + range.path + "'";
  }
  if (named < ranges.size())
    text += " and those of " + std::to_string(ranges.size() - named) + " more files";
  return text;
}

std::vector<ScanInput>
findInputs(const std::vector<std::string>& paths, const ScanSettings& settings)
{
  std::vector<ScanInput> inputs;
  std::size_t first = 0;
  const auto add = [&](const std::string& path) {
    inputs.push_back({path, readScanHead(path, settings), first});
    first += inputs.back().head.rows;
  };
  for (const std::string& path : paths) {
    if (isStandardInput(path))
      throw ToolError(
          "every rank reads the scan, which the standard input cannot serve: "
          "name a file");
    std::error_code error;
    if (fs::is_directory(path, error))
      for (const std::string& scan : scansIn(path))
        add(scan);
    else
      add(path);
  }
  return inputs;
}

std::size_t
rowsOf(const std::vector<ScanInput>& inputs)
{
  return inputs.empty() ? 0 : inputs.back().first + inputs.back().head.rows;
}

ScanPositions
positionsOf(const std::vector<ScanInput>& inputs, const ScanSettings& settings)
{
  if (inputs.size() > 1 && !settings.positions.empty())
    throw ToolError("--positions is for a scan in one file, there are " +
                    std::to_string(inputs.size()));
  ScanPositions all;
  bool is_any_known = false;
  for (const ScanInput& input : inputs) {
    ScanPositions own = ScanFile(input.path, settings).positions();
    is_any_known = is_any_known || !own.empty();
    if (own.empty())
      own.push_back({0, Eigen::Vector3f::Constant(NAN)});
    for (ScanPosition& position : own) {
      position.first_row += input.first;
      all.push_back(position);
    }
  }
  return is_any_known ? all : ScanPositions();
}

std::vector<std::vector<RowRange>>
dealRows(const std::vector<ScanInput>& inputs, std::size_t ranks)
{
  const std::size_t rows = rowsOf(inputs);
  std::vector<std::size_t> bounds;
  for (std::size_t r = 0; r <= ranks; ++r)
    bounds.push_back(rows / ranks * r + rows % ranks * r / ranks);
  std::vector<std::vector<RowRange>> parts(ranks);
  for (const ScanInput& input : inputs) {
    const std::size_t last = input.first + input.head.rows;
    const std::size_t middle = input.first + input.head.rows / 2;
    for (std::size_t r = 0; r < ranks; ++r) {
      std::size_t begin = std::max(input.first, bounds[r]);
      std::size_t end = std::min(last, bounds[r + 1]);
      if (!input.head.is_in_pieces) {
        const bool is_here = bounds[r] <= middle && middle < bounds[r + 1];
        begin = input.first;
        end = is_here ? last : begin;
      }
      if (begin < end)
        parts[r].push_back({input.path, begin - input.first, end - input.first, begin});
    }
  }
  return parts;
}

} // namespace tools
} // namespace sedr
} // namespace pcl
