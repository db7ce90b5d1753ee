// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxel_frame.h"

#include <cstdint>

namespace pcl::sedr {

/** @brief Hashes the codes of a voxel; all bits can be used. */
inline std::uint64_t
hashOf(const VoxelCode& code)
{
  const auto widened = [](std::int32_t c) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(c));
  };
  std::uint64_t h = widened(code[0]) * 0x9e3779b97f4a7c15u +
                    widened(code[1]) * 0xc2b2ae3d27d4eb4fu +
                    widened(code[2]) * 0x165667b19e3779f9u;
  h ^= h >> 32;
  h *= 0xd6e8feb86659fd93u;
  return h ^ h >> 32;
}

/** @brief Checks whether two voxels are the same; faster than memcmp(). */
inline bool
isSame(const VoxelCode& a, const VoxelCode& b)
{
  return ((a[0] ^ b[0]) | (a[1] ^ b[1]) | (a[2] ^ b[2])) == 0;
}

} // namespace pcl::sedr
