// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief Watches a mapping of a file: pages that cannot be read, because the file has
 * become shorter or its disk has failed, become zeros in place of ending the program
 * (SIGBUS). Up to 64 mappings at once; others are as without it. */
class LostPages {
public:
  LostPages(const void* begin, std::size_t size);
  ~LostPages();
  LostPages(const LostPages&) = delete;
  LostPages& operator=(const LostPages&) = delete;

  /** @brief Whether there were such pages. */
  bool any() const;

private:
  std::size_t place_; ///< in the table of mappings
};

} // namespace tools
} // namespace sedr
} // namespace pcl
