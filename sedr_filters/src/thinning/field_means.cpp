// SPDX-License-Identifier: BSD-3-Clause
#include "field_means.h"

#include "../base/field_access.h"

#include <algorithm>

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
}

} // namespace pcl::sedr
