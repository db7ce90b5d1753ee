// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bytes/input_file.h"
#include "sedr_filters/src/base/field_access.h"

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <iosfwd>
#include <string>

namespace pcl::sedr::tools {

namespace las {

/** Bytes of a point, and where its colour is, by point format; 0: it has none. */
inline constexpr std::array<std::size_t, 11> sizes{20, 28, 26, 34, 57, 63,
                                                   30, 36, 38, 59, 67};
inline constexpr std::array<std::size_t, 11> colours{0, 0,  20, 28, 0, 28,
                                                     0, 30, 30, 0,  30};

/** Bytes at which the numbers of a header stand. */
constexpr std::size_t encoding = 6;
constexpr std::size_t version = 24;
constexpr std::size_t software = 58; ///< that wrote it
constexpr std::size_t header_size = 94;
constexpr std::size_t begin = 96;         ///< of the points
constexpr std::size_t descriptions = 100; ///< how many records stand before the points
constexpr std::size_t format = 104;
constexpr std::size_t record = 105;
constexpr std::size_t points = 107; ///< then five numbers: by return
constexpr std::size_t scale = 131;
constexpr std::size_t shift = 155;
constexpr std::size_t bounds = 179;        ///< greatest and least x, y and z
constexpr std::size_t waveforms = 227;     ///< LAS 1.3
constexpr std::size_t after = 235;         ///< LAS 1.4: records after the points
constexpr std::size_t records_after = 243; ///< how many these are
constexpr std::size_t many_points = 247;   ///< then fifteen: by return

constexpr unsigned newest_minor = 4; ///< of version 1.x
constexpr std::size_t header_of_1_4 = 375;

} // namespace las

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
