// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bytes/mapped_file.h"

#include <string>
#include <string_view>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief How a text of columns of numbers is to be read. */
struct TextColumns {
  std::vector<std::string> names; ///< of the columns; "_" is skipped
  std::size_t begin = 0;          ///< of the first line of numbers, bytes
  bool has_decimal_comma = false; ///< then semicolons or blanks part columns
};

/** @brief Whether a file seems to be columns of numbers: no byte that no text has, and
 * at least three numbers in one of the first lines. */
bool looksLikeColumns(const MappedFile& file);

/** @brief Finds what the columns of a text are: as `asked`, names parted by blanks or
 * commas, says; as a line of names before the numbers does, such as "//X Y Z Intensity"
 * or "x,y,z"; else x y z, then intensity (of 4 columns), red green blue (of 6, if they
 * are whole numbers up to 255) or both (of 7). What lacks x, y or z is a ToolError. */
TextColumns
findColumns(const MappedFile& file, const std::string& path, const std::string& asked);

/** @brief Reads up to `most` numbers of a line.
 * @return how many there are before the end of the line or something else */
std::size_t readColumns(std::string_view line,
                        bool has_decimal_comma,
                        std::size_t most,
                        double* numbers);

/** @brief Whether a line may hold numbers: it is not empty and no comment. */
bool mayHoldNumbers(std::string_view line);

} // namespace tools
} // namespace sedr
} // namespace pcl
