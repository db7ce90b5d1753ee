// SPDX-License-Identifier: BSD-3-Clause
#include "view.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkImageMapper.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <vector>

namespace pcl::sedr::tools {

namespace {

// Coloured points for VTK: coordinates, a cell per one, two or three of them, and
// colours as point scalars.

/** @brief Returns cells of `size` points each, in the order of the points. */
vtkSmartPointer<vtkCellArray>
cellsOf(std::size_t count, vtkIdType size)
{
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(static_cast<vtkIdType>(count));
  for (vtkIdType i = 0; i < connectivity->GetNumberOfValues(); ++i)
    connectivity->SetValue(i, i);
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(size, connectivity);
  return cells;
}

vtkSmartPointer<vtkPolyData>
dataOf(const ColouredPoints& shown)
{
  const auto count = static_cast<vtkIdType>(shown.points.size());
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(count);
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetName("colours");
  colours->SetNumberOfComponents(3);
  colours->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i) {
    const auto& p = shown.points[static_cast<std::size_t>(i)];
    const Colour c = shown.colours[static_cast<std::size_t>(i)];
    coordinates->SetTypedTuple(i, p.data());
    const unsigned char rgb[3] = {c.red, c.green, c.blue};
    colours->SetTypedTuple(i, rgb);
  }
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->GetPointData()->SetScalars(colours);
  return data;
}

/** @brief Returns an actor of points (`size` 1), lines (2) or triangles (3). */
vtkSmartPointer<vtkActor>
actorOf(const ColouredPoints& shown, vtkIdType size)
{
  const auto data = dataOf(shown);
  const auto cells = cellsOf(shown.points.size(), size);
  if (size == 1)
    data->SetVerts(cells);
  else if (size == 2)
    data->SetLines(cells);
  else
    data->SetPolys(cells);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  // Colours are already lit, or encode numbers, so VTK must not shade them.
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  return actor;
}

/** @brief Returns a key of the state that a layer's shapes depend on, without clipping
 * and sizes. */
std::string
keyOf(const ViewState& state)
{
  return std::to_string(static_cast<int>(state.colouring)) +
         (state.ceiling ? " with " : " without ") + std::to_string(state.storey);
}

void
clip(vtkActor& actor, const ViewState& state)
{
  auto* mapper = actor.GetMapper();
  mapper->RemoveAllClippingPlanes();
  if (!state.isClipped())
    return;
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0, 0, state.clip_height);
  plane->SetNormal(0, 0, -1); // the side towards it stays
  mapper->AddClippingPlane(plane);
}

/** @brief Chooses the visible sides of a surface: both if closed, those that face the
 * room if it is opened. */
void
chooseSides(vtkActor& actor, Layer layer, const ViewState& state)
{
  const bool is_open = !state.ceiling || state.isClipped();
  const bool faces_room = layer == Layer::Mesh; // triangles of a solid face outwards
  actor.GetProperty()->SetBackfaceCulling(is_open && faces_room);
  actor.GetProperty()->SetFrontfaceCulling(is_open && !faces_room);
}

/** @brief Returns the right end of the text in each row of an image and nearby rows; 0
 * without text. */
std::vector<int>
textEnds(const Image& image)
{
  constexpr int near = 6; // pixels
  std::vector<int> ends(static_cast<std::size_t>(image.height), 0);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (image.at(x, y) != colours::paper)
        for (int row = std::max(0, y - near);
             row <= std::min(image.height - 1, y + near); ++row)
          ends[static_cast<std::size_t>(row)] =
              std::max(ends[static_cast<std::size_t>(row)], x + near);
  return ends;
}

/** @brief Returns an image that is translucent behind its text, for legibility, and
 * transparent elsewhere. */
vtkSmartPointer<vtkImageData>
imageDataOf(const Image& image)
{
  constexpr unsigned char veil = 150; // of 255
  const std::vector<int> ends = textEnds(image);
  auto data = vtkSmartPointer<vtkImageData>::New();
  data->SetDimensions(image.width, image.height, 1);
  data->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      auto* pixel = static_cast<unsigned char*>(
          data->GetScalarPointer(x, image.height - 1 - y, 0));
      const Colour colour = image.at(x, y);
      const bool is_near_text = x < ends[static_cast<std::size_t>(y)];
      pixel[0] = colour.red;
      pixel[1] = colour.green;
      pixel[2] = colour.blue;
      pixel[3] = colour != colours::paper ? 255 : is_near_text ? veil : 0;
    }
  return data;
}

} // namespace

View::View(vtkRenderer* renderer)
    : renderer_(renderer)
{
  renderer_->SetBackground(1, 1, 1);
}

void
View::addShapes(const ViewedResult& result,
                const Painter& painter,
                Layer layer,
                const ViewState& state)
{
  Shapes& shapes = shapes_[layer];
  shapes.made_for = keyOf(state);
  if (result.cloudOf(layer))
    shapes.body = actorOf(painter.points(layer, state), 1);
  else if (result.meshOf(layer))
    shapes.body = actorOf(painter.triangles(layer, state), 3);
  else
    shapes.body = actorOf(painter.planLines(state), 2);
  renderer_->AddActor(shapes.body);
  if (layer != Layer::Solid)
    return;
  shapes.edges = actorOf(painter.solidEdges(state), 2);
  shapes.edges->PickableOff();
  // Drawn in front of their faces.
  auto* mapper = vtkPolyDataMapper::SafeDownCast(shapes.edges->GetMapper());
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, -8);
  renderer_->AddActor(shapes.edges);
}

void
View::showLayer(const ViewedResult& result,
                const Painter& painter,
                Layer layer,
                const ViewState& state)
{
  const auto known = shapes_.find(layer);
  if (known == shapes_.end() || known->second.made_for != keyOf(state)) {
    hideLayer(layer);
    addShapes(result, painter, layer, state);
  }
  Shapes& shapes = shapes_[layer];
  shapes.body->GetProperty()->SetPointSize(static_cast<float>(state.point_size));
  shapes.body->GetProperty()->SetLineWidth(3);
  if (result.meshOf(layer))
    chooseSides(*shapes.body, layer, state);
  clip(*shapes.body, state);
  if (!shapes.edges)
    return;
  shapes.edges->SetVisibility(state.edges);
  shapes.edges->GetProperty()->SetLineWidth(1.5F);
  clip(*shapes.edges, state);
}

void
View::hideLayer(Layer layer)
{
  const auto known = shapes_.find(layer);
  if (known == shapes_.end())
    return;
  renderer_->RemoveActor(known->second.body);
  if (known->second.edges)
    renderer_->RemoveActor(known->second.edges);
  shapes_.erase(known);
}

void
View::showLegend(const Image& image)
{
  if (legend_)
    renderer_->RemoveActor2D(legend_);
  legend_ = nullptr;
  if (image.pixels.empty())
    return;
  vtkNew<vtkImageMapper> mapper;
  mapper->SetInputData(imageDataOf(image));
  mapper->SetColorWindow(255);
  mapper->SetColorLevel(127.5);
  legend_ = vtkSmartPointer<vtkActor2D>::New();
  legend_->SetMapper(mapper);
  constexpr int margin = 8; // pixels
  const int* size = renderer_->GetSize();
  legend_->SetPosition(margin, size[1] - image.height - margin);
  renderer_->AddActor2D(legend_);
}

void
View::place(const CameraPose& pose)
{
  auto* camera = renderer_->GetActiveCamera();
  camera->SetPosition(pose.position.data());
  camera->SetFocalPoint(pose.focus.data());
  camera->SetViewUp(pose.up.data());
  camera->SetViewAngle(pose.view_angle);
  renderer_->ResetCameraClippingRange();
}

} // namespace pcl::sedr::tools
