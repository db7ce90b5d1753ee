// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "image.h"
#include "viewer/camera.h"
#include "viewer/painter.h"

#include <vtkActor.h>
#include <vtkActor2D.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <map>
#include <string>

namespace pcl::sedr::tools {

/** @brief One view of a window: its layers, and a legend on top. Shapes are rebuilt
 * only if the state changes them. */
class View {
public:
  /** @param renderer target of drawing */
  explicit View(vtkRenderer* renderer);

  /** @brief Shows a layer in a state. */
  void showLayer(const ViewedResult& result,
                 const Painter& painter,
                 Layer layer,
                 const ViewState& state);

  void hideLayer(Layer layer);

  /** @brief Shows an image in the top left corner. */
  void showLegend(const Image& image);

  void place(const CameraPose& pose);

  vtkRenderer* renderer() { return renderer_; }

private:
  /** @brief The shapes of a layer, and the state for which they were made. */
  struct Shapes {
    std::string made_for;
    vtkSmartPointer<vtkActor> body;
    vtkSmartPointer<vtkActor> edges; ///< null if the layer has none
  };

  void addShapes(const ViewedResult& result,
                 const Painter& painter,
                 Layer layer,
                 const ViewState& state);

  vtkSmartPointer<vtkRenderer> renderer_;
  std::map<Layer, Shapes> shapes_;
  vtkSmartPointer<vtkActor2D> legend_;
};

} // namespace pcl::sedr::tools
