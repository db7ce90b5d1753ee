// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dxf_text.h"

#include <string>

namespace pcl {
namespace sedr {

/** @brief A dimension of a DXF, metres. */
struct DxfDimension {
  Eigen::Vector2d from; ///< what it is between
  Eigen::Vector2d to;
  Eigen::Vector2d start; ///< ends of its line
  Eigen::Vector2d end;
  Eigen::Vector2d text; ///< the middle of its text
  double degrees = 0;   ///< of its text
};

/** @brief Dimensions as entities that programs measure anew, and the blocks that show
 * them, which release 12 asks for. */
class DxfDimensions {
public:
  /** @brief Dimensions go on a layer, their text is `text_height` metres high. */
  DxfDimensions(std::string layer, double text_height)
      : layer_(std::move(layer))
      , text_height_(text_height)
  {}

  /** @brief Thin lines lead from its places to its line where that is apart. */
  void add(const DxfDimension& dimension);

  /** @brief The table of their style, between other tables. */
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

} // namespace sedr
} // namespace pcl
