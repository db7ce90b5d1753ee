// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bytes/mapped_file.h"
#include "point_reader.h"
#include "scan_settings.h"

#include <pcl/PCLPointCloud2.h>

#include <Eigen/Geometry>

#include <charconv>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pcl::sedr::tools {

enum class FileData { Ascii, Binary, BinaryBigEndian, Compressed, Decoded };

/** @brief Position and encoding of the points in a file. */
struct FileLayout {
  pcl::PCLPointCloud2 blob; ///< fields and sizes as in the file, without the data
  FileData data = FileData::Binary;
  std::size_t begin = 0; ///< first byte of the points in the file
  bool is_ply = false;
  std::uint64_t faces = 0; ///< of a mesh, including strips of triangles
  bool are_last = false;   ///< whether nothing follows the points
  std::optional<Eigen::Vector3d> viewpoint; ///< in the unit of the file, if known
  Eigen::Quaternionf orientation = Eigen::Quaternionf::Identity();
  Origin counted_from;     ///< origin subtracted when the file was written
  bool has_floats = false; ///< whether x, y and z are floats by the header of a PCD
  std::shared_ptr<const PointReader> reader; ///< for Decoded points
};

/** @brief Detects the format from the content and reads the header. Throws ToolError if
 * the file is no scan, invalid or truncated. */
FileLayout readLayout(const MappedFile& file,
                      const std::string& path,
                      const ScanSettings& settings);

/** @brief Reads the header of a PCD 0.5 to 0.7 (ascii, binary or binary_compressed) and
 * checks it against the file size. Throws ToolError if it is invalid or truncated. */
FileLayout readPcdLayout(const MappedFile& file, const std::string& path);

/** @brief As above for the vertices of a PLY file, ascii or binary of either byte
 * order. */
FileLayout readPlyLayout(const MappedFile& file, const std::string& path);

/** @brief Reads all points as stored. Throws ToolError if the file is truncated or
 * damaged. */
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

/** @brief Reverses the byte order of every value. */
void swapBytes(pcl::PCLPointCloud2& blob);

/** @brief Renames the properties of a PLY file to PCL's fields, and joins one-byte red,
 * green, blue and alpha into `rgb`, or `rgba` with alpha. */
void nameAsPcl(pcl::PCLPointCloud2& blob);

/** @brief What `surplus` bytes behind the points of a file are: more points than its
 * header promises, if they are a whole number of `row` bytes. Otherwise prints a
 * warning that `path` has bytes of something else, unless it is less than a point. */
bool areMorePoints(std::uint64_t surplus, std::uint64_t row, const std::string& path);

bool looksLikePcd(const MappedFile& file);

bool looksLikePly(const MappedFile& file);

/** @brief Iterates over the lines and words of a file's header or text. A line ends
 * with a line feed, a carriage return, or both. */
class TextCursor {
public:
  TextCursor(const MappedFile& file, std::size_t position)
      : file_(file)
      , position_(position)
  {}

  /** @brief Reads the next line without its end; false at the end of the file. */
  bool nextLine(std::string_view& line);

  /** @brief Returns the byte offset of the next line in the file. */
  std::size_t position() const { return position_; }

private:
  const MappedFile& file_;
  std::size_t position_;
};

std::vector<std::string_view> wordsOf(std::string_view line);

/** @brief Reads a number as std::from_chars does, but one too large for a double as
 * infinite and one too small as 0. */
std::from_chars_result readNumber(const char* begin, const char* end, double& value);

/** @brief Reads the numbers of `line` as the fields of one point. Throws ToolError
 * if they are more or fewer than the values in the fields. */
void readNumbers(std::string_view line,
                 const pcl::PCLPointCloud2& blob,
                 const std::string& path,
                 std::size_t point,
                 std::uint8_t* row);
/** @brief Sets width, height, offsets and steps of a blob from its fields and allocates
 * `points`. Throws ToolError if an index cannot count them. */
void layOut(pcl::PCLPointCloud2& blob, std::uint64_t points, const std::string& path);

} // namespace pcl::sedr::tools
