// SPDX-License-Identifier: BSD-3-Clause
#include "field_access.h"
#include "parallel.h"
#include <pcl/sedr_filters/point_view.h>

#include <algorithm>

namespace pcl::sedr {

const pcl::PCLPointField*
findField(const std::vector<pcl::PCLPointField>& fields, const std::string& name)
{
  const auto it = std::find_if(fields.begin(), fields.end(),
                               [&](const auto& f) { return f.name == name; });
  return it == fields.end() ? nullptr : &*it;
}

RowCoordinates::RowCoordinates(const std::vector<pcl::PCLPointField>& fields,
                               std::size_t row_size)
    : row_size_(row_size)
{
  for (const char* name : {"x", "y", "z"})
    xyz_.push_back(*findField(fields, name));
}

PointView
RowCoordinates::of(const std::uint8_t* rows, std::size_t size, unsigned threads)
{
  bool is_plain = true;
  for (std::size_t axis = 0; axis < 3; ++axis)
    is_plain = is_plain && xyz_[axis].datatype == pcl::PCLPointField::FLOAT32 &&
               xyz_[axis].offset == xyz_[0].offset + axis * sizeof(float);
  if (is_plain)
    return {rows + xyz_[0].offset, row_size_, size};
  constexpr std::size_t rows_at_once = 4096;
  copy_.resize(size);
  parallelFor(size, rows_at_once, threads, [&](std::size_t i) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto& field = xyz_[static_cast<std::size_t>(axis)];
      copy_[i][axis] = static_cast<float>(
          readField(rows + i * row_size_ + field.offset, field.datatype));
    }
  });
  return copy_.empty() ? PointView()
                       : PointView(copy_[0].data(), sizeof copy_[0], size);
}

} // namespace pcl::sedr
