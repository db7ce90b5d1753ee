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

/** @brief Takes memory that holds nothing yet from the system, by large pages where it
 * gives them, on up to `threads` threads (0 = all): whoever fills it then need not wait
 * for it. Some of its bytes are zero after that. */
void takeLarge(void* begin, std::size_t bytes, unsigned threads);

/** @brief Empties a vector, and reserves and takes the memory for `size` values, plain
 * ones, with which it will soon be filled. O(bytes); `threads` 0 = all. */
template <typename Values>
void
reserveLarge(Values& values, std::size_t size, unsigned threads)
{
  values.clear();
  values.reserve(size);
  takeLarge(values.data(), size * sizeof(typename Values::value_type), threads);
}

} // namespace sedr
} // namespace pcl
