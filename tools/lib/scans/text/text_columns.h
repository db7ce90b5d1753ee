// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bytes/input_file.h"
#include "formats/point_reader.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Layout of a text with a point a line. */
struct TextColumns {
  std::string format = "columns of numbers"; ///< its name in messages
  std::size_t begin = 0;                     ///< byte of the first line of numbers
  StoredRow row;                             ///< x, y and z are doubles
  std::vector<std::size_t> columns;          ///< of each value of the row
  std::size_t numbers = 0;                   ///< that are read of a line
  bool has_decimal_commas = false;           ///< which separate no columns
  bool is_exact = false;                     ///< whether lines hold nothing else
  std::optional<std::uint64_t> points;       ///< number of points, if a header tells it
  bool are_last = true;                      ///< whether nothing follows these points

  /** @brief Returns the layout of an ascii PCD or PLY, whose header is read. */
  static TextColumns ofHeader(const std::string& format,
                              const StoredRow& row,
                              std::size_t begin,
                              std::uint64_t points,
                              bool are_last = true);

  /** @brief Determines the layout of a text, see openText(). Throws ToolError if x, y
   * or z is missing. */
  static TextColumns find(const InputFile& file, const std::string& asked);
};

/** @brief Reads up to `most` numbers of a line.
 * @param is_all gets whether the line holds nothing but these numbers, if given
 * @return how many there are before the end of the line, an empty cell or a word */
std::size_t readColumns(std::string_view line,
                        std::size_t most,
                        double* numbers,
                        bool* is_all = nullptr);

/** @brief Returns whether a line may hold numbers: it is neither empty nor a
 * comment. */
bool mayHoldNumbers(std::string_view line);

/** @brief Returns whether a line is a whole number alone, as the count of points before
 * those of a PTS file. */
bool isCount(std::string_view line);

} // namespace pcl::sedr::tools
