// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colour.h"

#include "sedr_surface/src/sheet/sheet.h"
#include <pcl/sedr_filters/cell_grid.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace pcl::sedr::tools {

using Box = Eigen::AlignedBox2d;
using Places = std::vector<Eigen::Vector2d>;

/** @brief A part of a picture: shapes in metres, later ones on top, x to the right and
 * y up. A map has the same scale on both axes and a scale bar. A chart scales each axis
 * separately and has numbers along them. */
class Panel {
public:
  explicit Panel(std::string panel_title)
      : title(std::move(panel_title))
  {}

  /** @brief Turns the panel into a chart with this title of its x axis. */
  void setAxis(const std::string& along_x) { x_axis_ = along_x; }

  bool isChart() const { return !x_axis_.empty(); }
  const std::string& xAxis() const { return x_axis_; }

  void addBoxes(std::vector<Box> boxes, Colour colour);

  void addCells(const CellSet& cells, double cell_size, Colour colour);

  /** @brief Adds points as squares of `pixels` pixels. */
  void addPoints(Places points, Colour colour, double pixels = 2);

  /** @brief Adds a polyline, `pixels` wide. */
  void addPath(const Places& points, Colour colour, double pixels = 1.5);

  /** @brief Adds the elements of a loop: segments in one colour, arcs in another. */
  void addLoop(const PlanLoop& loop, Colour segments, Colour arcs, double pixels = 1.5);

  /** @brief Adds triangles, the farthest first. */
  void addTriangles(std::vector<SheetTriangle> triangles);

  /** @brief Adds a text at a place, unless it overlaps an earlier label of the panel.
   */
  void addLabel(const Eigen::Vector2d& place,
                const std::string& text,
                Colour colour = colours::ink,
                TextAnchor anchor = TextAnchor::Middle);

  /** @brief Sets the visible part of the plane; default: all shapes with a margin. */
  void setView(const Box& view) { view_ = view; }

  /** @brief Returns the visible part, never empty. */
  Box view() const;

  /** @brief Draws the content of the panel into a box of a sheet. */
  void draw(Sheet& sheet, const Box& box) const;

  std::string title;

private:
  struct Label {
    Eigen::Vector2d place;
    SheetText text;
  };
  /** @brief Maps metres to the sheet. */
  struct Frame {
    Box box;
    Box view;

    Eigen::Vector2d scale() const { return box.sizes().cwiseQuotient(view.sizes()); }
    Eigen::Vector2d operator()(const Eigen::Vector2d& place) const
    {
      return box.min() + (place - view.min()).cwiseProduct(scale());
    }
  };
  using Layer = std::function<void(Sheet&, const Frame&)>;

  void drawLabels(Sheet& sheet, const Frame& frame) const;

  Box view_;
  Box bounds_; ///< of all shapes
  std::vector<Layer> layers_;
  std::vector<Label> labels_;
  std::string x_axis_;
};

/** @brief Returns a box grown by `margin` on every side; empty stays empty. */
Box grown(const Box& box, double margin);

/** @brief Returns the extent of cells without outliers, since a scan may hold points
 * hundreds of metres away: connected pieces of fewer than `min_piece` cells do not
 * count if there are larger ones, and one in a thousand cells at each end is cut off if
 * that halves the view.
 * @return empty for no cells */
Box viewOf(const CellSet& cells, double cell_size, std::size_t min_piece = 1);

} // namespace pcl::sedr::tools
