// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dxf_text.h"

#include <string>

namespace pcl::sedr {

/** @brief A dimension of a DXF, metres. */
struct DxfDimension {
  Eigen::Vector2d from; ///< measured points
  Eigen::Vector2d to;
  Eigen::Vector2d start; ///< ends of its dimension line
  Eigen::Vector2d end;
  Eigen::Vector2d text; ///< centre of its text
  double degrees = 0;   ///< angle of its text
};

/** @brief Writes dimensions as entities that programs measure again, and the blocks
 * that display them, as release 12 requires. */
class DxfDimensions {
public:
  /** @brief Sets the layer and the text height, metres. */
  DxfDimensions(std::string layer, double text_height)
      : layer_(std::move(layer))
      , text_height_(text_height)
  {}

  /** @brief Adds a dimension, with extension lines where its line is apart from its
   * points. */
  void add(const DxfDimension& dimension);

  /** @brief Returns the table of the dimension style, one of the file's tables. */
  DxfText table() const;

  const DxfText& blocks() const { return blocks_; }
  const DxfText& entities() const { return entities_; }

private:
  std::string layer_;
  double text_height_;
  int count_ = 0;
  DxfText blocks_;
  DxfText entities_;
};

} // namespace pcl::sedr
