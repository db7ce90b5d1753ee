// SPDX-License-Identifier: BSD-3-Clause
#include "scan_parts.h"

#include "bytes/standard_input.h"
#include "joint_scan.h"
#include "tool_error.h"

#include <algorithm>

namespace pcl::sedr::tools {

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
  for (const std::string& path : scanFilesOf(paths)) {
    if (isStandardInput(path))
      throw ToolError(
          "every rank reads the scan, which the standard input cannot serve: "
          "name a file");
    inputs.push_back({path, readScanHead(path, settings), first});
    first += inputs.back().head.rows;
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
  ScanSettings own = settings;
  own.positions.clear();
  if (!settings.positions.empty())
    return ScanFile(inputs.front().path, own)
        .positionsIn(settings.positions, rowsOf(inputs));
  JointPositions joint;
  for (const ScanInput& input : inputs) // sequentially, as some files are unpacked
    joint.add(ScanFile(input.path, own));
  return joint.get();
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

} // namespace pcl::sedr::tools
