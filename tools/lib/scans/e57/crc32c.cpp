// SPDX-License-Identifier: BSD-3-Clause
#include "crc32c.h"

#include <array>
#include <cstring>

namespace pcl::sedr::tools {

namespace {

constexpr std::size_t lanes = 8; // bytes per step
using Tables = std::array<std::array<std::uint32_t, 256>, lanes>;

/** @brief Tabulates the effect of a byte on the remainder when 0 to 7 bytes follow. */
constexpr Tables
makeTables()
{
  constexpr std::uint32_t reflected_polynomial = 0x82f63b78;
  Tables tables{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t rest = byte;
    for (int bit = 0; bit < 8; ++bit)
      rest = rest >> 1 ^ ((rest & 1) != 0 ? reflected_polynomial : 0);
    tables[0][byte] = rest;
  }
  for (std::size_t lane = 1; lane < lanes; ++lane)
    for (std::size_t byte = 0; byte < 256; ++byte) {
      const std::uint32_t before = tables[lane - 1][byte];
      tables[lane][byte] = before >> 8 ^ tables[0][before & 0xff];
    }
  return tables;
}

constexpr Tables tables = makeTables();

} // namespace

std::uint32_t
crc32c(const std::uint8_t* bytes, std::size_t size)
{
  std::uint32_t rest = 0xffffffff;
  for (; size >= lanes; bytes += lanes, size -= lanes) {
    std::uint64_t step = 0;
    std::memcpy(&step, bytes, sizeof step); // little-endian, like all of PCL's files
    step ^= rest;
    rest = 0;
    for (std::size_t k = 0; k < lanes; ++k)
      rest ^= tables[lanes - 1 - k][step >> 8 * k & 0xff];
  }
  for (; size > 0; ++bytes, --size)
    rest = rest >> 8 ^ tables[0][(rest ^ *bytes) & 0xff];
  return ~rest;
}

} // namespace pcl::sedr::tools
