// SPDX-License-Identifier: BSD-3-Clause
#include "scan_formats.h"
#include "tool_error.h"

namespace pcl::sedr::tools {

namespace {

/** @brief Opens a file of the format that its content tells; refuses settings that have
 * nothing to act on. */
ScanContent
openByContent(const InputFilePtr& file, const ScanSettings& settings)
{
  const bool is_e57 = looksLikeE57(*file);
  const auto open = looksLikeLas(*file)   ? openLas
                    : looksLikePly(*file) ? openPly
                    : looksLikePcd(*file) ? openPcd
                                          : nullptr;
  if (!is_e57 && (settings.scan > 1 || settings.skip_broken))
    throw ToolError(
        "'" + file->path() + "' is no E57 file and holds one scan: there is " +
        (settings.skip_broken ? "none for --skip-broken"
                              : "no scan " + std::to_string(settings.scan)));
  if ((is_e57 || open) && !settings.columns.empty())
    throw ToolError("'" + file->path() +
                    "' tells its columns itself, --columns names those of a text");
  if (is_e57)
    return openE57(file, settings);
  if (open)
    return open(file);
  if (looksLikeColumns(*file))
    return openText(file, settings.columns);
  throw ToolError("'" + file->path() +
                  "' is neither PCD nor PLY, E57, LAS or columns of numbers");
}

/** @brief Refuses points that cannot be counted, or are none. */
void
checkPoints(const PointReader& points, const std::string& path)
{
  constexpr std::size_t most = 0x7fffffff;
  if (points.size() > most)
    throw ToolError("'" + path + "' promises " + std::to_string(points.size()) +
                    " points, more than " + std::to_string(most) +
                    " cannot be indexed");
  if (points.size() == 0)
    throw ToolError("'" + path + "' has 0 points");
}

} // namespace

ScanContent
openScan(const std::string& path, const ScanSettings& settings)
{
  const auto file = std::make_shared<const InputFile>(path);
  ScanContent content = openByContent(file, settings);
  checkPoints(*content.points, path);
  const auto stations = content.points->stations();
  if (stations.size() == 1) {
    content.viewpoint = stations.front().position;
    content.orientation = stations.front().orientation.cast<float>();
  }
  return content;
}

} // namespace pcl::sedr::tools
