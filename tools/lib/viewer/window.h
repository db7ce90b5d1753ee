// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shapes.h"

#include <pcl/visualization/pcl_visualizer.h>

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Throws ToolError with a remedy if no window can be opened: no X server
 * answers, or it cannot draw in 3D. VTK itself would abort. */
void requireDisplay();

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
  /** @param result must outlive this object */
  Window(const ViewedResult& result,
         const ViewState& state,
         const WindowSettings& settings);

  /** @brief Runs the interaction until the window is closed. */
  void run();

  /** @brief Draws, and saves the view as PNG; throws ToolError on failure. */
  void saveScreenshot(const std::string& path);

  /** @brief Returns what the keys and the mouse do, a line each. */
  std::string help() const;

private:
  /** @brief A key, and the equivalent option at start. */
  struct Key {
    std::string symbol; ///< of X and VTK: "c", "Up", "plus"
    std::string does;   ///< "ceilings on and off"; empty if another key explains it
    std::string option; ///< "--ceilings"; empty if there is none
    std::function<void()> press;
  };

  std::vector<Key> makeKeys();
  void onKey(const std::string& symbol);
  void onPick(int x, int y);

  /** @brief Lowers (below 0) or raises the clipping height by some metres: from no
   * clipping down to the top of the model, and from there up to no clipping. */
  void moveClipping(double by);
  void toggleStorey(std::uint32_t number);
  void nextRoom();
  void writeScreenshot();

  /** @brief Updates everything but the camera to the state. */
  void update();
  void updateLegend();

  /** @brief Shows a layer in a view, or hides it. Shapes are rebuilt only if the state
   * changes them. */
  void showLayer(const std::string& layer, bool is_left, bool is_shown);

  /** @brief Moves the camera to the state's view: from the top and aslant the model
   * fills the window; inside, it is at eye height in the only shown or largest room and
   * looks at its farthest corner. */
  void moveCamera();
  void goAround(vtkCamera& camera) const;
  void goInside(vtkCamera& camera) const;

  /** @brief Fits the camera's depth to what is shown in both views. */
  void resetDepth();

  /** @brief The actors of a layer in a view, and the state for which they were made. */
  struct LayerActors {
    std::string made_for;
    std::vector<vtkSmartPointer<vtkActor>> actors; ///< body, edges
  };

  const ViewedResult& result_;
  Shapes shapes_;
  ViewState state_;
  std::unique_ptr<pcl::visualization::PCLVisualizer> visualizer_;
  vtkSmartPointer<vtkRenderer> left_;
  vtkSmartPointer<vtkRenderer> right_; ///< or the only view
  std::map<std::pair<std::string, bool>, LayerActors> layers_;
  std::vector<vtkSmartPointer<vtkTextActor>> legend_;
  std::vector<Key> keys_;
  bool wants_to_quit_ = false;
};

} // namespace pcl::sedr::tools
