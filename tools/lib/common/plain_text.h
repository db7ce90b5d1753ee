// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

namespace pcl::sedr::tools {

/** @brief Makes a text from a file printable: control characters and bytes that are no
 * UTF-8 become `\x1b`, and what follows the first `most` bytes becomes `...`. */
std::string plainText(std::string_view text,
                      std::size_t most = std::numeric_limits<std::size_t>::max());

/** @brief Quotes a word or name from a file in a message: printable, at most 40 bytes,
 * in single quotes. */
std::string quotedWord(std::string_view word);

} // namespace pcl::sedr::tools
