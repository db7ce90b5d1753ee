// SPDX-License-Identifier: BSD-3-Clause
#include "image.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <cstring>

namespace pcl::sedr::tools {

static_assert(sizeof(Colour) == 3, "pixels are handed on as they lie in memory");

std::string
pngOf(const Image& image)
{
  vtkNew<vtkImageData> data;
  data->SetDimensions(image.width, image.height, 1);
  data->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  // VTK counts rows from the bottom.
  const std::size_t row_size = 3 * static_cast<std::size_t>(image.width);
  for (int y = 0; y < image.height; ++y)
    std::memcpy(data->GetScalarPointer(0, image.height - 1 - y, 0),
                image.pixels.data() +
                    static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width),
                row_size);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(data);
  writer->WriteToMemoryOn();
  writer->SetCompressionLevel(9);
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  return {reinterpret_cast<const char*>(bytes->GetPointer(0)),
          static_cast<std::size_t>(bytes->GetNumberOfValues())};
}

} // namespace pcl::sedr::tools
