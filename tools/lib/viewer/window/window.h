// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "view.h"
#include "viewer/keys.h"
#include "viewer/painter.h"

#include <pcl/visualization/pcl_visualizer.h>

#include <memory>
#include <string>

namespace pcl::sedr::tools {

/** @brief Size and visibility of a window. */
struct WindowSettings {
  int width = 1200; ///< pixels
  int height = 800;
  bool is_visible = true; ///< false: only for screenshots, of any size
};

/** @brief Shows a result in PCL's visualizer: one view, or two with one camera. Needs a
 * display, see requireDisplay(). */
class Window {
public:
  /** @param result,painter must outlive this object */
  Window(const ViewedResult& result,
         const Painter& painter,
         const ViewState& state,
         const WindowSettings& settings);

  /** @brief Runs the interaction until the window is closed. */
  void run();

  /** @brief Draws, and saves the view as PNG; throws ToolError on failure. */
  void saveScreenshot(const std::string& path);

private:
  void onKey(const std::string& key);

  void onPick(const pcl::visualization::PointPickingEvent& event);

  /** @brief Updates everything but the camera to the state. */
  void update();

  void moveCamera();

  Image screenshot();

  const ViewedResult& result_;
  const Painter& painter_;
  ViewState state_;
  HeightRange heights_;
  std::unique_ptr<pcl::visualization::PCLVisualizer> visualizer_;
  std::unique_ptr<View> left_;
  std::unique_ptr<View> right_; ///< or the only view
  bool wants_to_quit_ = false;
};

} // namespace pcl::sedr::tools
