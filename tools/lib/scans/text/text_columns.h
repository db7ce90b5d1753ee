// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bytes/mapped_file.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Layout of a text with columns of numbers. */
struct TextColumns {
  std::vector<std::string> names; ///< of the columns; "_" is skipped
  std::size_t begin = 0;          ///< byte offset of the first line of numbers
  bool has_decimal_comma = false; ///< separators are then semicolons or blanks
  std::size_t numbers = 0;        ///< in the first line, also those without a name
  bool is_nothing_else = false;   ///< whether that line holds nothing but numbers
  bool has_counts = false; ///< whether lines with the number of points are before them
  std::uint64_t promised = 0; ///< the first such number
};

/** @brief Returns whether a file seems to be columns of numbers: no byte that text
 * cannot contain, and at least three numbers in one of the first lines. */
bool looksLikeColumns(const MappedFile& file);

/** @brief Determines the columns of a text.
 *
 * `asked`, names separated by blanks or commas, comes first. Else a line of names
 * before the numbers counts, such as "//X Y Z Intensity" or "x,y,z". The default, if
 * there are only comments before the numbers, is x y z, then intensity (4 columns), red
 * green blue (6 columns, if integers up to 255) or both (7 columns). Throws ToolError
 * without x, y or z. */
TextColumns
findColumns(const MappedFile& file, const std::string& path, const std::string& asked);

/** @brief Reads up to `most` numbers of a line.
 * @param is_all gets whether the line holds nothing but these numbers, if given
 * @return how many there are before the end of the line, an empty cell or a word */
std::size_t readColumns(std::string_view line,
                        bool has_decimal_comma,
                        std::size_t most,
                        double* numbers,
                        bool* is_all = nullptr);

/** @brief Reads a line with nothing but the number of points that follow.
 * @return whether it is one; else `count` is not changed */
bool readCount(std::string_view line, std::uint64_t& count);

/** @brief Returns whether a line may hold numbers: it is neither empty nor a
 * comment. */
bool mayHoldNumbers(std::string_view line);

} // namespace pcl::sedr::tools
