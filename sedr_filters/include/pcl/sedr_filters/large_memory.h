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

} // namespace sedr
} // namespace pcl
