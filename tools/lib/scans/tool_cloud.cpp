// SPDX-License-Identifier: BSD-3-Clause
#include "tool_cloud.h"

#include "run_tool.h"
#include "scan_file.h"

#include <pcl/conversions.h>

#include <cstring>

namespace pcl::sedr::tools {

pcl::Indices
ToolCloud::withLabel(StructureLabel wanted) const
{
  pcl::Indices found;
  for (std::size_t i = 0; i < label.size(); ++i)
    if (label[i] == static_cast<std::uint32_t>(wanted))
      found.push_back(static_cast<pcl::index_t>(i));
  return found;
}

ToolCloud
loadCloud(const std::string& path, const ScanSettings& settings)
{
  const ScanFile file(path, settings);
  ToolCloud cloud;
  cloud.path = path;
  cloud.origin = file.origin();
  auto& blob = cloud.blob;
  blob.fields = file.fields();
  blob.point_step = static_cast<pcl::uindex_t>(file.rowSize());
  blob.height = 1;
  blob.width = static_cast<pcl::uindex_t>(file.size());
  blob.row_step = blob.width * blob.point_step;
  blob.is_dense = 0;
  blob.data.resize(file.size() * file.rowSize());
  file.forEachPiece([&](const RowSource::Piece& piece) {
    std::memcpy(blob.data.data() + piece.first * file.rowSize(), piece.rows,
                piece.size * file.rowSize());
    return true;
  });

  cloud.points.reset(new pcl::PointCloud<pcl::PointXYZ>);
  pcl::fromPCLPointCloud2(blob, *cloud.points);
  cloud.knows_viewpoint = file.knowsViewpoint();
  cloud.points->sensor_origin_ = file.viewpoint();
  cloud.points->sensor_orientation_ = file.orientation();

  cloud.label = wholeField(blob, "label");
  cloud.room = wholeField(blob, "room");
  cloud.has_label = !cloud.label.empty();
  cloud.has_room = !cloud.room.empty();
  cloud.label.resize(blob.width, 0);
  cloud.room.resize(blob.width, 0);
  return cloud;
}

void
warnOfPositions(const ScanFile& scan)
{
  const std::size_t positions = scan.positions().size();
  if (positions > 1)
    warnOnce("the " + std::to_string(positions) + " scanner positions of '" +
             scan.path() + "' are left out: a PCD or PLY has one at most");
}

} // namespace pcl::sedr::tools
