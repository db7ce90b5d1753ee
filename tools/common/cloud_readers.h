// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mapped_file.h"

#include <pcl/PCLPointCloud2.h>

#include <Eigen/Geometry>

#include <string>
#include <string_view>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief A cloud as it stands in a file. */
struct FileCloud {
  pcl::PCLPointCloud2 blob;
  Eigen::Vector4f origin = Eigen::Vector4f::Zero();
  Eigen::Quaternionf orientation = Eigen::Quaternionf::Identity();
};

/** @brief Reads PCD 0.5 to 0.7, ascii, binary or binary_compressed. The header is
 * checked against the size of the file before anything is read; what is wrong is thrown
 * as a ToolError. */
FileCloud readPcd(const MappedFile& file, const std::string& path);

/** @brief Reads the vertices of a PLY file, ascii or binary of either byte order, faces
 * skipped. */
FileCloud readPly(const MappedFile& file, const std::string& path);

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
