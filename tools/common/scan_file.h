// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud_readers.h"

#include <pcl/sedr_filters/row_source.h>

#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief What the head of a PCD or PLY file says. */
struct ScanHead {
  std::size_t rows = 0;
  bool is_in_pieces = false; ///< whether some rows can be had without the others
  bool is_mesh = false;      ///< whether the rows are vertices of faces
};

/** @brief Reads nothing but the head of a file; anything amiss with it is a ToolError.
 */
ScanHead readScanHead(const std::string& path);

/** @brief A PCD or PLY file, told apart by its content, that is read as it is needed.
 *
 * Its rows have every field of the file, x, y and z as FLOAT32 metres, no padding.
 * Those of a binary file come piece by piece from the mapped file, and from there
 * without a copy if they stand there as they are wanted; the pages of a piece are given
 * back while the next one is read, so that a scan of any size takes no more memory than
 * two pieces, and one more where they are copied. binary_compressed and ascii are
 * unpacked into memory first.
 *
 * Of a mesh the vertices are the points, and a warning says so where the first of them
 * is read, once in a process.
 *
 * Anything amiss is a ToolError of one sentence: no such file, a folder, neither PCD
 * nor PLY, cut off, damaged, no x, y or z, 0 points, no finite point, or most
 * coordinates so large that a float resolves them no finer than 1 mm (above 8388 m);
 * that is told by up to 20,000 of the points. */
class ScanFile : public RowSource {
public:
  /** @param unit metres that one unit of the file stands for: coordinates and viewpoint
   * are brought to metres, in double precision, before anything is checked or made a
   * float
   * @param piece_bytes about how much of the file makes a piece */
  explicit ScanFile(const std::string& path,
                    double unit = 1,
                    std::size_t piece_bytes = std::size_t{1} << 23);

  const std::string& path() const { return path_; }

  const std::vector<pcl::PCLPointField>& fields() const override
  {
    return tidy_.fields;
  }
  std::size_t rowSize() const override { return tidy_.point_step; }
  std::size_t size() const override { return layout_.blob.width; }
  void forEachPiece(const std::function<bool(const Piece&)>& see) const override
  {
    forEachPiece(0, size(), see);
  }

  /** @brief The same for the rows from `begin` to `end`; those of a binary file come
   * without the others being touched. */
  void forEachPiece(std::size_t begin,
                    std::size_t end,
                    const std::function<bool(const Piece&)>& see) const;

  /** @brief Where the scan was seen from, metres. */
  Eigen::Vector4f origin() const;
  const Eigen::Quaternionf& orientation() const { return layout_.orientation; }

private:
  /** @brief Some rows as they stand in the file, but for the byte order. */
  pcl::PCLPointCloud2 rawRows(std::size_t first, std::size_t size) const;

  /** @brief Brings rows into the form that is given out. */
  void tidy(pcl::PCLPointCloud2& blob) const;

  void checkExtent() const;

  std::string path_;
  double unit_;
  std::size_t piece_bytes_;
  MappedFile file_;
  FileLayout layout_;
  std::vector<std::uint8_t> unpacked_; ///< rows of a file that is not mapped as it is
  const std::uint8_t* rows_ = nullptr;
  pcl::PCLPointCloud2 tidy_; ///< the form of the rows that are given out
  bool is_plain_ = false;    ///< whether they stand in the file like that
};

} // namespace tools
} // namespace sedr
} // namespace pcl
