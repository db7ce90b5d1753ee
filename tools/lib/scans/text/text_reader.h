// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formats/point_reader.h"
#include "text_columns.h"

#include <memory>

namespace pcl::sedr::tools {

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
