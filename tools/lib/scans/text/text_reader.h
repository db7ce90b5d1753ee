// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bytes/input_file.h"
#include "formats/scan_formats.h"

#include <cstdint>
#include <memory>
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

/** @brief The points of a text, one a line. Empty lines, comments (# and //) and
 * counts of points are skipped. All lines are counted at first; where every 256 KiB
 * begin is remembered, so that these blocks can be read in any order and by several
 * threads. */
class TextReader : public PointReader {
public:
  TextReader(std::shared_ptr<const InputFile> file, const TextColumns& columns);

protected:
  void read(Chunk& chunk) const override;

private:
  /** @brief Lines that follow one another. */
  struct Block {
    std::size_t begin = 0; ///< byte in the file
    std::size_t first = 0; ///< number of the first point
  };

  void findBlocks();
  std::string textOf(std::size_t block) const;
  bool holdsPoint(std::string_view line) const;
  void checkPoints() const;

  /** @brief Reads the points of a block that are in the chunk. */
  void readBlock(std::size_t block, Chunk& chunk) const;
  void readLine(std::string_view line, std::size_t point, double* numbers) const;

  [[noreturn]] void refuse(const std::string& reason) const;

  std::shared_ptr<const InputFile> file_;
  TextColumns columns_;
  std::vector<Block> blocks_; ///< the last one is empty, at the end
};

} // namespace pcl::sedr::tools
