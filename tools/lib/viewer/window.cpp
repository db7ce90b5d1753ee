// SPDX-License-Identifier: BSD-3-Clause
#include "window.h"
#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/plan/missing_things.h"

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
#include <vtkRenderer.h>
#include <vtkTextProperty.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

namespace pcl::sedr::tools {

namespace {

constexpr double no_clipping = std::numeric_limits<double>::infinity();

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
  actor->GetMapper()->SetResolveCoincidentTopologyToPolygonOffset();
  actor->GetMapper()->SetRelativeCoincidentTopologyLineOffsetParameters(0, -8);
  return actor;
}

/** @brief Applies clipping and visible sides to an actor. A closed surface shows both
 * sides, an opened one those that face the room. */
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
  property->SetPointSize(3);
  property->SetLineWidth(layer == "plan" || layer == "openings" ? 3.0F : 1.5F);
  const bool is_open = !state.ceilings || is_clipped;
  property->SetBackfaceCulling(is_open && layer == "mesh"); // faces into the room
  property->SetFrontfaceCulling(is_open && layer == "solid");
}

vtkSmartPointer<vtkTextActor>
textAt(int x, int y, const std::string& text, Colour colour, bool is_patch)
{
  double rgb[3];
  for (std::size_t k = 0; k < 3; ++k)
    rgb[k] = channelsOf(colour)[k] / 255.0;
  auto actor = vtkSmartPointer<vtkTextActor>::New();
  actor->SetInput(text.c_str());
  actor->SetDisplayPosition(x, y);
  auto* property = actor->GetTextProperty();
  property->SetFontSize(14);
  property->SetColor(rgb[0], rgb[1], rgb[2]);
  property->SetBackgroundColor(is_patch ? rgb[0] : 1, is_patch ? rgb[1] : 1,
                               is_patch ? rgb[2] : 1);
  property->SetBackgroundOpacity(is_patch ? 1 : 0.6);
  return actor;
}

} // namespace

Window::Window(const ViewedResult& result,
               const ViewState& state,
               int width,
               int height,
               bool is_visible)
    : result_(result)
    , shapes_(result)
    , state_(state)
    , view_(vtkSmartPointer<vtkRenderer>::New())
    , keys_(makeKeys())
{
  const auto style = vtkSmartPointer<KeyStyle>::New();
  style->on_key = [this](const std::string& key) { onKey(key); };
  const auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetMultiSamples(8);
  window->SetOffScreenRendering(is_visible ? 0 : 1);
  int argc = 0;
  char** argv = nullptr;
  visualizer_ = std::make_unique<pcl::visualization::PCLVisualizer>(
      argc, argv, view_, window, "pcl_sedr_viewer: " + result.name, style, is_visible);
  visualizer_->setShowFPS(false);
  visualizer_->setSize(width, height);
  visualizer_->setBackgroundColor(1, 1, 1);
  update();
  moveCamera();
}

std::vector<Window::Key>
Window::makeKeys()
{
  constexpr double clip_step = 0.1; // metres
  std::vector<Key> keys;
  for (std::size_t k = 0; k < layer_names.size(); ++k)
    keys.push_back(
        {std::to_string(k + 1), "layer: " + layer_names[k] + " on and off", [this, k] {
           if (state_.layers.erase(layer_names[k]) == 0)
             state_.layers.insert(layer_names[k]);
         }});
  for (const auto& [symbol, name] :
       {std::pair("l", "label"), std::pair("o", "room"), std::pair("d", "distance"),
        std::pair("n", "height")})
    keys.push_back({symbol, std::string("colours by ") + name,
                    [this, name = name] { state_.colour = name; }});
  keys.push_back(
      {"c", "ceilings on and off", [this] { state_.ceilings = !state_.ceilings; }});
  keys.push_back({"r", "next room alone; all after the last", [this] { nextRoom(); }});
  for (std::uint32_t number = 1; number <= 9; ++number)
    keys.push_back({"F" + std::to_string(number),
                    number == 1 ? "to F9: storey 1 to 9 alone, or all again" : "",
                    [this, number] {
                      if (findStorey(result_.rules.storeys(), number))
                        state_.storey = state_.storey == number ? 0 : number;
                    }});
  keys.push_back({"Down", "clip 10 cm lower", [this] { moveClipping(-clip_step); }});
  keys.push_back({"Up", "clip 10 cm higher", [this] { moveClipping(clip_step); }});
  keys.push_back({"0", "no clipping", [this] { state_.clip_height = no_clipping; }});
  keys.push_back(
      {"g", "legend on and off", [this] { state_.legend = !state_.legend; }});
  for (const auto& [symbol, name] : {std::pair("t", "top"), std::pair("i", "iso")})
    keys.push_back({symbol, std::string("view: ") + name, [this, name = name] {
                      state_.view = name;
                      moveCamera();
                    }});
  keys.push_back({"j", "write sedr_view.png", [this] {
                    try {
                      saveScreenshot("sedr_view.png");
                      std::cout << "written: sedr_view.png" << std::endl;
                    }
                    catch (const ToolError& error) { // keeps the window open
                      std::cerr << error.what() << std::endl;
                    }
                  }});
  keys.push_back(
      {"h", "print these keys", [this] { std::cout << help() << std::flush; }});
  keys.push_back({"q", "quit", [this] { wants_to_quit_ = true; }});
  return keys;
}

std::string
Window::help() const
{
  std::string text = "Keys:\n";
  for (const Key& key : keys_)
    if (!key.does.empty())
      text += formatText("  %-6s%s\n", key.symbol.c_str(), key.does.c_str());
  return text + "Mouse: left turns, middle shifts, right and wheel come nearer.\n";
}

void
Window::onKey(const std::string& symbol)
{
  const auto key = std::find_if(keys_.begin(), keys_.end(), [&](const Key& known) {
    return known.symbol == symbol;
  });
  if (key == keys_.end())
    return;
  key->press();
  update();
  visualizer_->getRenderWindow()->Render();
}

void
Window::moveClipping(double by)
{
  const Eigen::AlignedBox3d box = result_.bounds();
  if (box.isEmpty() || (!std::isfinite(state_.clip_height) && by > 0))
    return;
  const double height =
      std::isfinite(state_.clip_height) ? state_.clip_height + by : box.max().z();
  constexpr double least = 0.01; // metres above the bottom, to leave something visible
  state_.clip_height =
      height > box.max().z() ? no_clipping : std::max(height, box.min().z() + least);
}

void
Window::nextRoom()
{
  std::uint32_t next = 0;
  for (const PlanRoom& room : result_.plan.rooms)
    if (room.id > state_.room && (next == 0 || room.id < next))
      next = room.id;
  state_.room = next;
}

void
Window::update()
{
  for (const auto& layer : layer_names) {
    LayerActors& shown = layers_[layer];
    std::string key;
    if (state_.layers.count(layer) > 0 && result_.has(layer))
      key = state_.colour + (state_.ceilings ? " with " : " without ") +
            std::to_string(state_.storey) + " " + std::to_string(state_.room);
    if (shown.made_for != key) {
      for (const auto& actor : shown.actors)
        view_->RemoveActor(actor);
      shown = {key, {}};
      if (!key.empty())
        shown.actors.push_back(actorOf(shapes_.of(layer, state_)));
      if (!key.empty() && layer == "solid")
        shown.actors.push_back(edgesOf(shapes_.solidEdges(state_)));
      for (const auto& actor : shown.actors)
        view_->AddActor(actor);
    }
    for (const auto& actor : shown.actors)
      adjust(*actor, layer, state_);
  }
  updateLegend();
  view_->ResetCameraClippingRange();
}

void
Window::updateLegend()
{
  constexpr int line_height = 19; // pixels
  constexpr int margin = 10;
  constexpr int sample_width = 18;
  for (const auto& actor : legend_)
    view_->RemoveActor2D(actor);
  legend_.clear();
  if (!state_.legend)
    return;
  int y = visualizer_->getRenderWindow()->GetSize()[1] - margin;
  for (const LegendLine& line : shapes_.legend(state_)) {
    y -= line_height;
    if (line.colour) // a patch: the letter is its colour
      legend_.push_back(textAt(margin, y, "M", *line.colour, true));
    legend_.push_back(textAt(margin + (line.colour ? sample_width : 0), y, line.text,
                             colours::ink, false));
  }
  for (const auto& actor : legend_)
    view_->AddActor2D(actor);
}

void
Window::moveCamera()
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
  const double slope = std::tan(view_angle * M_PI / 360) / margin;
  Eigen::AlignedBox3d box = result_.bounds();
  if (box.isEmpty())
    box.extend(Eigen::Vector3d::Zero());
  double distance = 0;
  for (int k = 0; k < 8; ++k) {
    const Eigen::Vector3d corner =
        box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(k)) - box.center();
    const double needed =
        std::max(std::abs(corner.dot(above)) / slope,
                 std::abs(corner.dot(right)) * size[1] / (slope * size[0]));
    distance = std::max(distance, needed + corner.dot(towards));
  }
  const Eigen::Vector3d eye = box.center() + distance * towards;
  vtkCamera* camera = view_->GetActiveCamera();
  camera->SetPosition(eye.data());
  camera->SetFocalPoint(box.center().eval().data());
  camera->SetViewUp(up.data());
  camera->SetViewAngle(view_angle);
  view_->ResetCameraClippingRange();
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
