// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "canvas.h"

#include <pcl/sedr_filters/cell_grid.h>
#include <pcl/sedr_filters/floorplan.h>

#include <array>
#include <string>
#include <variant>
#include <vector>

namespace pcl::sedr::tools {

/** @brief A projected triangle: x to the right, y up, depth away from the viewer. */
struct ViewedTriangle {
  std::array<Eigen::Vector3d, 3> corners;
  Colour colour;
};

/** @brief A part of a picture: shapes in metres, later ones on top, x to the right and
 * y up. A map has the same scale on both axes and a scale bar. A chart scales each axis
 * separately and has numbers along them. */
class Panel {
public:
  explicit Panel(std::string panel_title)
      : title(std::move(panel_title))
  {}

  /** @brief Turns the panel into a chart with this title of its x axis. */
  void setAxis(const std::string& along_x);

  bool isChart() const { return is_chart_; }
  const std::string& xAxis() const { return x_axis_; }

  void addBoxes(std::vector<Box> boxes, Colour colour);

  void addCells(const CellSet& cells, double cell_size, Colour colour);

  void addPoints(std::vector<Eigen::Vector2d> points, Colour colour, double pixels = 2);

  /** @brief Adds a polyline, `pixels` wide. */
  void addPath(std::vector<Eigen::Vector2d> points, Colour colour, double pixels = 1.5);

  /** @brief Adds the elements of a loop: segments in one colour, arcs in another. */
  void addLoop(const PlanLoop& loop, Colour segments, Colour arcs, double pixels = 1.5);

  void addTriangles(std::vector<ViewedTriangle> triangles);

  /** @brief Adds a text at a place, unless it overlaps an earlier label of the
   * panel. */
  void addLabel(const Eigen::Vector2d& place,
                const std::string& text,
                Colour colour = colours::ink,
                Anchor anchor = Anchor::Middle);

  /** @brief Sets the visible part of the plane; default: all shapes with a margin. */
  void setView(const Box& view) { view_ = view; }

  /** @brief Returns the visible part, never empty. */
  Box view() const;

  /** @brief Draws the content of the panel into a box of pixels. */
  void draw(Canvas& canvas, const Box& pixels) const;

  std::string title;

private:
  struct Boxes {
    std::vector<Box> boxes;
    Colour colour;
  };
  struct Points {
    std::vector<Eigen::Vector2d> points;
    Colour colour;
    double pixels;
  };
  struct Path {
    std::vector<Eigen::Vector2d> points;
    Colour colour;
    double pixels;
  };
  struct Label {
    Eigen::Vector2d place;
    std::string text;
    Colour colour;
    Anchor anchor;
  };
  using Triangles = std::vector<ViewedTriangle>;

  /** @brief Maps metres to pixels. */
  struct Frame;

  static void draw(const Boxes& layer, const Frame& frame, Canvas& canvas);
  static void draw(const Points& layer, const Frame& frame, Canvas& canvas);
  static void draw(const Path& layer, const Frame& frame, Canvas& canvas);
  static void draw(const Triangles& layer, const Frame& frame, Canvas& canvas);

  void drawLabels(const Frame& frame, Canvas& canvas) const;

  Box view_;
  Box bounds_; ///< of all shapes
  std::vector<std::variant<Boxes, Points, Path, Triangles>> layers_;
  std::vector<Label> labels_;
  bool is_chart_ = false;
  std::string x_axis_;
};

/** @brief Returns the extent of cells without outliers, since a scan may hold points
 * hundreds of metres away. One in a thousand cells at each end is cut off if that
 * halves the view.
 * @return empty for no cells */
Box viewOf(const CellSet& cells, double cell_size);

/** @brief Returns the extent of connected pieces of at least `least` cells; viewOf() if
 * there are none. */
Box viewOfPieces(const CellSet& cells, double cell_size, std::size_t least);

} // namespace pcl::sedr::tools
