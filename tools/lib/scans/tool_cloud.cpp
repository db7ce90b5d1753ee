// SPDX-License-Identifier: BSD-3-Clause
#include "tool_cloud.h"
#include "run_tool.h"
#include "scan_file.h"
#include "sedr_filters/src/base/field_access.h"

#include <pcl/common/io.h>
#include <pcl/conversions.h>
#include <pcl/sedr_filters/point_view.h>

#include <cstring>

namespace pcl::sedr::tools {

namespace {

void
setRows(pcl::PCLPointCloud2& blob, std::size_t rows)
{
  blob.height = 1;
  blob.width = static_cast<pcl::uindex_t>(rows);
  blob.row_step = blob.width * blob.point_step;
}

/** @brief Puts a field of a single value, 0, behind the others of every row, in place
 * of one of that name. */
void
replaceField(pcl::PCLPointCloud2& blob, const std::string& name, std::uint8_t datatype)
{
  const pcl::PCLPointCloud2 old = blob;
  blob.fields.clear();
  blob.point_step = 0;
  std::vector<std::size_t> from;
  const auto add = [&](pcl::PCLPointField field) {
    field.offset = blob.point_step;
    blob.point_step +=
        static_cast<pcl::uindex_t>(fieldSize(field.datatype) * field.count);
    blob.fields.push_back(field);
  };
  for (const auto& field : old.fields)
    if (field.name != name) {
      from.push_back(field.offset);
      add(field);
    }
  pcl::PCLPointField added;
  added.name = name;
  added.datatype = datatype;
  added.count = 1;
  add(added);
  blob.data.assign(rowsOf(old) * blob.point_step, 0);
  for (std::size_t i = 0; i < rowsOf(old); ++i)
    for (std::size_t f = 0; f < from.size(); ++f)
      std::memcpy(&blob.data[i * blob.point_step + blob.fields[f].offset],
                  &old.data[i * old.point_step + from[f]],
                  fieldSize(blob.fields[f].datatype) * blob.fields[f].count);
  setRows(blob, rowsOf(old));
}

template <typename ValueT>
void
setTypedField(pcl::PCLPointCloud2& blob,
              const std::string& name,
              std::uint8_t datatype,
              const std::vector<ValueT>& values)
{
  const auto* field = findField(blob, name);
  if (!field || field->datatype != datatype || field->count != 1)
    replaceField(blob, name, datatype);
  const std::size_t offset = findField(blob, name)->offset;
  for (std::size_t i = 0; i < values.size(); ++i)
    std::memcpy(&blob.data[i * blob.point_step + offset], &values[i], sizeof(ValueT));
}

template <typename FunctionT>
void
forEachValue(const pcl::PCLPointCloud2& blob, const std::string& name, FunctionT f)
{
  if (const auto* field = findField(blob, name))
    for (std::size_t i = 0; i < rowsOf(blob); ++i)
      f(readField(&blob.data[i * blob.point_step + field->offset], field->datatype));
}

} // namespace

const pcl::PCLPointField*
findField(const pcl::PCLPointCloud2& blob, const std::string& name)
{
  return pcl::sedr::findField(blob.fields, name);
}

pcl::PCLPointCloud2
selectRows(const pcl::PCLPointCloud2& blob, const pcl::Indices& indices)
{
  pcl::PCLPointCloud2 selected;
  pcl::copyPointCloud(blob, indices, selected);
  return selected;
}

void
appendZeroRows(pcl::PCLPointCloud2& blob, std::size_t count)
{
  const std::size_t rows = rowsOf(blob) + count;
  blob.data.resize(rows * blob.point_step, 0);
  setRows(blob, rows);
}

void
setCoordinates(pcl::PCLPointCloud2& blob,
               std::size_t first_row,
               const std::vector<Eigen::Vector3f>& points)
{
  int axis = 0;
  for (const char* name : {"x", "y", "z"}) {
    const auto* field = findField(blob, name);
    for (std::size_t i = 0; field && i < points.size(); ++i)
      writeField(&blob.data[(first_row + i) * blob.point_step + field->offset],
                 field->datatype, points[i][axis]);
    ++axis;
  }
}

void
setField(pcl::PCLPointCloud2& blob,
         const std::string& name,
         const std::vector<std::uint32_t>& values)
{
  setTypedField(blob, name, pcl::PCLPointField::UINT32, values);
}

void
setField(pcl::PCLPointCloud2& blob,
         const std::string& name,
         const std::vector<float>& values)
{
  setTypedField(blob, name, pcl::PCLPointField::FLOAT32, values);
}

std::vector<std::uint32_t>
wholeField(const pcl::PCLPointCloud2& blob, const std::string& name)
{
  std::vector<std::uint32_t> values;
  forEachValue(blob, name, [&](double value) {
    std::uint32_t whole = 0;
    writeField(reinterpret_cast<std::uint8_t*>(&whole), pcl::PCLPointField::UINT32,
               value);
    values.push_back(whole);
  });
  return values;
}

std::vector<float>
floatField(const pcl::PCLPointCloud2& blob, const std::string& name)
{
  std::vector<float> values;
  forEachValue(blob, name,
               [&](double value) { values.push_back(static_cast<float>(value)); });
  return values;
}

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
