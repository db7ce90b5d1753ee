// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "view.h"
#include "viewer/keys.h"
#include "viewer/painter.h"

#include <pcl/visualization/pcl_visualizer.h>

#include <memory>
#include <string>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief How large a window is, and whether it is seen. */
struct WindowSettings {
  int width = 1200; ///< pixels
  int height = 800;
  bool is_visible = true; ///< false: it draws for a screenshot only, at any size
};

/** @brief A result in PCL's visualizer: one view, or two with one camera. Needs a
 * display, see requireDisplay(). */
class Window {
public:
  /** @param result,painter must stay where they are */
  Window(const ViewedResult& result,
         const Painter& painter,
         const ViewState& state,
         const WindowSettings& settings);

  /** @brief Lets the user look, until the window is closed. */
  void run();

  /** @brief Draws, and writes what is seen as PNG; what fails is a ToolError. */
  void saveScreenshot(const std::string& path);

private:
  void onKey(const std::string& key);

  void onPick(const pcl::visualization::PointPickingEvent& event);

  /** @brief Brings everything but the camera to the state. */
  void update();

  void moveCamera();

  Image screenshot();

  const ViewedResult& result_;
  const Painter& painter_;
  ViewState state_;
  HeightRange heights_;
  std::unique_ptr<pcl::visualization::PCLVisualizer> visualizer_;
  std::unique_ptr<View> left_;
  std::unique_ptr<View> right_; ///< or the only one
  bool wants_to_quit_ = false;
};

} // namespace tools
} // namespace sedr
} // namespace pcl
