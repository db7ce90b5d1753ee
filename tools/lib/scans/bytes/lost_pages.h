// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace pcl::sedr::tools {

/** @brief Guards a mapping of a file. Pages that cannot be read, because the file has
 * shrunk or its disk failed, become zeros instead of ending the program (SIGBUS). At
 * most 64 mappings are guarded at once. */
class LostPages {
public:
  LostPages(const void* begin, std::size_t size);
  ~LostPages();
  LostPages(const LostPages&) = delete;
  LostPages& operator=(const LostPages&) = delete;

  /** @brief Returns whether any page was replaced. */
  bool any() const;

private:
  std::size_t place_; ///< index in the table of mappings
};

} // namespace pcl::sedr::tools
