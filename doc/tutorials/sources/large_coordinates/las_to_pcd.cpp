// SPDX-License-Identifier: BSD-3-Clause
// Reads an uncompressed LAS file (1.0 to 1.4, little endian), subtracts an origin in
// double precision, and writes a PCD with x, y, z in metres as floats.
#include <pcl/io/pcd_io.h>

#include <Eigen/Core>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

// [header]
/** @brief What of a LAS header says where the points are, and how far off. */
struct LasHeader {
  std::uint32_t offset = 0; ///< of the first point, bytes
  std::uint16_t record = 0; ///< bytes a point
  std::uint64_t points = 0;
  Eigen::Vector3d scale;  ///< of the whole numbers that stand for coordinates
  Eigen::Vector3d shift;  ///< added to them
  Eigen::Vector3d lowest; ///< of all points
};

template <typename T>
T
valueAt(const std::vector<char>& bytes, std::size_t position)
{
  T value;
  std::memcpy(&value, bytes.data() + position, sizeof value);
  return value;
}

LasHeader
readHeader(std::istream& file)
{
  std::vector<char> bytes(375, 0); // as long as that of LAS 1.4
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (file.gcount() < 227 || std::string(bytes.data(), 4) != "LASF")
    throw std::runtime_error("this is no LAS file");
  constexpr std::uint8_t is_compressed = 0x80;
  if (valueAt<std::uint8_t>(bytes, 104) & is_compressed)
    throw std::runtime_error("this is LAZ: decompress it first");
  LasHeader header;
  header.offset = valueAt<std::uint32_t>(bytes, 96);
  header.record = valueAt<std::uint16_t>(bytes, 105);
  header.points = valueAt<std::uint32_t>(bytes, 107);
  if (header.points == 0 && valueAt<std::uint8_t>(bytes, 25) >= 4)
    header.points = valueAt<std::uint64_t>(bytes, 247);
  for (int k = 0; k < 3; ++k) {
    const auto axis = static_cast<std::size_t>(k);
    header.scale[k] = valueAt<double>(bytes, 131 + 8 * axis);
    header.shift[k] = valueAt<double>(bytes, 155 + 8 * axis);
    header.lowest[k] = valueAt<double>(bytes, 187 + 16 * axis);
  }
  return header;
}
// [header]

// [subtract]
/** @brief A round number near the points, so that what remains is small and exact. */
Eigen::Vector3d
originOf(const LasHeader& header)
{
  Eigen::Vector3d origin = (header.lowest / 100).array().floor() * 100; // metres
  origin.z() = 0; // heights are small as they are
  return origin;
}

pcl::PointCloud<pcl::PointXYZ>
readPoints(std::istream& file, const LasHeader& header, const Eigen::Vector3d& origin)
{
  file.clear();
  file.seekg(header.offset);
  pcl::PointCloud<pcl::PointXYZ> cloud;
  cloud.reserve(header.points);
  std::vector<char> record(header.record);
  for (std::uint64_t i = 0; i < header.points; ++i) {
    if (!file.read(record.data(), header.record))
      throw std::runtime_error("the file ends after " + std::to_string(i) + " of " +
                               std::to_string(header.points) + " points");
    Eigen::Vector3d p;
    for (int k = 0; k < 3; ++k)
      p[k] = valueAt<std::int32_t>(record, 4 * static_cast<std::size_t>(k)) *
                 header.scale[k] +
             header.shift[k];
    p -= origin; // in double precision, before it becomes float
    cloud.push_back({static_cast<float>(p.x()), static_cast<float>(p.y()),
                     static_cast<float>(p.z())});
  }
  return cloud;
}
// [subtract]

} // namespace

int
main(int argc, char** argv)
{
  if (argc != 3) {
    std::cerr << "usage: las_to_pcd SCAN.las SCAN.pcd\n";
    return 1;
  }
  try {
    std::ifstream file(argv[1], std::ios::binary);
    const LasHeader header = readHeader(file);
    const Eigen::Vector3d origin = originOf(header);
    pcl::io::savePCDFileBinary(argv[2], readPoints(file, header, origin));
    std::cout << header.points << " points, origin " << std::fixed << origin.x() << ' '
              << origin.y() << ' ' << origin.z() << '\n';
  }
  catch (const std::exception& error) {
    std::cerr << argv[1] << ": " << error.what() << '\n';
    return 1;
  }
  return 0;
}
