// SPDX-License-Identifier: BSD-3-Clause
#include "joint_scan.h"

#include "bytes/whole_file.h"
#include "result_exchange.h"
#include "run_tool.h"
#include "tool_error.h"

#include <pcl/common/io.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace pcl::sedr::tools {

namespace fs = std::filesystem;

namespace {

using Endings = std::vector<const char*>;
const Endings of_scans{".pcd", ".ply", ".e57", ".las", ".xyz", ".pts"};
const Endings of_texts{".csv", ".txt", ".asc"};

bool
hasOneOf(const Endings& extensions, const std::string& path)
{
  return std::any_of(extensions.begin(), extensions.end(), [&](const char* extension) {
    return hasExtension(path, extension);
  });
}

/** @brief Returns the paths of scans in a folder; texts that may be something else only
 * if there are no others. */

std::vector<std::string>
scansIn(const std::string& folder)
{
  std::vector<std::string> paths;
  std::vector<std::string> others;
  const std::vector<std::string> written = writtenFiles(folder);
  std::size_t results = 0;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    if (std::binary_search(written.begin(), written.end(),
                           entry->path().filename().string()))
      ++results;
    else if (!fs::is_directory(entry->path(), error))
      others.push_back(entry->path().string());
  if (error)
    throw ToolError("cannot read the folder '" + folder + "': " + error.message());
  if (results > 0)
    warnOnce("the folder '" + folder + "' has " + std::to_string(results) +
             " files that its report.json lists as results, which are left out");
  for (const Endings& extensions : {of_scans, of_texts})
    if (paths.empty()) {
      const auto scans =
          std::stable_partition(others.begin(), others.end(), [&](const auto& path) {
            return !hasOneOf(extensions, path);
          });
      paths.assign(scans, others.end());
      others.erase(scans, others.end());
    }
  if (paths.empty())
    throw ToolError("the folder '" + folder +
                    "' has no .pcd, .ply, .e57, .las, .xyz, .pts, .csv, .txt or .asc "
                    "file" +
                    (results > 0 ? " but results" : ""));
  std::sort(paths.begin(), paths.end());
  std::sort(others.begin(), others.end());
  if (!others.empty())
    warnOnce("the folder '" + folder + "' has " + std::to_string(others.size()) +
             (others.size() == 1 ? " file" : " files") +
             " of other names, which are left out, the first is '" + others.front() +
             "'; a scan among them can be named by itself");
  return paths;
}

} // namespace

std::vector<std::string>
scanFilesOf(const std::vector<std::string>& paths)
{
  std::vector<std::string> files;
  for (const std::string& path : paths) {
    std::error_code error;
    if (isStandardInput(path) || !fs::is_directory(path, error)) {
      files.push_back(path);
      continue;
    }
    const std::vector<std::string> inside = scansIn(path);
    files.insert(files.end(), inside.begin(), inside.end());
  }
  if (std::count_if(files.begin(), files.end(), isStandardInput) > 1)
    throw ToolError("the standard input can be read only once");
  return files;
}

JointScan::JointScan(const std::vector<std::string>& paths,
                     const ScanSettings& settings)
    : positions_(settings.positions)
{
  ScanSettings own = settings;
  own.positions.clear();
  for (const std::string& path : scanFilesOf(paths)) {
    files_.push_back(std::make_unique<ScanFile>(path, own));
    own.origin = origin(); // one frame for all files
    size_ += files_.back()->size();
  }
  fields_ = files_.front()->fields();
  row_size_ = files_.front()->rowSize();
  if (files_.size() == 1)
    return;
  fields_ = pcl::getFields<pcl::PointXYZ>();
  row_size_ = sizeof(Eigen::Vector3f);
}

void
JointScan::forEachPiece(std::size_t begin,
                        std::size_t end,
                        const std::function<bool(const Piece&)>& see) const
{
  if (files_.size() == 1)
    return files_.front()->forEachPiece(begin, end, see);
  std::vector<Eigen::Vector3f> points;
  std::size_t first = 0;
  bool goes_on = true;
  for (const auto& file : files_) {
    const std::size_t last = first + file->size();
    if (!goes_on || last <= begin || first >= end) {
      first = last;
      continue;
    }
    RowCoordinates coordinates(file->fields(), file->rowSize());
    const std::size_t from = std::max(begin, first) - first;
    file->forEachPiece(from, std::min(end, last) - first, [&](const Piece& piece) {
      const PointView rows = coordinates.of(piece.rows, piece.size);
      points.resize(piece.size);
      for (std::size_t i = 0; i < piece.size; ++i)
        points[i] = rows[i];
      goes_on = see({reinterpret_cast<const std::uint8_t*>(points.data()),
                     first + piece.first, piece.size});
      return goes_on;
    });
    first = last;
  }
}

ScanPositions
JointScan::positions() const
{
  if (!positions_.empty())
    return files_.front()->positionsIn(positions_, size_);
  ScanPositions joint;
  std::size_t first = 0;
  bool is_any_known = false;
  for (const auto& file : files_) {
    ScanPositions own = file->positions();
    is_any_known = is_any_known || !own.empty();
    if (own.empty())
      own.push_back({0, Eigen::Vector3f::Constant(NAN)});
    for (ScanPosition& position : own) {
      position.first_row += first;
      joint.push_back(position);
    }
    first += file->size();
  }
  return is_any_known ? joint : ScanPositions();
}

} // namespace pcl::sedr::tools
