// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief The CRC-32C (Castagnoli) of some bytes, as RFC 3720 defines it: the
 * polynomial 0x1edc6f41, reflected, begun with and finally inverted by 0xffffffff.
 * Eight bytes a step, which is several times as fast as Boost.CRC's one. */
std::uint32_t crc32c(const std::uint8_t* bytes, std::size_t size);

} // namespace tools
} // namespace sedr
} // namespace pcl
