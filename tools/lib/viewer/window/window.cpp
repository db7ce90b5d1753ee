// SPDX-License-Identifier: BSD-3-Clause
#include "window.h"

#include "bytes/whole_file.h"
#include "tool_error.h"
#include "viewer/legend.h"
#include "viewer/point_report.h"

#include <pcl/visualization/interactor_style.h>

#include <vtkBoundingBox.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkWindowToImageFilter.h>

#include <functional>
#include <iostream>

namespace pcl::sedr::tools {

namespace {

constexpr const char* screenshot_name = "sedr_view.png";

/** @brief The mouse actions of PCL's visualizer with our own keys, which are passed on
 * by symbol. */
class KeyStyle : public pcl::visualization::PCLVisualizerInteractorStyle {
public:
  static KeyStyle* New();

  std::function<void(const std::string&)> on_key;

protected:
  void OnKeyDown() override
  {
    const char* symbol = Interactor->GetKeySym();
    if (symbol && on_key)
      on_key(symbol);
  }

  void OnKeyUp() override {}
  void OnChar() override {} // disables VTK's keys, such as w for wireframe
};

vtkStandardNewMacro(KeyStyle);

vtkSmartPointer<vtkRenderWindow>
makeRenderWindow(const WindowSettings& settings)
{
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetMultiSamples(8);
  window->SetOffScreenRendering(settings.is_visible ? 0 : 1);
  return window;
}

} // namespace

Window::Window(const ViewedResult& result,
               const Painter& painter,
               const ViewState& state,
               const WindowSettings& settings)
    : result_(result)
    , painter_(painter)
    , state_(state)
{
  const auto box = result.bounds();
  if (!box.isEmpty())
    heights_ = {box.min().z(), box.max().z()};
  for (const PlanStorey& storey : painter.storeys().storeys())
    state_.storeys.push_back(storey.number);
  int argc = 0;
  char** argv = nullptr;
  const auto style = vtkSmartPointer<KeyStyle>::New();
  style->on_key = [this](const std::string& key) { onKey(key); };
  const auto render_window = makeRenderWindow(settings);
  const auto renderer = vtkSmartPointer<vtkRenderer>::New();
  visualizer_ = std::make_unique<pcl::visualization::PCLVisualizer>(
      argc, argv, renderer, render_window, "pcl_sedr_viewer: " + result.name, style,
      settings.is_visible);
  visualizer_->setShowFPS(false);
  visualizer_->setSize(settings.width, settings.height);
  right_ = std::make_unique<View>(renderer);
  int view = 0;
  visualizer_->createViewPort(0, 0, 0.5, 1, view); // shares the first view's camera
  left_ = std::make_unique<View>(
      vtkRenderer::SafeDownCast(render_window->GetRenderers()->GetItemAsObject(view)));
  visualizer_->registerPointPickingCallback(
      [this](const pcl::visualization::PointPickingEvent& event) { onPick(event); });
  update();
  moveCamera();
}

void
Window::update()
{
  const double middle = state_.two_views ? 0.5 : 0;
  right_->renderer()->SetViewport(middle, 0, 1, 1);
  left_->renderer()->SetViewport(0, 0, state_.two_views ? 0.5 : 0.001, 1);
  left_->renderer()->SetDraw(state_.two_views);
  for (const auto layer : all_layers) {
    const auto showIn = [&](View& view, bool is_shown) {
      if (is_shown && result_.has(layer))
        view.showLayer(result_, painter_, layer, state_);
      else
        view.hideLayer(layer);
    };
    showIn(*left_, state_.isShownLeft(layer));
    showIn(*right_, state_.isShownRight(layer));
  }
  right_->showLegend(state_.legend ? drawLegend(legendOf(result_, painter_, state_))
                                   : Image());
}

void
Window::moveCamera()
{
  const int* size = visualizer_->getRenderWindow()->GetSize();
  const double width = state_.two_views ? size[0] / 2.0 : size[0];
  right_->place(cameraPose(result_, state_.view_point, width / size[1], state_.storey));
  if (!state_.two_views)
    return;
  // Both views share the camera, and the scan may be larger than the model.
  vtkBoundingBox box(right_->renderer()->ComputeVisiblePropBounds());
  box.AddBox(vtkBoundingBox(left_->renderer()->ComputeVisiblePropBounds()));
  double bounds[6];
  box.GetBounds(bounds);
  right_->renderer()->ResetCameraClippingRange(bounds);
}

void
Window::onKey(const std::string& key)
{
  switch (pressKey(key, heights_, state_)) {
  case KeyCommand::None:
    return;
  case KeyCommand::Help:
    std::cout << keyHelp() << std::flush;
    return;
  case KeyCommand::Screenshot:
    try {
      saveScreenshot(screenshot_name);
      std::cout << "written: " << screenshot_name << std::endl;
    }
    catch (const ToolError& error) { // keeps the window open
      std::cerr << error.what() << std::endl;
    }
    return;
  case KeyCommand::Quit:
    wants_to_quit_ = true; // closing the window here would destroy it while VTK uses it
    return;
  case KeyCommand::MoveCamera:
    moveCamera();
    break;
  case KeyCommand::Redraw:
    break;
  }
  update();
  visualizer_->getRenderWindow()->Render();
}

void
Window::onPick(const pcl::visualization::PointPickingEvent& event)
{
  Eigen::Vector3f place;
  event.getPoint(place.x(), place.y(), place.z());
  const std::string answer = reportPoint(result_, place.cast<double>());
  std::cout << answer << std::endl;
  constexpr const char* id = "picked";
  constexpr int corner = 10; // pixels
  constexpr int size = 14;
  if (!visualizer_->updateText(answer, corner, corner, size, 0.13, 0.13, 0.13, id))
    visualizer_->addText(answer, corner, corner, size, 0.13, 0.13, 0.13, id);
}

void
Window::run()
{
  constexpr int pause = 30; // milliseconds
  while (!visualizer_->wasStopped() && !wants_to_quit_)
    visualizer_->spinOnce(pause);
}

Image
Window::screenshot()
{
  auto* window = visualizer_->getRenderWindow().Get();
  window->Render();
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(window);
  filter->SetInputBufferTypeToRGB();
  filter->ReadFrontBufferOff();
  filter->ShouldRerenderOff();
  filter->Update();
  auto* data = filter->GetOutput();
  const int* size = data->GetDimensions();
  Image image(size[0], size[1], colours::paper);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const auto* p = static_cast<const unsigned char*>(
          data->GetScalarPointer(x, image.height - 1 - y, 0));
      image.at(x, y) = {p[0], p[1], p[2]};
    }
  return image;
}

void
Window::saveScreenshot(const std::string& path)
{
  const std::string bytes = pngOf(screenshot());
  writeWhole(path, [&](std::ostream& stream) { stream << bytes; });
}

} // namespace pcl::sedr::tools
