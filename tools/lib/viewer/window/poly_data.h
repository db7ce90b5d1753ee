// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "viewer/painter.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace pcl {
namespace sedr {
namespace tools {

// Coloured points as VTK takes them: coordinates, a cell for every one, two or three of
// them, and the colours as scalars of the points.

vtkSmartPointer<vtkPolyData> pointsData(const ColouredPoints& points);

vtkSmartPointer<vtkPolyData> linesData(const ColouredLines& lines);

vtkSmartPointer<vtkPolyData> trianglesData(const ColouredPoints& corners);

} // namespace tools
} // namespace sedr
} // namespace pcl
