// SPDX-License-Identifier: BSD-3-Clause
#include "bytes/whole_file.h"
#include "scan_file.h"
#include "tool_cloud.h"
#include "tool_error.h"

#include "sedr_filters/src/base/field_access.h"
#include <pcl/conversions.h>

#include <array>
#include <cstring>
#include <limits>
#include <sstream>

namespace pcl::sedr::tools {

namespace {

using Fields = std::vector<pcl::PCLPointField>;

/** @brief Names of a type in PLY and PCD, by the constants of PCLPointField. */
struct TypeName {
  const char* ply; ///< null if PLY has no such type
  char pcd;
};

constexpr std::array<TypeName, 12> type_names{{{"float", 'F'},
                                               {"char", 'I'},
                                               {"uchar", 'U'},
                                               {"short", 'I'},
                                               {"ushort", 'U'},
                                               {"int", 'I'},
                                               {"uint", 'U'},
                                               {"float", 'F'},
                                               {"double", 'F'},
                                               {nullptr, 'I'},
                                               {nullptr, 'U'},
                                               {"uchar", 'U'}}};

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

/** @brief Returns the header of a PCD. Comments have origin and viewpoint of the scan.
 * VIEWPOINT is the viewpoint if there is no origin, and else the origin if PCL keeps
 * it. */
std::string
pcdHeader(const Fields& fields, std::size_t rows, const Frame& frame)
{
  std::ostringstream names, sizes, types, counts;
  for (const auto& field : fields) {
    names << ' ' << field.name;
    sizes << ' ' << fieldSize(field.datatype);
    types << ' ' << type_names.at(field.datatype).pcd;
    counts << ' ' << field.count;
  }
  std::ostringstream header;
  header << "# .PCD v0.7 - Point Cloud Data file format\n";
  const bool has_origin = !frame.origin.isZero();
  if (has_origin)
    header << "# " << frame.origin.comment() << '\n';
  if (frame.knows_viewpoint && (has_origin || frame.viewpoint.isZero(0)))
    header << "# sedr_viewpoint " << frame.viewpointText() << '\n';
  header << "VERSION 0.7\nFIELDS" << names.str() << "\nSIZE" << sizes.str() << "\nTYPE"
         << types.str() << "\nCOUNT" << counts.str() << "\nWIDTH " << rows
         << "\nHEIGHT 1\nVIEWPOINT "
         << (!has_origin                       ? frame.viewpointText()
             : isKeptByPcl(frame.origin.place) ? frame.origin.text() + " 1 0 0 0"
                                               : "0 0 0 1 0 0 0")
         << "\nPOINTS " << rows << "\nDATA binary\n";
  return header.str();
}

/** @brief Bytes of a row that are written. */
struct Part {
  std::string type; ///< in the header of a PLY
  std::string name;
  std::size_t offset = 0;
  std::size_t size = 0;
};

/** @brief Returns the properties of a PLY; a colour is one of bytes. */
std::vector<Part>
plyProperties(const Fields& fields)
{
  std::vector<Part> properties;
  for (const auto& field : fields) {
    const std::size_t size = fieldSize(field.datatype);
    if ((field.name == "rgb" || field.name == "rgba") && field.count == 1 &&
        size == sizeof(std::uint32_t)) {
      for (const auto& [name, byte] :
           {std::make_pair("red", 2), {"green", 1}, {"blue", 0}, {"alpha", 3}})
        if (byte < 3 || field.name == "rgba")
          properties.push_back(
              {"uchar", name, field.offset + static_cast<std::size_t>(byte), 1});
      continue;
    }
    const char* type = type_names.at(field.datatype).ply;
    if (!type)
      throw ToolError("field '" + field.name +
                      "' has 64 bits, which PLY does not know: write "
                      "PCD instead");
    std::string name = field.name;
    if (name.size() == 8 && name.compare(0, 7, "normal_") == 0)
      name = std::string("n") + name.back();
    for (std::size_t k = 0; k < field.count; ++k)
      properties.push_back({type,
                            field.count > 1 ? name + "_" + std::to_string(k) : name,
                            field.offset + k * size, size});
  }
  return properties;
}

/** @brief Writes a cloud, header first, then rows: as PLY or binary PCD. Padding of
 * PCL's point types is left out. */
class CloudStream {
public:
  CloudStream(std::ostream& stream,
              const Fields& fields,
              std::size_t rows,
              const Frame& frame,
              bool is_ply)
      : stream_(stream)
  {
    if (!is_ply) {
      for (const auto& field : fields)
        parts_.push_back(
            {"", "", field.offset, fieldSize(field.datatype) * field.count});
      stream << pcdHeader(fields, rows, frame);
      return;
    }
    parts_ = plyProperties(fields);
    stream << "ply\nformat binary_little_endian 1.0\n";
    if (!frame.origin.isZero())
      stream << "comment " << frame.origin.comment() << '\n';
    stream << "element vertex " << rows << '\n';
    for (const Part& part : parts_)
      stream << "property " << part.type << ' ' << part.name << '\n';
    stream << "end_header\n";
  }

  void write(const std::uint8_t* rows, std::size_t size, std::size_t row_size)
  {
    std::size_t step = 0;
    bool is_plain = true;
    for (const Part& part : parts_) {
      is_plain = is_plain && part.offset == step;
      step += part.size;
    }
    if (is_plain && step == row_size) {
      stream_.write(reinterpret_cast<const char*>(rows),
                    static_cast<std::streamsize>(size * row_size));
      return;
    }
    std::vector<std::uint8_t> bytes(size * step);
    auto* to = bytes.data();
    for (std::size_t i = 0; i < size; ++i)
      for (const Part& part : parts_) {
        std::memcpy(to, rows + i * row_size + part.offset, part.size);
        to += part.size;
      }
    stream_.write(reinterpret_cast<const char*>(bytes.data()),
                  static_cast<std::streamsize>(bytes.size()));
  }

private:
  std::ostream& stream_;
  std::vector<Part> parts_;
};

bool
isPly(const std::string& path)
{
  return hasExtension(path, ".ply");
}

} // namespace

void
checkCloudOutput(const std::string& path)
{
  checkOutput(path, "a cloud", {".pcd", ".ply"});
}

void
saveCloud(const std::string& path, const ToolCloud& cloud)
{
  checkCloudOutput(path);
  const pcl::PCLPointCloud2& blob = cloud.blob;
  Frame frame;
  if (cloud.points)
    frame = {cloud.points->sensor_origin_, cloud.points->sensor_orientation_,
             cloud.origin, cloud.knows_viewpoint};
  writeWhole(path, [&](std::ostream& stream) {
    CloudStream rows(stream, blob.fields, rowsOf(blob), frame, isPly(path));
    rows.write(blob.data.data(), rowsOf(blob), blob.point_step);
  });
}

void
saveScan(const std::string& path, const RowSource& rows, const ScanFile& scan)
{
  const Frame frame{scan.viewpoint(), scan.orientation(), scan.origin(),
                    scan.knowsViewpoint()};
  warnOfPositions(scan);
  writeWhole(path, [&](std::ostream& stream) {
    CloudStream cloud(stream, rows.fields(), rows.size(), frame, isPly(path));
    rows.forEachPiece([&](const RowSource::Piece& piece) {
      cloud.write(piece.rows, piece.size, rows.rowSize());
      return stream.good(); // a full disk is reported when the file is closed
    });
  });
}

void
saveStructure(const std::string& path,
              const pcl::PointCloud<pcl::PointStructure>& structure,
              const Origin& origin,
              const std::vector<std::array<std::uint8_t, 5>>& colours)
{
  Frame frame;
  frame.origin = origin;
  pcl::PCLPointCloud2 layout;
  pcl::toPCLPointCloud2(pcl::PointCloud<pcl::PointStructure>(), layout);
  std::size_t row = sizeof(pcl::PointStructure);
  const auto addField = [&](const char* name, std::uint8_t datatype) {
    pcl::PCLPointField field;
    field.name = name;
    field.datatype = datatype;
    field.count = 1;
    field.offset = static_cast<pcl::uindex_t>(row);
    layout.fields.push_back(field);
    row += fieldSize(datatype);
  };
  if (!colours.empty()) {
    addField("rgb", pcl::PCLPointField::FLOAT32);
    addField("seen", pcl::PCLPointField::UINT8);
  }
  writeWhole(path, [&](std::ostream& stream) {
    CloudStream cloud(stream, layout.fields, structure.size(), frame, false);
    constexpr std::size_t piece = 1 << 16; // as a second copy is made of it
    std::vector<std::uint8_t> rows;
    for (std::size_t done = 0; done < structure.size(); done += piece) {
      const std::size_t size = std::min(piece, structure.size() - done);
      rows.resize(size * row);
      for (std::size_t i = 0; i < size; ++i) {
        std::memcpy(&rows[i * row], &structure[done + i], sizeof(pcl::PointStructure));
        if (!colours.empty())
          std::memcpy(&rows[i * row + sizeof(pcl::PointStructure)],
                      colours[done + i].data(), sizeof colours[0]);
      }
      cloud.write(rows.data(), size, row);
    }
  });
}

} // namespace pcl::sedr::tools
