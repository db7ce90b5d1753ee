// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formats/scan_formats.h"
#include "scan_settings.h"

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/scan_frame.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Converts stored points to rows of a cloud: no padding, x, y and z in metres
 * as FLOAT32. Unit and origin are applied in double precision. */
class RowPlan {
public:
  /** @param unit metres per unit of the file
   * @param shift subtracted from coordinates, metres */
  RowPlan(const StoredRow& stored, double unit, const Eigen::Vector3d& shift);

  const std::vector<pcl::PCLPointField>& fields() const { return fields_; }
  std::size_t rowSize() const { return row_size_; }

  /** @brief Returns whether rows are as stored. */
  bool isPlain() const { return is_plain_; }

  void convert(const std::uint8_t* stored, std::size_t rows, std::uint8_t* to) const;

private:
  /** @brief What becomes a field or, of a joined colour, a byte of one. */
  struct Move {
    StoredField from;
    std::size_t to = 0;
    bool is_number = false; ///< converted to a float; else its bytes are copied
    double unit = 1;
    double shift = 0;
  };

  void addField(const std::string& name, std::uint8_t datatype, std::size_t count = 1);
  void addColour(const StoredRow& stored);

  /** @brief Writes a field as floats. */
  void convert(const Move& move,
               const std::uint8_t* stored,
               std::size_t rows,
               std::uint8_t* to) const;

  std::vector<pcl::PCLPointField> fields_;
  std::vector<Move> moves_;
  std::size_t stored_size_;
  std::size_t row_size_ = 0;
  std::ptrdiff_t opaque_ = -1; ///< offset of an alpha that is not stored
  bool is_plain_ = true;
};

/** @brief Returns whether the points of a file are vertices of faces. Throws ToolError
 * if it is no scan. */
bool isMesh(const std::string& path);

/** @brief Returns whether PCL's writers, which print six digits, keep a place of whole
 * metres in VIEWPOINT. */
bool isKeptByPcl(const Eigen::Vector3d& place);

/** @brief x, y and z, metres, of some finite points of a scan. */
using ScanPlaces = std::array<std::vector<double>, 3>;

/** @brief A PCD, PLY, E57, LAS or text file, told by its content, that is read on
 * demand.
 *
 * Rows have every field of a PCD or PLY, and of other formats those that a stage uses.
 * x, y and z are FLOAT32 metres, without padding.
 * They are read piece by piece, so that a scan of any size takes the memory of two
 * pieces; only a binary_compressed PCD is unpacked into memory.
 *
 * Coordinates stored as doubles or integers, more than 1 km from 0, are relative to an
 * origin: the centre of the points, per axis, rounded to what PCL's writers keep: 1 m,
 * 10 m from 1,000 km on and 100 m from 10,000 km on. This is printed once per file.
 *
 * Of a mesh, the vertices are the points; a warning is printed once per file when the
 * first of them is read.
 *
 * Throws ToolError if the file is missing, a folder, no scan, cut off, damaged, without
 * x, y or z, without points or without finite points. It also throws if most
 * coordinates exceed 8388 m, where floats resolve no finer than 1 mm, and are floats
 * already or no origin may be subtracted. Up to 20,000 points are tested for this.
 * Files that shrink while they are read throw as well. */
class ScanFile : public RowSource {
public:
  /** @brief Opens a scan. Coordinates and viewpoint are converted to metres and made
   * relative to the origin in double precision, before conversion to float. */
  explicit ScanFile(const std::string& path, const ScanSettings& settings = {});

  const std::string& path() const { return path_; }

  const std::vector<pcl::PCLPointField>& fields() const override
  {
    return plan_->fields();
  }
  std::size_t rowSize() const override { return plan_->rowSize(); }
  std::size_t size() const override { return content_.points->size(); }
  void forEachPiece(const std::function<bool(const Piece&)>& see) const override
  {
    forEachPiece(0, size(), see);
  }

  /** @brief As above for the rows from `begin` to `end`. */
  void forEachPiece(std::size_t begin,
                    std::size_t end,
                    const std::function<bool(const Piece&)>& see) const
  {
    forEachStored(begin, end,
                  [&](const Piece& piece, const Chunk&) { return see(piece); });
  }

  /** @brief As above, also with the points as they are stored. */
  void forEachStored(std::size_t begin,
                     std::size_t end,
                     const std::function<bool(const Piece&, const Chunk&)>& see) const;

  /** @brief Returns the layout of stored points. */
  const StoredRow& storedRow() const { return content_.points->row(); }

  /** @brief Returns the field of the colour in rows, blue first; null if there is none.
   */
  const pcl::PCLPointField* colour() const
  {
    const auto* const rgb = pcl::sedr::findField(fields(), "rgb");
    return rgb ? rgb : pcl::sedr::findField(fields(), "rgba");
  }

  /** @brief Returns the origin of all coordinates. */
  const Origin& origin() const { return origin_; }

  /** @brief Returns the viewpoint of the scan, metres; 0, 0, 0 if it is unknown. */
  Eigen::Vector4f viewpoint() const;
  bool knowsViewpoint() const { return content_.viewpoint.has_value(); }
  const Eigen::Quaternionf& orientation() const { return content_.orientation; }

  /** @brief Returns the scanner position of each row, metres, in the rows' frame: from
   * the settings' file, else from the scan, possibly none. Throws ToolError if the file
   * is invalid or does not cover exactly all rows. */
  ScanPositions positions() const;

  /** @brief As above from a file of positions in the unit and frame of this scan, for
   * `rows` rows in all, which may include other scans. */
  ScanPositions positionsIn(const std::string& path, std::size_t rows) const;

private:
  void checkCoordinates() const;

  /** @brief Chooses the origin, and throws ToolError if coordinates are too large even
   * so. */
  void settleOrigin(const ScanSettings& settings);

  /** @brief Converts a place of the file to the coordinates of rows. */
  Eigen::Vector3f inMetres(const Eigen::Vector3d& place) const
  {
    return (unit_ * turn_ * place - shift_).cast<float>();
  }

  /** @brief Takes VIEWPOINT for the origin where it is far from 0 and the points are
   * not: PCL's own programs keep it, but not the comment of the origin. It is in metres
   * whatever the unit, as in the comment. */
  bool takeOriginFromViewpoint(const ScanPlaces& places);

  ScanPlaces samplePlaces() const;
  void addPlaces(std::size_t first, std::size_t size, ScanPlaces& places) const;

  std::string path_;
  std::string positions_; ///< file of positions, may be empty
  double unit_;
  std::size_t piece_bytes_;
  Eigen::Matrix3d turn_; ///< from the frame of the file to one with z up
  ScanContent content_;
  StoredRow row_; ///< of the content, in the frame with z up
  Eigen::Vector3d shift_ = Eigen::Vector3d::Zero(); ///< subtracted at reading, metres
  Origin origin_;               ///< shift_ plus what was subtracted before
  std::optional<RowPlan> plan_; ///< conversion to output rows
};

} // namespace pcl::sedr::tools
