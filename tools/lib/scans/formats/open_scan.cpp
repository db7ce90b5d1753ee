// SPDX-License-Identifier: BSD-3-Clause
#include "run_tool.h"
#include "scan_formats.h"
#include "sedr_filters/src/base/parallel.h"
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

RecordReader::RecordReader(std::shared_ptr<const InputFile> file,
                           const Records& records)
    : file_(std::move(file))
    , begin_(records.begin)
    , is_big_endian_(records.is_big_endian)
{
  row_ = records.row;
  size_ = records.points;
  if (row_.size == 0) // which lacks x, as is told later
    return;
  const std::uint64_t bytes = records.end - records.begin;
  const auto refuse = [&](const std::string& reason) {
    throw ToolError("cannot read '" + file_->path() + "' as " + records.format + ": " +
                    reason + "its header promises " + std::to_string(size_) +
                    " points of " + std::to_string(row_.size) + " bytes, but " +
                    std::to_string(bytes) + " bytes follow");
  };
  if (size_ > bytes / row_.size)
    refuse("the file is cut off, ");
  const std::uint64_t surplus = bytes - size_ * row_.size;
  if (!records.are_last || size_ == 0 || surplus < row_.size)
    return;
  if (surplus % row_.size == 0)
    refuse("");
  warnOnce("'" + file_->path() + "' has " + std::to_string(surplus) +
           " bytes behind its points, which are left out; no whole number of points "
           "of " +
           std::to_string(row_.size) + " bytes");
}

void
RecordReader::read(Chunk& chunk) const
{
  constexpr std::size_t rows_at_once = std::size_t{1} << 14;
  chunk.rows.resize(chunk.size * row_.size);
  file_->read(begin_ + chunk.first * row_.size, chunk.rows.size(), chunk.rows.data());
  if (is_big_endian_)
    parallelFor(chunk.size, rows_at_once, 0, [&](std::size_t i) {
      for (const StoredField& field : row_.fields) {
        auto* const first = &chunk.rows[i * row_.size + field.offset];
        std::reverse(first, first + fieldSize(field.datatype));
      }
    });
}

} // namespace pcl::sedr::tools
