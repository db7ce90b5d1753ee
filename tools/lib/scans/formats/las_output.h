// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bytes/input_file.h"
#include "las_layout.h"
#include "sedr_filters/src/base/field_access.h"

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <iosfwd>
#include <string>

namespace pcl::sedr::tools {

struct PointTag;

/** @brief What stands before the points of a LAS file: its header, and records that
 * describe them. */
struct LasHead {
  std::string bytes;

  template <typename T>
  T get(std::size_t place) const
  {
    T value{};
    bytes.copy(reinterpret_cast<char*>(&value), sizeof value, place);
    return value;
  }

  template <typename T>
  void set(std::size_t place, T value)
  {
    bytes.replace(place, sizeof value, reinterpret_cast<const char*>(&value),
                  sizeof value);
  }

  unsigned format() const { return get<std::uint8_t>(las::format); }

  /** @brief Returns whether points have the same layout as those of another file, and
   * no waveforms, which stand elsewhere. */
  bool isLike(const LasHead& other) const
  {
    const auto isSame = [&](std::size_t from, std::size_t to) {
      return bytes.compare(from, to - from, other.bytes, from, to - from) == 0;
    };
    const bool has_waveforms =
        format() == 4 || format() == 5 || format() == 9 || format() == 10;
    return !has_waveforms && isSame(las::version, las::version + 2) &&
           isSame(las::format, las::points) && isSame(las::scale, las::bounds);
  }
};

/** @brief Writes a LAS file whose points have their tags as extra bytes: its head and
 * the points, then the head again, with what became known. */
class LasOutput {
public:
  /** @param before of points without tags */
  LasOutput(std::ostream& stream, LasHead before);

  /** @brief Writes a point with its tag and the class of ASPRS that fits it. Throws
   * ToolError if a room has no number of 16 bits.
   * @param record of the point, without a tag */
  void add(const std::uint8_t* record, const PointTag& tag);

  /** @brief Copies what stands behind the points of a file, which end at a byte. */
  void addRest(const InputFile& file, std::size_t end);

  /** @brief Writes the head again, which counts the points and tells their bounds. */
  void finish();

private:
  void describeTags();

  template <typename T>
  void setCounts(std::size_t from, std::size_t to);

  std::ostream& stream_;
  LasHead head_;
  std::size_t size_; ///< of a point without its tag
  bool is_old_;      ///< of a format of LAS 1.3 or older
  std::uint64_t points_ = 0;
  std::array<std::uint64_t, 15> returns_{};
  Eigen::AlignedBox<int, 3> bounds_; ///< steps
  std::string bytes_;
};

} // namespace pcl::sedr::tools
