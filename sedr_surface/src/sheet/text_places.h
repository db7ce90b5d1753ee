// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief The rectangle that some text takes up on paper, turned with it; millimetres.
 */
struct TextBox {
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  Eigen::Vector2d half_size = Eigen::Vector2d::Zero();
  double degrees = 0; ///< against the clock

  Eigen::Vector2d way() const;
  bool meets(const TextBox& other) const;
  bool meets(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;
};

/** @brief Half the width and height of some lines of text, over the size of the font.
 * With a reserve: where a viewer has no Helvetica, its letters are wider. */
Eigen::Vector2d halfSizeOf(const std::vector<std::string>& lines);

/** @brief The angle, degrees, at which text along a way is read from below or from the
 * right: above -89, up to 91, so that walls not quite vertical agree. */
double readableAngle(const Eigen::Vector2d& way);

/** @brief The places of a page that texts stand in, and lines that they keep off. */
class TextPlaces {
public:
  /** @brief Texts do not stand on these; arcs by chords. */
  void keepOff(const PlanLoop& loop);
  void keepOff(const Eigen::Vector2d& from, const Eigen::Vector2d& to)
  {
    lines_.emplace_back(from, to);
  }

  /** @brief Takes a rectangle.
   * @return false where another text stands there already, or a line */
  bool take(const TextBox& box);

  /** @brief Takes the first of some rectangles that is free. */
  std::optional<TextBox> takeFirst(const std::vector<TextBox>& boxes);

private:
  std::vector<TextBox> taken_;
  std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> lines_;
};

} // namespace sedr
} // namespace pcl
