// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PCLPointField.h>
#include <pcl/sedr_filters/point_view.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A cloud that need not stand in memory: its points, with all their fields, row
 * after row, come in pieces as they are asked for. */
class RowSource {
public:
  /** @brief What is to be done with the rows [begin, end) of a piece; each row once, in
   * any order, from several threads at once. */
  using SeeRun = std::function<void(std::size_t begin, std::size_t end)>;

  /** @brief Rows one after the other; valid until the next piece. */
  struct Piece {
    const std::uint8_t* rows = nullptr;
    std::size_t first = 0; ///< number of the first of them in the whole cloud
    std::size_t size = 0;  ///< how many there are
    /// May be set, and holds until `see` returns: whoever reads the rows may call it
    /// for all of them, run by run as they are at hand, which spares the source to read
    /// them once more.
    SeeRun beside = {};
  };

  virtual ~RowSource() = default;

  /** @brief The fields of a row, x, y and z among them. */
  virtual const std::vector<pcl::PCLPointField>& fields() const = 0;

  /** @brief Bytes from one row to the next. */
  virtual std::size_t rowSize() const = 0;

  /** @brief Rows in all. */
  virtual std::size_t size() const = 0;

  /** @brief What keeps the rows from being read, a sentence; empty if nothing does. */
  virtual std::string problem() const { return {}; }

  /** @brief Calls `see(piece)` for all pieces in their order, until it returns false.
   * May be called again, and gives the same then. What cannot be read is thrown, as the
   * source says. */
  virtual void forEachPiece(const std::function<bool(const Piece&)>& see) const = 0;
};

/** @brief The field called `name`, null if there is none. */
const pcl::PCLPointField* findField(const std::vector<pcl::PCLPointField>& fields,
                                    const std::string& name);

/** @brief Sees the coordinates of rows: where they stand, if x, y and z are FLOAT32 one
 * after the other, or as a copy. */
class RowCoordinates {
public:
  /** @param fields hold x, y and z, of any type */
  RowCoordinates(const std::vector<pcl::PCLPointField>& fields, std::size_t row_size);

  /** @brief The coordinates of some rows, until the next call; `threads` 0: all. */
  PointView of(const std::uint8_t* rows, std::size_t size, unsigned threads = 0);

private:
  std::vector<pcl::PCLPointField> xyz_;
  std::size_t row_size_;
  std::vector<Eigen::Vector3f> copy_;
};

} // namespace sedr
} // namespace pcl
