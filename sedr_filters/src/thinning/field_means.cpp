// SPDX-License-Identifier: BSD-3-Clause
#include "field_means.h"

#include "../base/field_access.h"
#include <pcl/sedr_filters/point_view.h>

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

constexpr std::size_t channels = 4;

bool
isColour(const pcl::PCLPointField& field)
{
  return (field.name == "rgb" || field.name == "rgba") &&
         fieldSize(field.datatype) == channels;
}

bool
isLabel(const pcl::PCLPointField& field)
{
  return field.name == "label" || field.name == "room";
}

} // namespace

FieldMeans::FieldMeans(const std::vector<pcl::PCLPointField>& fields,
                       std::size_t voxels)
{
  for (const char* name : {"normal_x", "normal_y", "normal_z"})
    if (const auto* field = findField(fields, name))
      normal_.push_back(*field);
  for (const auto& field : fields)
    for (std::size_t k = 0; k < std::max<std::size_t>(field.count, 1); ++k) {
      const Kind kind = isColour(field)  ? Kind::Colour
                        : isLabel(field) ? Kind::Label
                                         : Kind::Number;
      std::size_t& used = kind == Kind::Label ? votes_a_voxel_ : sums_a_voxel_;
      values_.push_back(
          {kind, field.offset + k * fieldSize(field.datatype), field.datatype, used});
      used += kind == Kind::Colour ? channels : 1;
    }
  sums_.resize(voxels * sums_a_voxel_, 0);
  votes_.resize(voxels * votes_a_voxel_);
}

void
FieldMeans::add(std::size_t voxel, const std::uint8_t* row)
{
  double* sums = sums_.data() + voxel * sums_a_voxel_;
  for (const Value& value : values_) {
    const std::uint8_t* where = row + value.offset;
    if (value.kind == Kind::Colour)
      for (std::size_t c = 0; c < channels; ++c)
        sums[value.place + c] += where[c];
    else {
      const double number = readField(where, value.datatype);
      if (value.kind == Kind::Number)
        sums[value.place] += number;
      else
        ++votes_[voxel * votes_a_voxel_ + value.place][std::isnan(number) ? 0 : number];
    }
  }
}

void
FieldMeans::write(std::size_t voxel, std::size_t count, std::uint8_t* row) const
{
  const double* sums = sums_.data() + voxel * sums_a_voxel_;
  const auto size = static_cast<double>(count);
  for (const Value& value : values_) {
    std::uint8_t* where = row + value.offset;
    if (value.kind == Kind::Number)
      writeField(where, value.datatype, sums[value.place] / size);
    else if (value.kind == Kind::Colour) // truncated, as pcl::CentroidPoint does
      for (std::size_t c = 0; c < channels; ++c)
        where[c] = static_cast<std::uint8_t>(sums[value.place + c] / size);
    else { // the most frequent, the smallest of equally frequent ones
      const auto& votes = votes_[voxel * votes_a_voxel_ + value.place];
      const auto most = std::max_element(
          votes.begin(), votes.end(),
          [](const auto& a, const auto& b) { return a.second < b.second; });
      writeField(where, value.datatype, most->first);
    }
  }
  normalise(row);
}

/** @brief Normalises the normal, if there is one and it is not zero. */
void
FieldMeans::normalise(std::uint8_t* row) const
{
  double square = 0;
  for (const auto& field : normal_)
    square += std::pow(readField(row + field.offset, field.datatype), 2);
  if (normal_.size() != 3 || !(square > 0))
    return;
  for (const auto& field : normal_)
    writeField(row + field.offset, field.datatype,
               readField(row + field.offset, field.datatype) / std::sqrt(square));
}

} // namespace pcl::sedr
