// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PCLPointField.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

namespace pcl {

template <typename PointT>
class PointCloud;

namespace sedr {

/** @brief A view of the coordinates of a cloud of any point type, without a copy.
 * Algorithms read points through it and do not depend on PCL. Valid as long as the
 * cloud. */
class PointView {
public:
  PointView() = default;

  /** @brief Views `size` points, `stride` bytes apart. The x of the first point, a
   * float, is at `first_x`; y and z follow x. No alignment is needed. */
  PointView(const void* first_x, std::size_t stride, std::size_t size)
      : first_(static_cast<const char*>(first_x))
      , stride_(stride)
      , size_(size)
  {}

  template <typename PointT>
  explicit PointView(const pcl::PointCloud<PointT>& cloud)
      : PointView(cloud.empty() ? nullptr : &cloud[0].x, sizeof(PointT), cloud.size())
  {}

  std::size_t size() const { return size_; }

  Eigen::Vector3f operator[](std::size_t i) const
  {
    Eigen::Vector3f p;
    std::memcpy(p.data(), first_ + i * stride_, 3 * sizeof(float));
    return p;
  }

  bool isFinite(std::size_t i) const
  {
    const Eigen::Vector3f p = (*this)[i];
    return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
  }

private:
  const char* first_ = nullptr;
  std::size_t stride_ = 0;
  std::size_t size_ = 0;
};

} // namespace sedr
} // namespace pcl

namespace pcl::sedr {

/** @brief A cloud that need not fit in memory. Its points, with all their fields as
 * rows of bytes, are delivered in pieces on request. */
class RowSource {
public:
  /** @brief Consecutive rows; valid until the next piece. */
  struct Piece {
    const std::uint8_t* rows = nullptr;
    std::size_t first = 0; ///< index of the first row in the whole cloud
    std::size_t size = 0;  ///< number of rows
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
