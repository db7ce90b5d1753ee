// SPDX-License-Identifier: BSD-3-Clause
#include "files.h"

#include "bytes/whole_file.h"

#include <sstream>
#include <string>

namespace pcl::sedr::sim {

namespace {

static_assert(sizeof(ScanPoint) == 20, "a point is written as it lies in memory");

void
writeWhole(const std::filesystem::path& path,
           const std::string& header,
           const char* data,
           std::size_t size)
{
  tools::writeWhole(path.string(), [&](std::ostream& file) {
    file << header;
    file.write(data, static_cast<std::streamsize>(size));
  });
}

/** @brief Returns the PCD header of points of x y z label, and room if there is one. */
std::string
pcdHeader(std::size_t count, bool has_room)
{
  std::ostringstream header;
  header << "# .PCD v0.7 - Point Cloud Data file format\n"
         << "VERSION 0.7\n"
         << "FIELDS x y z label" << (has_room ? " room\n" : "\n") << "SIZE 4 4 4 4"
         << (has_room ? " 4\n" : "\n") << "TYPE F F F U" << (has_room ? " U\n" : "\n")
         << "COUNT 1 1 1 1" << (has_room ? " 1\n" : "\n") << "WIDTH " << count << "\n"
         << "HEIGHT 1\n"
         << "VIEWPOINT 0 0 0 1 0 0 0\n"
         << "POINTS " << count << "\n"
         << "DATA binary\n";
  return header.str();
}

std::string
plyHeader(const Mesh& mesh)
{
  std::ostringstream header;
  header << "ply\n"
         << "format binary_little_endian 1.0\n"
         << "comment closed structure of a simulated scene, normals out of the rooms\n"
         << "comment label 1 ceiling 2 floor 3 wall 4 detail 5 column; metres, z up\n"
         << "element vertex " << mesh.vertices.size() << "\n"
         << "property float x\n"
         << "property float y\n"
         << "property float z\n"
         << "element face " << mesh.faces.size() << "\n"
         << "property list uchar int vertex_indices\n"
         << "property int label\n"
         << "property int room\n"
         << "end_header\n";
  return header.str();
}

} // namespace

void
writePcd(const std::filesystem::path& path, const std::vector<ScanPoint>& points)
{
  writeWhole(path, pcdHeader(points.size(), true),
             reinterpret_cast<const char*>(points.data()),
             points.size() * sizeof(ScanPoint));
}

void
writePcdStream(const std::filesystem::path& path,
               std::size_t count,
               const std::function<void(const PointSink&)>& make)
{
  static_assert(sizeof(LabelledPoint) == 16, "a point is written as it lies in memory");
  constexpr std::size_t at_once = 1 << 16;
  tools::writeWhole(path.string(), [&](std::ostream& file) {
    file << pcdHeader(count, false);
    std::vector<LabelledPoint> points;
    const auto flush = [&] {
      file.write(reinterpret_cast<const char*>(points.data()),
                 static_cast<std::streamsize>(points.size() * sizeof(LabelledPoint)));
      points.clear();
    };
    make([&](const LabelledPoint& point) {
      points.push_back(point);
      if (points.size() == at_once)
        flush();
    });
    flush();
  });
}

void
writePly(const std::filesystem::path& path,
         const Mesh& mesh,
         const Placement& placement)
{
  std::string bytes; // little endian as the machine
  const auto append = [&bytes](auto value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  for (const Vec3& vertex : mesh.vertices) {
    const Vec3 point = placed(placement, vertex);
    append(static_cast<float>(point.x));
    append(static_cast<float>(point.y));
    append(static_cast<float>(point.z));
  }
  for (const Face& face : mesh.faces) {
    append(static_cast<std::uint8_t>(3));
    for (const std::uint32_t vertex : face.vertices)
      append(static_cast<std::int32_t>(vertex));
    append(static_cast<std::int32_t>(face.label));
    append(static_cast<std::int32_t>(face.room));
  }
  writeWhole(path, plyHeader(mesh), bytes.data(), bytes.size());
}

void
writePositions(const std::filesystem::path& path,
               const std::vector<ScanPosition>& positions)
{
  std::ostringstream text;
  text.precision(10);
  text << "# x y z points\n";
  for (const ScanPosition& position : positions)
    text << position.place.x << ' ' << position.place.y << ' ' << position.place.z
         << ' ' << position.points << '\n';
  writeText(path, text.str());
}

void
writeText(const std::filesystem::path& path, const std::string& text)
{
  writeWhole(path, text, nullptr, 0);
}

} // namespace pcl::sedr::sim
