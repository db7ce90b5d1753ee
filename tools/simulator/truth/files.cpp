// SPDX-License-Identifier: BSD-3-Clause
#include "files.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace pcl::sedr::sim {

namespace {

static_assert(sizeof(ScanPoint) == 20, "a point is written as it lies in memory");

/** @brief The bytes of a binary file, little endian as the machine. */
class Bytes {
public:
  template <typename T>
  void append(T value)
  {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    bytes_.append(raw, sizeof(T));
  }

  const std::string& get() const { return bytes_; }

private:
  std::string bytes_;
};

[[noreturn]] void
failToWrite(const std::filesystem::path& path, const std::string& reason)
{
  throw std::runtime_error("Cannot write " + path.string() + ": " + reason);
}

/** @brief Writes header and data to a temporary file, then renames it to @p path. */
void
writeWhole(const std::filesystem::path& path,
           const std::string& header,
           const std::function<void(std::ostream&)>& write_data)
{
  std::filesystem::path part = path;
  part += ".part";
  std::error_code ignored;
  {
    std::ofstream file(part, std::ios::binary | std::ios::trunc);
    if (!file)
      failToWrite(path, std::strerror(errno));
    file << header;
    write_data(file);
    file.close();
    if (!file) {
      std::filesystem::remove(part, ignored);
      failToWrite(path, "the disk may be full");
    }
  }
  std::error_code error;
  std::filesystem::rename(part, path, error);
  if (error) {
    std::filesystem::remove(part, ignored);
    failToWrite(path, error.message());
  }
}

void
writeWhole(const std::filesystem::path& path,
           const std::string& header,
           const char* data,
           std::size_t size)
{
  writeWhole(path, header, [&](std::ostream& file) {
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
  writeWhole(path, pcdHeader(count, false), [&](std::ostream& file) {
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
  Bytes bytes;
  for (const Vec3& vertex : mesh.vertices) {
    const Vec3 point = placed(placement, vertex);
    bytes.append(static_cast<float>(point.x));
    bytes.append(static_cast<float>(point.y));
    bytes.append(static_cast<float>(point.z));
  }
  for (const Face& face : mesh.faces) {
    bytes.append(static_cast<std::uint8_t>(3));
    for (const std::uint32_t vertex : face.vertices)
      bytes.append(static_cast<std::int32_t>(vertex));
    bytes.append(static_cast<std::int32_t>(face.label));
    bytes.append(static_cast<std::int32_t>(face.room));
  }
  writeWhole(path, plyHeader(mesh), bytes.get().data(), bytes.get().size());
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
