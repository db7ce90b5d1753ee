// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>

#define BOOST_ALLOW_DEPRECATED_HEADERS // Boost.Geometry includes one
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/ring.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief The rectangle that a text occupies on paper, rotated with it; millimetres. */
struct TextBox {
  using Corner = boost::geometry::model::d2::point_xy<double>;
  using Outline = boost::geometry::model::ring<Corner>;

  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  Eigen::Vector2d half_size = Eigen::Vector2d::Zero();
  double degrees = 0; ///< counter-clockwise

  Outline outline() const;
  bool meets(const TextBox& other) const;
  bool meets(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;
};

/** @brief Returns half the width and height of lines of text over the font size, with
 * some space around. */
Eigen::Vector2d halfSizeOf(const std::vector<std::string>& lines);

/** @brief Returns the angle, degrees, at which text along a direction is readable from
 * below or from the right: above -70, up to 110, so that nearly vertical lines agree.
 */
double readableAngle(const Eigen::Vector2d& way);

/** @brief Occupied places of a page, beyond which there are none: texts, lines that
 * texts keep off, and lines that texts cross only where there is no other place. */
class TextPlaces {
public:
  TextPlaces() = default;

  /** @param size of the page, whose lower left corner is the origin, millimetres */
  explicit TextPlaces(const Eigen::Vector2d& size)
      : page_({0, 0}, {size.x(), size.y()})
  {}

  /** @brief Adds a line or arc that texts keep off. */
  void keepOff(const PlanElement& line) { addChords(line, lines_); }
  void keepOff(const Eigen::Vector2d& from, const Eigen::Vector2d& to)
  {
    add({from, to}, lines_);
  }

  /** @brief Adds a line that texts cross only where there is no other place. */
  void avoid(const PlanElement& line) { addChords(line, avoided_); }

  /** @brief Occupies the first of some rectangles that no text and no line is in; if
   * there is none, the first one that only lines to avoid are in. */
  std::optional<TextBox> takeFirst(const std::vector<TextBox>& boxes);

private:
  using Bounds = boost::geometry::model::box<TextBox::Corner>;
  template <typename ShapeT>
  using Tree = boost::geometry::index::rtree<std::pair<Bounds, ShapeT>,
                                             boost::geometry::index::quadratic<16>>;
  using Line = std::pair<Eigen::Vector2d, Eigen::Vector2d>;

  static Bounds boundsOf(const TextBox& box);
  static void add(const Line& line, Tree<Line>& lines);
  static void addChords(const PlanElement& line, Tree<Line>& lines);
  static bool meetsAny(const TextBox& box, const Tree<Line>& lines);
  bool isFree(const TextBox& box) const;

  Bounds page_{{-HUGE_VAL, -HUGE_VAL}, {HUGE_VAL, HUGE_VAL}};
  Tree<TextBox> taken_;
  Tree<Line> lines_;
  Tree<Line> avoided_;
};

/** @brief A place for text within a loop, as far as possible from the loop and from
 * what is in it, and that distance in metres. */
struct TextSpot {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  double radius = 0;
};

/** @brief Returns the place for text in a loop and outside of all obstacles. */
TextSpot textSpotIn(const PlanLoop& loop, const std::vector<PlanLoop>& obstacles);

/** @brief Returns the circle around a spot. */
PlanLoop circleAbout(const TextSpot& spot);

} // namespace pcl::sedr
