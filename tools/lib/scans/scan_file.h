// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud_readers.h"
#include "row_plan.h"

#include <pcl/sedr_filters/row_source.h>
#include <pcl/sedr_filters/scan_frame.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief What the head of a scan says. */
struct ScanHead {
  std::size_t rows = 0;
  bool is_in_pieces = false; ///< whether some rows can be had without the others
  bool is_mesh = false;      ///< whether the rows are vertices of faces
};

/** @brief Reads nothing but the head of a file; anything amiss with it is a ToolError.
 */
ScanHead readScanHead(const std::string& path, const ScanSettings& settings = {});

/** @brief x, y and z, metres, of some points of a scan that are finite. */
using ScanPlaces = std::array<std::vector<double>, 3>;

/** @brief A PCD, PLY or E57 file, told apart by its content, that is read as it is
 * needed.
 *
 * Its rows have every field of a PCD or PLY, of the others those that a stage keeps; x,
 * y and z as FLOAT32 metres, no padding. They come piece by piece from the mapped file,
 * and from there without a copy if they stand there as they are wanted; the pages of a
 * piece are given back while the next one is read, so that a scan of any size takes no
 * more memory than two pieces, and one more where they are copied. binary_compressed
 * and ascii are unpacked into memory first.
 *
 * Coordinates that the file has as doubles or whole numbers, and that lie more than 1
 * km from 0, are counted from an origin: whole metres in the middle of the points, for
 * each axis by itself. One line says so, once in a process.
 *
 * Of a mesh the vertices are the points, and a warning says so where the first of them
 * is read, once in a process.
 *
 * Anything amiss is a ToolError of one sentence: no such file, a folder, no
 * scan, cut off, damaged, no x, y or z, 0 points, no finite point, or most
 * coordinates so large that a float resolves them no finer than 1 mm (above 8388 m)
 * where they are floats already or no origin may be subtracted; that is told by up to
 * 20,000 of the points. A file that becomes shorter while it is read is one too. */
class ScanFile : public RowSource {
public:
  /** @brief Coordinates and viewpoint are brought to metres and counted from the
   * origin, in double precision, before anything is made a float. */
  explicit ScanFile(const std::string& path, const ScanSettings& settings = {});

  ScanFile(const std::string& path,
           double unit,
           std::size_t piece_bytes = ScanSettings().piece_bytes);

  const std::string& path() const { return path_; }

  const std::vector<pcl::PCLPointField>& fields() const override
  {
    return plan_->fields();
  }
  std::size_t rowSize() const override { return plan_->rowSize(); }
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

  /** @brief What all coordinates are counted from. */
  const Origin& origin() const { return origin_; }

  /** @brief Where the scan was seen from, metres. */
  Eigen::Vector4f viewpoint() const;
  const Eigen::Quaternionf& orientation() const { return layout_.orientation; }

  /** @brief Where its parts were seen from, metres, where the file tells that of all.
   */
  std::vector<ScanStation> stations() const;

  /** @brief Where the rows were scanned from, metres, in their frame: by the file of
   * the settings, else by what the scan tells, which may be nothing. A file that is
   * amiss, or that tells of other than all rows, is a ToolError. */
  ScanPositions positions() const;

  /** @brief The same by a file of positions, in the unit and frame of this scan, of
   * `rows` rows in all: it may have been scanned together with others. */
  ScanPositions positionsIn(const std::string& path, std::size_t rows) const;

private:
  class PageTurner;

  /** @brief Some rows as they stand in the file, but for the byte order. */
  pcl::PCLPointCloud2 rawRows(std::size_t first, std::size_t size) const;

  /** @brief Brings rows into the form that is given out. */
  void tidyRows(std::size_t first, std::size_t size, std::uint8_t* rows) const;

  /** @brief Decides what coordinates are counted from, and refuses those that even so
   * are too large. */
  void settleOrigin(const ScanSettings& settings);

  /** @brief A place of the file as its rows are given out. */
  Eigen::Vector3f inMetres(const Eigen::Vector3d& place) const
  {
    return (unit_ * place - shift_).cast<float>();
  }

  ScanPlaces samplePlaces() const;
  void addPlaces(std::size_t first, std::size_t size, ScanPlaces& places) const;

  /** @brief The bytes of rows in the file: where they begin. */
  std::size_t placeOf(std::size_t row) const;

  std::string path_;
  std::string positions_; ///< file of them, may be empty
  double unit_;
  std::size_t piece_bytes_;
  MappedFile file_;
  FileLayout layout_;
  std::vector<std::uint8_t> unpacked_; ///< rows of a file that is not mapped as it is
  const std::uint8_t* rows_ = nullptr;
  Eigen::Vector3d shift_ = Eigen::Vector3d::Zero(); ///< subtracted at reading, metres
  Origin origin_;                 ///< that and what was subtracted before
  std::unique_ptr<RowPlan> plan_; ///< of the rows that are given out
  bool is_plain_ = false;         ///< whether they stand in the file like that
};

} // namespace tools
} // namespace sedr
} // namespace pcl
