// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dxf_text.h"

#include <pcl/sedr_filters/floorplan.h>

#include <string>

namespace pcl {
namespace sedr {

/** @brief Dimensions along straight walls, as entities that programs measure anew,
 * and the blocks that show them, which release 12 asks for. */
class DxfDimensions {
public:
  /** @brief Dimensions go on a layer, their text is `text_height` metres high. */
  DxfDimensions(std::string layer, double text_height)
      : layer_(std::move(layer))
      , text_height_(text_height)
  {}

  /** @brief Adds the length of a segment; its line lies to the left, within the room.
   * Nothing where the text would be longer than the segment. */
  void add(const PlanElement& segment);

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
