// SPDX-License-Identifier: BSD-3-Clause
#include "poly_data.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

namespace pcl::sedr::tools {

namespace {

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

} // namespace

vtkSmartPointer<vtkPolyData>
pointsData(const ColouredPoints& points)
{
  auto data = dataOf(points);
  data->SetVerts(cellsOf(points.points.size(), 1));
  return data;
}

vtkSmartPointer<vtkPolyData>
linesData(const ColouredLines& lines)
{
  auto data = dataOf(lines);
  data->SetLines(cellsOf(lines.points.size(), 2));
  return data;
}

vtkSmartPointer<vtkPolyData>
trianglesData(const ColouredPoints& corners)
{
  auto data = dataOf(corners);
  data->SetPolys(cellsOf(corners.points.size(), 3));
  return data;
}

} // namespace pcl::sedr::tools
