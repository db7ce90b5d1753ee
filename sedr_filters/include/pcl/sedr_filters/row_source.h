// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PCLPointField.h>
#include <pcl/sedr_filters/point_view.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief A cloud that need not fit in memory. Its points, with all their fields as
 * rows of bytes, are delivered in pieces on request. */
class RowSource {
public:
  /** @brief A function to process the rows [begin, end) of a piece: each row once, in
   * any order, from several threads at once. */
  using SeeRun = std::function<void(std::size_t begin, std::size_t end)>;

  /** @brief Consecutive rows; valid until the next piece. */
  struct Piece {
    const std::uint8_t* rows = nullptr;
    std::size_t first = 0; ///< index of the first row in the whole cloud
    std::size_t size = 0;  ///< number of rows
    /// Optional; valid until `see` returns. Readers may call it for all rows, run by
    /// run, while they have them at hand, so the source need not read them again.
    SeeRun beside = {};
  };

  virtual ~RowSource() = default;

  /** @brief Returns the fields of a row, including x, y and z. */
  virtual const std::vector<pcl::PCLPointField>& fields() const = 0;

  /** @brief Returns the size of a row in bytes. */
  virtual std::size_t rowSize() const = 0;

  /** @brief Returns the total number of rows. */
  virtual std::size_t size() const = 0;

  /** @brief Returns why the rows cannot be read, as a sentence; empty if they can. */
  virtual std::string problem() const { return {}; }

  /** @brief Calls `see(piece)` for all pieces in order, until it returns false. May be
   * repeated and then gives the same pieces. Throws, as the source documents, if the
   * rows cannot be read. */
  virtual void forEachPiece(const std::function<bool(const Piece&)>& see) const = 0;
};

/** @brief Returns the field called `name`, null if there is none. */
const pcl::PCLPointField* findField(const std::vector<pcl::PCLPointField>& fields,
                                    const std::string& name);

/** @brief Access to the coordinates of rows: in place if x, y and z are consecutive
 * FLOAT32 fields, else as a copy. */
class RowCoordinates {
public:
  /** @param fields hold x, y and z, of any type */
  RowCoordinates(const std::vector<pcl::PCLPointField>& fields, std::size_t row_size);

  /** @brief Returns the coordinates of some rows, valid until the next call.
   * @param threads 0: all processors */
  PointView of(const std::uint8_t* rows, std::size_t size, unsigned threads = 0);

private:
  std::vector<pcl::PCLPointField> xyz_;
  std::size_t row_size_;
  std::vector<Eigen::Vector3f> copy_;
};

} // namespace pcl::sedr
