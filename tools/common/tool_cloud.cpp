// SPDX-License-Identifier: BSD-3-Clause
#include "tool_cloud.h"

#include "cloud_readers.h"
#include "tool_error.h"

#include <pcl/sedr_filters/field_access.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <sstream>

namespace pcl {
namespace sedr {
namespace tools {

namespace {

constexpr double float_step = 1.0 / (1 << 23); // between floats, relative
constexpr double coarsest = 0.001;             // metres

void
checkCoordinates(const pcl::PCLPointCloud2& blob, const std::string& path)
{
  std::string names;
  for (const auto& field : blob.fields)
    names += " " + field.name;
  for (const char* name : {"x", "y", "z"})
    if (!findField(blob, name))
      throw ToolError("'" + path + "' has no field '" + name +
                      "', its fields are:" + names);
}

/** @brief Leaves out padding and turns x, y and z into FLOAT32 metres, scaled as
 * doubles. */
void
tidyFields(pcl::PCLPointCloud2& blob, const std::string& path, double unit)
{
  pcl::PCLPointCloud2 tidy;
  std::vector<pcl::PCLPointField> sources;
  std::vector<bool> is_converted;
  bool is_tidy = true;
  for (const auto& field : blob.fields) {
    const bool is_coordinate =
        field.name == "x" || field.name == "y" || field.name == "z";
    const bool converts =
        is_coordinate && (unit != 1 || field.datatype != pcl::PCLPointField::FLOAT32 ||
                          field.count != 1);
    is_tidy = is_tidy && field.name != "_" && !converts;
    if (field.name == "_")
      continue;
    sources.push_back(field);
    is_converted.push_back(converts);
    tidy.fields.push_back(field);
    if (converts) {
      tidy.fields.back().datatype = pcl::PCLPointField::FLOAT32;
      tidy.fields.back().count = 1;
    }
  }
  if (is_tidy)
    return;
  layOut(tidy, blob.width, path);
  tidy.data.assign(std::size_t{tidy.width} * tidy.point_step, 0);
  for (std::size_t i = 0; i < tidy.width; ++i)
    for (std::size_t f = 0; f < sources.size(); ++f) {
      const auto& to = tidy.fields[f];
      const auto* from = &blob.data[i * blob.point_step + sources[f].offset];
      auto* where = &tidy.data[i * tidy.point_step + to.offset];
      if (is_converted[f])
        writeField(where, to.datatype, unit * readField(from, sources[f].datatype));
      else
        std::memcpy(where, from, fieldSize(to.datatype) * to.count);
    }
  blob = std::move(tidy);
}

/** @brief The middle one of some numbers. */
double
median(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/** @brief Whether heights spread, but for a hundredth at each end, over more metres
 * than any building has. */
bool
couldBeMillimetres(std::vector<double> heights)
{
  constexpr double highest = 200;
  std::sort(heights.begin(), heights.end());
  const std::size_t cut = heights.size() / 100;
  return heights[heights.size() - 1 - cut] - heights[cut] > highest;
}

/** @brief Refuses clouds without a finite point, and those that lie, but for stray
 * points, too far from the origin for a float of metres. */
void
checkExtent(const pcl::PCLPointCloud2& blob, const std::string& path, double unit)
{
  std::array<std::vector<double>, 4> values; // x, y, z and the largest of their sizes
  std::array<const pcl::PCLPointField*, 3> xyz{
      findField(blob, "x"), findField(blob, "y"), findField(blob, "z")};
  const std::size_t stride = std::max<std::size_t>(1, blob.width / 100000);
  std::size_t finite = 0;
  for (std::size_t i = 0; i < blob.width; ++i) {
    std::array<double, 3> p{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      p[axis] = unit * readField(&blob.data[i * blob.point_step + xyz[axis]->offset],
                                 xyz[axis]->datatype);
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
      continue;
    if (finite++ % stride != 0)
      continue;
    for (std::size_t axis = 0; axis < 3; ++axis)
      values[axis].push_back(p[axis]);
    values[3].push_back(std::max({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])}));
  }
  if (finite == 0)
    throw ToolError("'" + path + "' has no finite point among its " +
                    std::to_string(blob.width));
  const double size = median(values[3]);
  if (size * float_step <= coarsest)
    return;
  if (unit == 1 && couldBeMillimetres(values[2]))
    throw ToolError(
        "the coordinates of '" + path +
        "' are too large for metres; if the unit is the millimetre, scale by "
        "0.001 (--unit 0.001 in pcl_sedr)");
  std::ostringstream sentence;
  sentence.precision(2);
  sentence << "the coordinates of '" << path << "' are too large: at "
           << static_cast<long long>(std::min(size, 1e18))
           << " m a float resolves no finer than " << size * float_step * 1000
           << " mm; subtract an origin first, say (";
  for (std::size_t axis = 0; axis < 3; ++axis)
    sentence << (axis > 0 ? ", " : "")
             << static_cast<long long>(std::clamp(
                    std::round(median(values[axis]) / 1000) * 1000, -1e18, 1e18));
  throw ToolError(sentence.str() + ") m");
}

} // namespace

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
loadCloud(const std::string& path, double unit)
{
  const MappedFile file(path);
  if (!looksLikePly(file) && !looksLikePcd(file))
    throw ToolError("'" + path + "' is neither a PCD nor a PLY file");
  FileCloud loaded = looksLikePly(file) ? readPly(file, path) : readPcd(file, path);

  ToolCloud cloud;
  cloud.path = path;
  cloud.blob = std::move(loaded.blob);
  auto& blob = cloud.blob;
  checkCoordinates(blob, path);
  checkExtent(blob, path, unit);
  tidyFields(blob, path, unit);

  cloud.points.reset(new pcl::PointCloud<pcl::PointXYZ>(blob.width, 1));
  cloud.points->is_dense = false;
  cloud.points->sensor_origin_ = loaded.origin;
  cloud.points->sensor_origin_.head<3>() *= static_cast<float>(unit);
  cloud.points->sensor_orientation_ = loaded.orientation;
  const std::array<std::size_t, 3> offsets{findField(blob, "x")->offset,
                                           findField(blob, "y")->offset,
                                           findField(blob, "z")->offset};
  for (std::size_t i = 0; i < blob.width; ++i)
    for (std::size_t axis = 0; axis < 3; ++axis)
      std::memcpy(&(*cloud.points)[i].data[axis],
                  &blob.data[i * blob.point_step + offsets[axis]], sizeof(float));

  cloud.label = wholeField(blob, "label");
  cloud.room = wholeField(blob, "room");
  cloud.has_label = !cloud.label.empty();
  cloud.has_room = !cloud.room.empty();
  cloud.label.resize(blob.width, 0);
  cloud.room.resize(blob.width, 0);
  return cloud;
}

} // namespace tools
} // namespace sedr
} // namespace pcl
