// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dxf_text.h"

#include <pcl/sedr_filters/floorplan.h>

#include <string>

namespace pcl {
namespace sedr {

/** @brief Dimensions as entities that programs measure anew, and the blocks that show
 * them, which release 12 asks for. */
class DxfDimensions {
public:
  /** @brief Dimensions go on a layer, their text is `text_height` metres high. */
  DxfDimensions(std::string layer, double text_height)
      : layer_(std::move(layer))
      , text_height_(text_height)
  {}

  /** @brief Adds the length of a straight wall; its line lies to the left, within the
   * room. Nothing where the text would be longer than the wall. */
  void addWall(const PlanElement& wall);

  /** @brief Adds the length between two places of a line beside the plan, which the
   * line is parallel to.
   * @param from,to where thin lines begin: corners of the plan
   * @param on_line a place that the dimension's line runs through */
  void addBeside(const Eigen::Vector2d& from,
                 const Eigen::Vector2d& to,
                 const Eigen::Vector2d& way,
                 const Eigen::Vector2d& on_line);

  /** @brief The table of their style, between other tables. */
  DxfText table() const;

  const DxfText& blocks() const { return blocks_; }
  const DxfText& entities() const { return entities_; }

private:
  /** @param start,end ends of the dimension's line */
  void add(const Eigen::Vector2d& from,
           const Eigen::Vector2d& to,
           const Eigen::Vector2d& start,
           const Eigen::Vector2d& end,
           bool is_text_left);

  std::string layer_;
  double text_height_;
  int count_ = 0;
  DxfText blocks_;
  DxfText entities_;
};

} // namespace sedr
} // namespace pcl
