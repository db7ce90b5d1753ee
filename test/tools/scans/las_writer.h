// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace programs {

/** A LAS file for tests: its header fields and points. */
struct LasSample {
  std::uint8_t minor = 2;
  std::uint8_t format = 0;
  std::uint16_t record = 20;
  std::uint16_t colour_offset = 0; ///< 0: none
  std::array<double, 3> scale{0.001, 0.001, 0.001};
  std::array<double, 3> shift{0, 0, 0};
  std::vector<std::array<std::int32_t, 3>> points;
  std::array<std::uint16_t, 3> colour{0, 0, 0};
  std::uint16_t intensity = 0;
  std::string before; ///< bytes between header and points
  long long claimed_points = -1;

  std::string bytes() const
  {
    const std::size_t header_size = minor >= 4 ? 375 : minor == 3 ? 235 : 227;
    std::string file(header_size, '\0');
    const auto put = [&file](std::size_t at, auto value) {
      file.replace(at, sizeof value, reinterpret_cast<const char*>(&value),
                   sizeof value);
    };
    const auto count = claimed_points >= 0 ? static_cast<std::uint64_t>(claimed_points)
                                           : points.size();
    file.replace(0, 4, "LASF");
    put(24, std::uint8_t{1});
    put(25, minor);
    put(94, static_cast<std::uint16_t>(header_size));
    put(96, static_cast<std::uint32_t>(header_size + before.size()));
    put(104, format);
    put(105, record);
    if (minor < 4 || format < 6)
      put(107, static_cast<std::uint32_t>(count));
    if (minor >= 4)
      put(247, count);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      put(131 + 8 * axis, scale[axis]);
      put(155 + 8 * axis, shift[axis]);
    }
    file += before;
    for (const auto& point : points) {
      const std::size_t at = file.size();
      file.resize(at + record, '\7');
      put(at, point);
      put(at + 12, intensity);
      if (colour_offset > 0)
        put(at + colour_offset, colour);
    }
    return file;
  }
};

} // namespace programs
