// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

namespace pcl {
namespace sedr {

/** @brief Takes what the process prints to stdout and stderr from construction to
 * finish().
 *
 * pcl::Poisson prints its troubles with printf, line upon line; nothing but the file
 * descriptors can stop that. They belong to the whole process: what other threads print
 * in the meantime is held back and printed by finish(). Without a temporary file to
 * print into, nothing is taken. */
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
  /** @brief A stream that goes into a file for the time being. */
  struct Diversion {
    int descriptor = -1; ///< 1 or 2
    int kept = -1;       ///< duplicate of where it led before
    int file = -1;       ///< where it leads now
  };

  static Diversion divert(int descriptor);

  static std::string restore(Diversion& diversion);

  Diversion out_;
  Diversion err_;
  std::size_t complaints_ = 0;
};

} // namespace sedr
} // namespace pcl
