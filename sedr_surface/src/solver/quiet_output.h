// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdio>

namespace pcl {
namespace sedr {

/** @brief Takes what is printed to C's stdout and stderr from construction to finish().
 *
 * pcl::Poisson prints its troubles with printf, line upon line, and has no switch for
 * it. With glibc both streams are variables that can point elsewhere; with other C
 * libraries nothing is taken. std::cout and std::cerr go their way. What other threads
 * print with printf in the meantime is held back and printed by finish(). One at a
 * time. */
class QuietOutput {
public:
  QuietOutput();

  /** @brief Calls finish(). */
  ~QuietOutput();

  QuietOutput(const QuietOutput&) = delete;
  QuietOutput& operator=(const QuietOutput&) = delete;

  /** @brief Gives both streams back, prints the lines that are none of pcl::Poisson's,
   * and returns how many were. Later calls return the same. */
  std::size_t finish();

private:
  std::FILE* out_ = nullptr; ///< the streams as they were, null when given back
  std::FILE* err_ = nullptr;
  std::size_t complaints_ = 0;
};

} // namespace sedr
} // namespace pcl
