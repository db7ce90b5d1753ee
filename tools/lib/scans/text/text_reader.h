// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "point_reader.h"
#include "text_columns.h"

namespace pcl::sedr::tools {

/** @brief The points of a text, one per line: x, y, z, then `intensity`, `rgb` and
 * other columns as floats. Empty lines and comments (# and //) are skipped. All lines
 * are counted at first and one per 64 KiB is remembered, for random access. Throws
 * ToolError that names a line with too few numbers. */
class TextReader : public PointReader {
public:
  TextReader(const MappedFile& file,
             const std::string& path,
             const std::string& columns);

  const std::vector<pcl::PCLPointField>& fields() const override { return fields_; }
  std::size_t size() const override { return size_; }
  void read(std::size_t first, std::size_t size, std::uint8_t* rows) const override;
  std::size_t placeOf(std::size_t row) const override;

private:
  /** @brief A remembered line. */
  struct Mark {
    std::size_t place = 0; ///< byte offset in the file
    std::size_t row = 0;   ///< number of the first row from there on
  };

  void layFields();
  void countLines();

  /** @brief Returns whether a line is a point, neither a comment nor a count. */
  bool holdsPoint(std::string_view line) const;

  /** @brief Throws ToolError unless the points from `begin` on are as many as the line
   * before them promises. */
  void checkCount(std::uint64_t promised, std::size_t begin) const;
  const Mark& markBefore(std::size_t row) const;
  void writeRow(const double* numbers, std::uint8_t* row) const;

  const MappedFile& file_;
  std::string path_;
  TextColumns columns_;
  std::vector<pcl::PCLPointField> fields_;
  std::vector<std::size_t> xyz_;    ///< columns
  std::vector<std::size_t> colour_; ///< columns of blue, green, red; empty if missing
  std::vector<std::size_t> others_; ///< of the fields after x, y and z, not rgb
  std::vector<Mark> marks_;
  std::size_t size_ = 0;
};

} // namespace pcl::sedr::tools
