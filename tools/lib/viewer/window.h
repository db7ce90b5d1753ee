// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shapes.h"

#include <pcl/visualization/pcl_visualizer.h>

#include <vtkActor.h>
#include <vtkTextActor.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Throws ToolError with a remedy if no window can be opened: no X server
 * answers, or it cannot draw in 3D. VTK itself would abort. */
void requireDisplay();

/** @brief Shows a result in PCL's visualizer. Needs a display, see requireDisplay(). */
class Window {
public:
  /** @param result must outlive this object
   * @param is_visible false: only for screenshots, of any size */
  Window(const ViewedResult& result,
         const ViewState& state,
         int width,
         int height,
         bool is_visible);

  /** @brief Runs the interaction until the window is closed. */
  void run();

  /** @brief Draws, and saves the view as PNG; throws ToolError on failure. */
  void saveScreenshot(const std::string& path);

  /** @brief Returns what the keys do, a line each. */
  std::string help() const;

private:
  struct Key {
    std::string symbol; ///< of X and VTK: "c", "Up"
    std::string does;   ///< empty if another key explains it
    std::function<void()> press;
  };

  std::vector<Key> makeKeys();
  void onKey(const std::string& symbol);

  /** @brief Lowers (below 0) or raises the clipping height by some metres: from no
   * clipping down to the top of the model, and from there up to no clipping. */
  void moveClipping(double by);
  void nextRoom();

  /** @brief Updates everything but the camera to the state. */
  void update();
  void updateLegend();

  /** @brief Moves the camera to the state's view: the model fills the window. */
  void moveCamera();

  /** @brief The actors of a layer, and the state for which they were made. */
  struct LayerActors {
    std::string made_for;
    std::vector<vtkSmartPointer<vtkActor>> actors; ///< body, edges
  };

  const ViewedResult& result_;
  Shapes shapes_;
  ViewState state_;
  std::unique_ptr<pcl::visualization::PCLVisualizer> visualizer_;
  vtkSmartPointer<vtkRenderer> view_;
  std::map<std::string, LayerActors> layers_;
  std::vector<vtkSmartPointer<vtkTextActor>> legend_;
  std::vector<Key> keys_;
  bool wants_to_quit_ = false;
};

} // namespace pcl::sedr::tools
