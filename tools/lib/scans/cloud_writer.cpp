// SPDX-License-Identifier: BSD-3-Clause
#include "bytes/whole_file.h"
#include "scan_file.h"
#include "tool_cloud.h"
#include "tool_error.h"

#include "sedr_filters/src/base/field_access.h"
#include <pcl/conversions.h>
#include <pcl/io/lzf.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <limits>
#include <locale>
#include <sstream>

namespace pcl::sedr::tools {

namespace {

struct TypeName {
  const char* ply; ///< null if PLY has no such type
  char pcd;
};

TypeName
typeName(std::uint8_t datatype)
{
  switch (datatype) {
  case pcl::PCLPointField::BOOL:
    return {"uchar", 'U'};
  case pcl::PCLPointField::INT8:
    return {"char", 'I'};
  case pcl::PCLPointField::UINT8:
    return {"uchar", 'U'};
  case pcl::PCLPointField::INT16:
    return {"short", 'I'};
  case pcl::PCLPointField::UINT16:
    return {"ushort", 'U'};
  case pcl::PCLPointField::INT32:
    return {"int", 'I'};
  case pcl::PCLPointField::UINT32:
    return {"uint", 'U'};
  case pcl::PCLPointField::INT64:
    return {nullptr, 'I'};
  case pcl::PCLPointField::UINT64:
    return {nullptr, 'U'};
  case pcl::PCLPointField::FLOAT64:
    return {"double", 'F'};
  default:
    return {"float", 'F'};
  }
}

/** @brief Viewpoint of a cloud and origin of its coordinates. */
struct Frame {
  Eigen::Vector4f viewpoint = Eigen::Vector4f::Zero();
  Eigen::Quaternionf orientation = Eigen::Quaternionf::Identity();
  Origin origin;
  bool knows_viewpoint = false;

  /** @brief Returns the values of VIEWPOINT: place and quaternion, w first. */
  std::string viewpointText() const
  {
    std::ostringstream text;
    text.precision(std::numeric_limits<float>::max_digits10);
    text << viewpoint.x() << ' ' << viewpoint.y() << ' ' << viewpoint.z() << ' '
         << orientation.w() << ' ' << orientation.x() << ' ' << orientation.y() << ' '
         << orientation.z();
    return text.str();
  }
};

/** @brief Returns whether PCL's writers, which print six digits, keep an origin in
 * VIEWPOINT. */
bool
isKeptByPcl(const Origin& origin)
{
  const auto isKept = [](double length) {
    std::ostringstream text; // six digits
    text.imbue(std::locale::classic());
    text << length;
    const std::string digits = text.str();
    double kept = 0;
    readNumber(digits.data(), digits.data() + digits.size(), kept);
    return kept == length;
  };
  return isKept(origin.place.x()) && isKept(origin.place.y()) &&
         isKept(origin.place.z());
}

/** @brief Returns the header of a PCD. Comments have origin and viewpoint of the scan.
 * VIEWPOINT is the viewpoint if there is no origin, and else the origin if PCL keeps
 * it.
 * @param rows number of rows in the file */
std::string
pcdHeader(const std::vector<pcl::PCLPointField>& fields,
          std::size_t rows,
          const Frame& frame,
          const char* data)
{
  std::ostringstream names;
  std::ostringstream sizes;
  std::ostringstream types;
  std::ostringstream counts;
  for (const auto& field : fields) {
    names << ' ' << field.name;
    sizes << ' ' << fieldSize(field.datatype);
    types << ' ' << typeName(field.datatype).pcd;
    counts << ' ' << field.count;
  }
  std::ostringstream header;
  header << "# .PCD v0.7 - Point Cloud Data file format\n";
  const bool has_origin = !frame.origin.isZero();
  if (has_origin)
    header << "# " << frame.origin.comment() << '\n';
  const bool is_kept = has_origin && isKeptByPcl(frame.origin);
  const bool has_zero = !has_origin && frame.viewpoint.isZero(0);
  if (frame.knows_viewpoint && (has_origin || has_zero))
    header << "# sedr_viewpoint " << frame.viewpointText() << '\n';
  header << "VERSION 0.7\nFIELDS" << names.str() << "\nSIZE" << sizes.str() << "\nTYPE"
         << types.str() << "\nCOUNT" << counts.str() << "\nWIDTH " << rows
         << "\nHEIGHT 1\nVIEWPOINT "
         << (is_kept      ? frame.origin.text() + " 1 0 0 0"
             : has_origin ? "0 0 0 1 0 0 0"
                          : frame.viewpointText())
         << "\nPOINTS " << rows << "\nDATA " << data << '\n';
  return header.str();
}

void
writeBytes(std::ostream& stream, const std::vector<std::uint8_t>& bytes)
{
  stream.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
}

/** @brief Returns the compressed data of a PCD, field by field; empty if it cannot be
 * compressed. */
std::vector<std::uint8_t>
compressed(const pcl::PCLPointCloud2& blob)
{
  constexpr std::size_t most = std::numeric_limits<std::int32_t>::max();
  const std::size_t size = rowsOf(blob) * blob.point_step;
  if (size == 0 || size > most)
    return {};
  std::vector<std::uint8_t> by_field(size);
  std::size_t to = 0;
  for (const auto& field : blob.fields) {
    const std::size_t bytes = fieldSize(field.datatype) * field.count;
    for (std::size_t i = 0; i < rowsOf(blob); ++i, to += bytes)
      std::memcpy(&by_field[to], &blob.data[i * blob.point_step + field.offset], bytes);
  }
  constexpr std::size_t sizes = 2 * sizeof(std::uint32_t);
  const std::size_t room = size + size / 16 + 64;
  std::vector<std::uint8_t> packed(sizes + room);
  const std::uint32_t whole = static_cast<std::uint32_t>(size);
  const std::uint32_t length = pcl::lzfCompress(
      by_field.data(), whole, packed.data() + sizes, static_cast<unsigned>(room));
  std::memcpy(packed.data(), &length, sizeof length);
  std::memcpy(packed.data() + sizeof length, &whole, sizeof whole);
  packed.resize(length > 0 ? sizes + length : 0);
  return packed;
}

bool
isColour(const pcl::PCLPointField& field)
{
  return (field.name == "rgb" || field.name == "rgba") && field.count == 1 &&
         fieldSize(field.datatype) == sizeof(std::uint32_t);
}

/** @brief A property of a PLY file and its bytes within a row. */
struct Property {
  std::string type;
  std::string name;
  std::size_t offset;
  std::size_t size;
};

std::vector<Property>
plyProperties(const std::vector<pcl::PCLPointField>& fields)
{
  std::vector<Property> properties;
  for (const auto& field : fields) {
    if (isColour(field)) {
      properties.push_back({"uchar", "red", field.offset + 2, 1});
      properties.push_back({"uchar", "green", field.offset + 1, 1});
      properties.push_back({"uchar", "blue", field.offset, 1});
      if (field.name == "rgba")
        properties.push_back({"uchar", "alpha", field.offset + 3, 1});
      continue;
    }
    const char* type = typeName(field.datatype).ply;
    if (!type)
      throw ToolError("field '" + field.name +
                      "' has 64 bits, which PLY does not know: write "
                      "PCD instead");
    std::string name = field.name;
    if (name.size() == 8 && name.compare(0, 7, "normal_") == 0)
      name = std::string("n") + name.back();
    const std::size_t size = fieldSize(field.datatype);
    for (std::size_t k = 0; k < field.count; ++k)
      properties.push_back({type,
                            field.count > 1 ? name + "_" + std::to_string(k) : name,
                            field.offset + k * size, size});
  }
  return properties;
}

void
writePlyHeader(std::ostream& stream,
               const std::vector<Property>& properties,
               std::size_t rows,
               const Frame& frame)
{
  stream << "ply\nformat binary_little_endian 1.0\n";
  if (!frame.origin.isZero())
    stream << "comment " << frame.origin.comment() << '\n';
  stream << "element vertex " << rows << '\n';
  for (const auto& property : properties)
    stream << "property " << property.type << ' ' << property.name << '\n';
  stream << "end_header\n";
}

void
writePlyRows(std::ostream& stream,
             const std::vector<Property>& properties,
             const std::uint8_t* rows,
             std::size_t size,
             std::size_t row_size)
{
  std::size_t step = 0;
  for (const auto& property : properties)
    step += property.size;
  std::vector<std::uint8_t> bytes(size * step);
  auto* to = bytes.data();
  for (std::size_t i = 0; i < size; ++i)
    for (const auto& property : properties) {
      std::memcpy(to, rows + i * row_size + property.offset, property.size);
      to += property.size;
    }
  writeBytes(stream, bytes);
}

void
writePly(std::ostream& stream, const pcl::PCLPointCloud2& blob, const Frame& frame)
{
  const auto properties = plyProperties(blob.fields);
  writePlyHeader(stream, properties, rowsOf(blob), frame);
  writePlyRows(stream, properties, blob.data.data(), rowsOf(blob), blob.point_step);
}

void
writePcd(std::ostream& stream,
         const pcl::PCLPointCloud2& blob,
         const Frame& frame,
         PcdData data)
{
  if (data == PcdData::Compressed) {
    const auto packed = compressed(blob);
    if (!packed.empty()) {
      stream << pcdHeader(blob.fields, rowsOf(blob), frame, "binary_compressed");
      writeBytes(stream, packed);
      return;
    }
  }
  stream << pcdHeader(blob.fields, rowsOf(blob), frame, "binary");
  writeBytes(stream, blob.data);
}

bool
endsIn(const std::string& path, const std::string& extension)
{
  std::string end = std::filesystem::path(path).extension().string();
  std::transform(end.begin(), end.end(), end.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return end == extension;
}

void
save(const std::string& path,
     const pcl::PCLPointCloud2& blob,
     const Frame& frame,
     PcdData data)
{
  checkCloudOutput(path);
  writeWhole(path, [&](std::ostream& stream) {
    endsIn(path, ".ply") ? writePly(stream, blob, frame)
                         : writePcd(stream, blob, frame, data);
  });
}

/** @brief Returns rows without the padding of PCL's point types, which file headers
 * cannot describe. */
pcl::PCLPointCloud2
withoutPadding(const pcl::PCLPointCloud2& blob)
{
  pcl::PCLPointCloud2 packed = blob;
  packed.point_step = 0;
  for (auto& field : packed.fields) {
    field.offset = packed.point_step;
    packed.point_step +=
        static_cast<std::uint32_t>(fieldSize(field.datatype) * field.count);
  }
  const std::size_t rows = std::size_t{blob.width} * blob.height;
  packed.row_step = packed.point_step * packed.width;
  packed.data.assign(rows * packed.point_step, 0);
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t f = 0; f < packed.fields.size(); ++f)
      std::memcpy(&packed.data[i * packed.point_step + packed.fields[f].offset],
                  &blob.data[i * blob.point_step + blob.fields[f].offset],
                  fieldSize(blob.fields[f].datatype) * blob.fields[f].count);
  return packed;
}

} // namespace

void
checkCloudOutput(const std::string& path)
{
  if (!endsIn(path, ".pcd") && !endsIn(path, ".ply"))
    throw ToolError("cannot write '" + path +
                    "': the name of a cloud ends in .pcd or .ply");
  checkWritable(path);
}

void
saveCloud(const std::string& path, const ToolCloud& cloud, PcdData data)
{
  save(path, cloud.blob,
       {cloud.points->sensor_origin_, cloud.points->sensor_orientation_, cloud.origin,
        cloud.knows_viewpoint},
       data);
}

void
saveCloud(const std::string& path, const pcl::PCLPointCloud2& blob, PcdData data)
{
  save(path, withoutPadding(blob), Frame(), data);
}

void
saveScan(const std::string& path, const ScanFile& scan)
{
  checkCloudOutput(path);
  const Frame frame{scan.viewpoint(), scan.orientation(), scan.origin(),
                    scan.knowsViewpoint()};
  warnOfPositions(scan);
  const bool is_ply = endsIn(path, ".ply");
  const auto properties =
      is_ply ? plyProperties(scan.fields()) : std::vector<Property>();
  writeWhole(path, [&](std::ostream& stream) {
    if (is_ply)
      writePlyHeader(stream, properties, scan.size(), frame);
    else
      stream << pcdHeader(scan.fields(), scan.size(), frame, "binary");
    scan.forEachPiece([&](const RowSource::Piece& piece) {
      if (is_ply)
        writePlyRows(stream, properties, piece.rows, piece.size, scan.rowSize());
      else
        stream.write(reinterpret_cast<const char*>(piece.rows),
                     static_cast<std::streamsize>(piece.size * scan.rowSize()));
      return stream.good(); // a full disk is reported when the file is closed
    });
  });
}

void
saveStructure(const std::string& path,
              const pcl::PointCloud<pcl::PointStructure>& structure,
              const Origin& origin)
{
  Frame frame;
  frame.origin = origin;
  constexpr std::size_t piece = 1 << 16;
  writeWhole(path, [&](std::ostream& stream) {
    std::size_t done = 0;
    do {
      const std::size_t end = std::min(structure.size(), done + piece);
      pcl::PointCloud<pcl::PointStructure> points;
      points.insert(points.end(), structure.begin() + static_cast<std::ptrdiff_t>(done),
                    structure.begin() + static_cast<std::ptrdiff_t>(end));
      pcl::PCLPointCloud2 rows;
      pcl::toPCLPointCloud2(points, rows);
      rows = withoutPadding(rows);
      if (done == 0)
        stream << pcdHeader(rows.fields, structure.size(), frame, "binary");
      writeBytes(stream, rows.data);
      done = end;
    } while (done < structure.size());
  });
}

} // namespace pcl::sedr::tools
