// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "viewer/painter.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace pcl::sedr::tools {

// Coloured points for VTK: coordinates, a cell per one, two or three of them, and
// colours as point scalars.

vtkSmartPointer<vtkPolyData> pointsData(const ColouredPoints& points);

vtkSmartPointer<vtkPolyData> linesData(const ColouredLines& lines);

vtkSmartPointer<vtkPolyData> trianglesData(const ColouredPoints& corners);

} // namespace pcl::sedr::tools
