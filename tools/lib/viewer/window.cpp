// SPDX-License-Identifier: BSD-3-Clause
#include "window.h"

#include "bytes/whole_file.h"
#include "tool_error.h"

#include <pcl/visualization/interactor_style.h>

#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPNGWriter.h>
#include <vtkPlane.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRendererCollection.h>
#include <vtkTextProperty.h>
#include <vtkWindowToImageFilter.h>
#include <vtkWorldPointPicker.h>

#include <cmath>
#include <iostream>

namespace pcl::sedr::tools {

namespace {

/** @brief The mouse actions of PCL's visualizer with our own keys, which are passed on
 * by symbol, and clicks with shift. */
class KeyStyle : public pcl::visualization::PCLVisualizerInteractorStyle {
public:
  static KeyStyle* New();

  std::function<void(const std::string&)> on_key;
  std::function<void(int, int)> on_pick;

protected:
  void OnKeyDown() override
  {
    const char* symbol = Interactor->GetKeySym();
    if (symbol && on_key)
      on_key(symbol);
  }

  void OnLeftButtonDown() override
  {
    const int* place = Interactor->GetEventPosition();
    if (Interactor->GetShiftKey() && on_pick)
      on_pick(place[0], place[1]);
    else
      PCLVisualizerInteractorStyle::OnLeftButtonDown();
  }

  void OnKeyUp() override {}
  void OnChar() override {} // disables VTK's keys, such as w for wireframe
};

vtkStandardNewMacro(KeyStyle);

vtkSmartPointer<vtkActor>
actorOf(vtkPolyData* shape)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(shape);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetInterpolationToFlat();
  actor->GetProperty()->SetAmbient(0.65); // walls beside the view stay bright
  actor->GetProperty()->SetDiffuse(0.35);
  if (shape->GetNumberOfPolys() == 0)
    actor->GetProperty()->LightingOff();
  return actor;
}

/** @brief Returns edges that are drawn in front of their faces. */
vtkSmartPointer<vtkActor>
edgesOf(vtkPolyData* lines)
{
  auto actor = actorOf(lines);
  actor->GetProperty()->SetColor(0.13, 0.13, 0.13);
  actor->PickableOff();
  actor->GetMapper()->SetResolveCoincidentTopologyToPolygonOffset();
  actor->GetMapper()->SetRelativeCoincidentTopologyLineOffsetParameters(0, -8);
  return actor;
}

/** @brief Applies clipping, sizes and visible sides to an actor. A closed surface shows
 * both sides, an opened one those that face the room. */
void
adjust(vtkActor& actor, const std::string& layer, const ViewState& state)
{
  const bool is_clipped = std::isfinite(state.clip_height);
  actor.GetMapper()->RemoveAllClippingPlanes();
  if (is_clipped) {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(0, 0, state.clip_height);
    plane->SetNormal(0, 0, -1); // the side towards it stays
    actor.GetMapper()->AddClippingPlane(plane);
  }
  auto* property = actor.GetProperty();
  property->SetPointSize(static_cast<float>(state.point_size));
  property->SetLineWidth(layer == "plan" ? 3.0F : 1.5F);
  const bool is_open = !state.ceilings || is_clipped;
  property->SetBackfaceCulling(is_open && layer == "mesh"); // faces into the room
  property->SetFrontfaceCulling(is_open && layer == "solid");
}

vtkSmartPointer<vtkTextActor>
textAt(int x, int y, const std::string& text)
{
  auto actor = vtkSmartPointer<vtkTextActor>::New();
  actor->SetInput(text.c_str());
  actor->SetDisplayPosition(x, y);
  auto* property = actor->GetTextProperty();
  property->SetFontSize(14);
  property->SetColor(0.13, 0.13, 0.13);
  property->SetBackgroundColor(1, 1, 1);
  property->SetBackgroundOpacity(0.6);
  return actor;
}

} // namespace

Window::Window(const ViewedResult& result,
               const ViewState& state,
               const WindowSettings& settings)
    : result_(result)
    , shapes_(result)
    , state_(state)
    , keys_(makeKeys())
{
  const auto style = vtkSmartPointer<KeyStyle>::New();
  style->on_key = [this](const std::string& key) { onKey(key); };
  style->on_pick = [this](int x, int y) { onPick(x, y); };
  const auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetMultiSamples(8);
  window->SetOffScreenRendering(settings.is_visible ? 0 : 1);
  right_ = vtkSmartPointer<vtkRenderer>::New();
  int argc = 0;
  char** argv = nullptr;
  visualizer_ = std::make_unique<pcl::visualization::PCLVisualizer>(
      argc, argv, right_, window, "pcl_sedr_viewer: " + result.name, style,
      settings.is_visible);
  visualizer_->setShowFPS(false);
  visualizer_->setSize(settings.width, settings.height);
  int view = 0;
  visualizer_->createViewPort(0, 0, 0.5, 1, view); // shares the first view's camera
  left_ = vtkRenderer::SafeDownCast(window->GetRenderers()->GetItemAsObject(view));
  visualizer_->setBackgroundColor(1, 1, 1);
  update();
  moveCamera();
}

void
Window::update()
{
  right_->SetViewport(state_.two_views ? 0.5 : 0, 0, 1, 1);
  left_->SetViewport(0, 0, state_.two_views ? 0.5 : 0.001, 1);
  left_->SetDraw(state_.two_views);
  for (const auto& layer : layer_names) {
    const bool is_left = state_.two_views && layer == "scan";
    showLayer(layer, true, is_left);
    showLayer(layer, false, state_.layers.count(layer) > 0 && !is_left);
  }
  updateLegend();
  resetDepth();
}

void
Window::showLayer(const std::string& layer, bool is_left, bool is_shown)
{
  vtkRenderer* view = is_left ? left_ : right_;
  LayerActors& shown = layers_[{layer, is_left}];
  std::string key;
  if (is_shown && result_.has(layer))
    key = state_.colour + (state_.ceilings ? " with " : " without ") +
          std::to_string(state_.storey) + " " + std::to_string(state_.room);
  if (shown.made_for != key) {
    for (const auto& actor : shown.actors)
      view->RemoveActor(actor);
    shown = {key, {}};
    if (!key.empty())
      shown.actors.push_back(actorOf(shapes_.of(layer, state_)));
    if (!key.empty() && layer == "solid")
      shown.actors.push_back(edgesOf(shapes_.solidEdges(state_)));
    for (const auto& actor : shown.actors)
      view->AddActor(actor);
  }
  for (const auto& actor : shown.actors)
    adjust(*actor, layer, state_);
  if (shown.actors.size() > 1)
    shown.actors.back()->SetVisibility(state_.edges);
}

void
Window::updateLegend()
{
  constexpr int line_height = 19; // pixels
  constexpr int margin = 10;
  constexpr int sample_width = 18;
  for (const auto& actor : legend_)
    right_->RemoveActor2D(actor);
  legend_.clear();
  if (!state_.legend)
    return;
  int y = visualizer_->getRenderWindow()->GetSize()[1] - margin;
  for (const LegendLine& line : shapes_.legend(state_)) {
    y -= line_height;
    if (line.colour) {
      legend_.push_back(textAt(margin, y, "M")); // a patch: the letter is its colour
      const double rgb[3] = {line.colour->red / 255.0, line.colour->green / 255.0,
                             line.colour->blue / 255.0};
      auto* property = legend_.back()->GetTextProperty();
      property->SetColor(rgb[0], rgb[1], rgb[2]);
      property->SetBackgroundColor(rgb[0], rgb[1], rgb[2]);
      property->SetBackgroundOpacity(1);
    }
    legend_.push_back(textAt(margin + (line.colour ? sample_width : 0), y, line.text));
  }
  for (const auto& actor : legend_)
    right_->AddActor2D(actor);
}

void
Window::moveCamera()
{
  vtkCamera* camera = right_->GetActiveCamera();
  if (state_.view == "inside" && !result_.plan.rooms.empty())
    goInside(*camera);
  else
    goAround(*camera);
  resetDepth();
}

void
Window::resetDepth()
{
  double all[6];
  double left[6];
  right_->ComputeVisiblePropBounds(all);
  if (state_.two_views && result_.has("scan")) { // they share the camera
    left_->ComputeVisiblePropBounds(left);
    for (int k = 0; k < 6; ++k)
      all[k] = k % 2 == 0 ? std::min(all[k], left[k]) : std::max(all[k], left[k]);
  }
  right_->ResetCameraClippingRange(all);
}

void
Window::goAround(vtkCamera& camera) const
{
  constexpr double view_angle = 30; // degrees
  constexpr double margin = 1.08;
  const bool is_top = state_.view == "top";
  const Eigen::Vector3d towards = is_top
                                      ? Eigen::Vector3d(0, 0, 1)
                                      : Eigen::Vector3d(0.43, -0.61, 0.67).normalized();
  const Eigen::Vector3d up(0, is_top ? 1 : 0, is_top ? 0 : 1);
  const Eigen::Vector3d right = up.cross(towards).normalized();
  const Eigen::Vector3d above = towards.cross(right);
  const int* size = visualizer_->getRenderWindow()->GetSize();
  const double aspect = size[0] / (state_.two_views ? 2.0 : 1.0) / size[1];
  const double slope = std::tan(view_angle * M_PI / 360) / margin;
  Eigen::AlignedBox3d box = result_.bounds();
  if (box.isEmpty())
    box.extend(Eigen::Vector3d::Zero());
  double distance = 0;
  for (int k = 0; k < 8; ++k) {
    const Eigen::Vector3d corner =
        box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(k)) - box.center();
    const double needed = std::max(std::abs(corner.dot(above)) / slope,
                                   std::abs(corner.dot(right)) / (slope * aspect));
    distance = std::max(distance, needed + corner.dot(towards));
  }
  const Eigen::Vector3d eye = box.center() + distance * towards;
  camera.SetPosition(eye.data());
  camera.SetFocalPoint(box.center().eval().data());
  camera.SetViewUp(up.data());
  camera.SetViewAngle(view_angle);
}

void
Window::goInside(vtkCamera& camera) const
{
  constexpr double eye_height = 1.6; // metres
  const PlanRoom* largest = nullptr;
  for (const PlanRoom& room : result_.plan.rooms)
    if (result_.rules.isInStorey(state_.storey, room.id, 0) &&
        (state_.room == 0 || state_.room == room.id) &&
        (!largest || room.area() > largest->area()))
      largest = &room;
  if (!largest)
    return;
  // From beside a corner, within the room, to the corner that is farthest from it.
  const auto corners = largest->boundary.polygon(0.05);
  const Eigen::Vector3d middle = result_.rules.boxOf(largest->id).center();
  Eigen::Vector2d eye = middle.head<2>();
  Eigen::Vector2d aim = eye;
  double farthest = -1;
  for (const auto& corner : corners) {
    const Eigen::Vector2d inner = corner + 0.2 * (middle.head<2>() - corner);
    for (const auto& other : corners)
      if (largest->contains(inner) && (other - inner).norm() > farthest) {
        farthest = (other - inner).norm();
        eye = inner;
        aim = other;
      }
  }
  const double floor = largest->floorAt(eye);
  const double z =
      floor + std::min(eye_height, 0.6 * (largest->ceilingAt(eye) - floor));
  camera.SetPosition(eye.x(), eye.y(), z);
  camera.SetFocalPoint(aim.x(), aim.y(), z - 0.05 * farthest);
  camera.SetViewUp(0, 0, 1);
  camera.SetViewAngle(65);
}

void
Window::onPick(int x, int y)
{
  vtkRenderer* view = left_->GetDraw() && left_->IsInViewport(x, y) ? left_ : right_;
  if (view->GetZ(x, y) >= 1) // nothing is there
    return;
  vtkNew<vtkWorldPointPicker> picker; // what is seen, points and faces alike
  picker->Pick(x, y, 0, view);
  const std::string answer =
      result_.describe(Eigen::Vector3d::Map(picker->GetPickPosition()));
  std::cout << answer << std::endl;
  constexpr const char* id = "picked";
  constexpr int corner = 10; // pixels
  constexpr int size = 14;
  if (!visualizer_->updateText(answer, corner, corner, size, 0.13, 0.13, 0.13, id))
    visualizer_->addText(answer, corner, corner, size, 0.13, 0.13, 0.13, id);
  visualizer_->getRenderWindow()->Render();
}

void
Window::run()
{
  constexpr int pause = 30; // milliseconds
  while (!visualizer_->wasStopped() && !wants_to_quit_)
    visualizer_->spinOnce(pause);
}

void
Window::saveScreenshot(const std::string& path)
{
  checkWritable(path);
  auto* window = visualizer_->getRenderWindow().Get();
  window->Render();
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(window);
  filter->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(filter->GetOutputPort());
  writer->SetFileName(path.c_str());
  writer->Write();
  if (writer->GetErrorCode() != 0)
    throw ToolError("cannot write '" + path + "'");
}

} // namespace pcl::sedr::tools
