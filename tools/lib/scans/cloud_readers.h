// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bytes/mapped_file.h"
#include "point_reader.h"
#include "scan_settings.h"

#include <pcl/PCLPointCloud2.h>

#include <Eigen/Geometry>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

enum class FileData { Ascii, Binary, BinaryBigEndian, Compressed, Decoded };

/** @brief Where the points of a file stand, and how. */
struct FileLayout {
  pcl::PCLPointCloud2 blob; ///< fields and sizes as in the file, without the data
  FileData data = FileData::Binary;
  std::size_t begin = 0; ///< of the points, bytes from the start of the file
  bool is_ply = false;
  std::uint64_t faces = 0; ///< of a mesh, or its strips of triangles
  Eigen::Vector3d viewpoint = Eigen::Vector3d::Zero(); ///< in the unit of the file
  Eigen::Quaternionf orientation = Eigen::Quaternionf::Identity();
  Origin counted_from; ///< what was subtracted when the file was written
  std::shared_ptr<const PointReader> reader; ///< of Decoded points
};

/** @brief Tells a file by its content and reads its head. What is no scan, wrong or cut
 * off is thrown as a ToolError. */
FileLayout readLayout(const MappedFile& file,
                      const std::string& path,
                      const ScanSettings& settings);

/** @brief Reads the header of a PCD 0.5 to 0.7, ascii, binary or binary_compressed, and
 * checks it against the size of the file: what is wrong, or cut off, is thrown as a
 * ToolError. */
FileLayout readPcdLayout(const MappedFile& file, const std::string& path);

/** @brief The same of a PLY file, ascii or binary of either byte order: its vertices.
 */
FileLayout readPlyLayout(const MappedFile& file, const std::string& path);

/** @brief Reads all points, as they stand in the file. What is cut off or damaged is
 * thrown as a ToolError. */
pcl::PCLPointCloud2
readPoints(const MappedFile& file, const FileLayout& layout, const std::string& path);

void readAsciiPcd(const MappedFile& file,
                  const FileLayout& layout,
                  const std::string& path,
                  pcl::PCLPointCloud2& blob);

void readCompressedPcd(const MappedFile& file,
                       const FileLayout& layout,
                       const std::string& path,
                       pcl::PCLPointCloud2& blob);

void readAsciiPly(const MappedFile& file,
                  const FileLayout& layout,
                  const std::string& path,
                  pcl::PCLPointCloud2& blob);

/** @brief Turns the bytes of every value round. */
void swapBytes(pcl::PCLPointCloud2& blob);

/** @brief Gives the properties of a PLY file the names of PCL's fields, and joins red,
 * green, blue and alpha of one byte each into `rgb`, or `rgba` with alpha. */
void nameAsPcl(pcl::PCLPointCloud2& blob);

bool looksLikePcd(const MappedFile& file);

bool looksLikePly(const MappedFile& file);

/** @brief Goes through the lines and words of a text, a file's header or body. */
class TextCursor {
public:
  TextCursor(const MappedFile& file, std::size_t position)
      : file_(file)
      , position_(position)
  {}

  /** @brief The next line without its end; false at the end of the file. */
  bool nextLine(std::string_view& line);

  /** @brief Where the next line begins, bytes from the start of the file. */
  std::size_t position() const { return position_; }

private:
  const MappedFile& file_;
  std::size_t position_;
};

std::vector<std::string_view> wordsOf(std::string_view line);

/** @brief Reads the numbers of `line` as the fields of one point.
 * @return how many numbers were read; all of them if that is what the fields take */
std::size_t readNumbers(std::string_view line,
                        const std::vector<pcl::PCLPointField>& fields,
                        std::uint8_t* point);

/** @brief Sets width, height, offsets and steps of a blob that has its fields, and
 * makes room for `points`; refuses more points than an index can count. */
void layOut(pcl::PCLPointCloud2& blob, std::uint64_t points, const std::string& path);

} // namespace tools
} // namespace sedr
} // namespace pcl
