// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace pcl {
namespace sedr {

/** @brief What a processor's large pages hold, bytes. */
constexpr std::size_t large_page = std::size_t{1} << 21;

/** @brief Tells the system that all of this memory will soon be written for the first
 * time: it may then give it by large pages, which takes a small part of the time. A
 * hint, that changes nothing else. */
void expectLarge(void* begin, std::size_t bytes);

/** @brief Resizes an empty vector, in memory that is expected to be written at once. */
template <typename VectorT>
void
resizeLarge(VectorT& vector, std::size_t size)
{
  vector.reserve(size);
  expectLarge(vector.data(), size * sizeof(vector[0]));
  vector.resize(size);
}

} // namespace sedr
} // namespace pcl
