// SPDX-License-Identifier: BSD-3-Clause
#include "row_plan.h"

#include "cloud_readers.h"

#include "sedr_filters/src/base/field_access.h"

#include <cstring>

namespace pcl::sedr::tools {

namespace {

/** @brief Returns the axis of a coordinate field, -1 for others. */
int
axisOf(const pcl::PCLPointField& field)
{
  const std::string axes = "xyz";
  const auto axis = field.name.size() == 1 ? axes.find(field.name[0]) : axes.npos;
  return axis == axes.npos ? -1 : static_cast<int>(axis);
}

template <std::size_t Size>
void
copyField(const std::uint8_t* from,
          std::size_t from_step,
          std::size_t rows,
          std::uint8_t* to,
          std::size_t to_step)
{
  for (std::size_t i = 0; i < rows; ++i)
    std::memcpy(to + i * to_step, from + i * from_step, Size);
}

} // namespace

RowPlan::RowPlan(const std::vector<pcl::PCLPointField>& raw,
                 std::size_t raw_size,
                 double unit,
                 const Eigen::Vector3d& shift,
                 std::uint8_t datatype,
                 const std::string& path)
    : raw_size_(raw_size)
    , datatype_(datatype)
    , unit_(unit)
{
  for (const auto& field : raw) {
    if (field.name == "_") { // padding
      is_plain_ = false;
      continue;
    }
    const int axis = axisOf(field);
    Move move;
    move.from = field.offset;
    move.datatype = field.datatype;
    move.shift = axis < 0 ? 0 : shift[axis];
    move.converts =
        axis >= 0 && (unit != 1 || field.datatype != pcl::PCLPointField::FLOAT32 ||
                      field.count != 1 || move.shift != 0);
    fields_.push_back(field);
    if (move.converts) {
      fields_.back().datatype = datatype_;
      fields_.back().count = 1;
    }
    move.size = fieldSize(field.datatype) * field.count;
    moves_.push_back(move);
    is_plain_ = is_plain_ && !move.converts;
  }
  pcl::PCLPointCloud2 blob;
  blob.fields = fields_;
  layOut(blob, 1, path);
  fields_ = blob.fields;
  row_size_ = blob.point_step;
  for (std::size_t f = 0; f < moves_.size(); ++f) {
    moves_[f].to = fields_[f].offset;
    is_plain_ = is_plain_ && moves_[f].to == moves_[f].from;
  }
  is_plain_ = is_plain_ && row_size_ == raw_size_;
}

template <typename OutT>
void
RowPlan::convert(const Move& move,
                 const std::uint8_t* raw,
                 std::size_t rows,
                 std::uint8_t* to) const
{
  withFieldType(move.datatype, [&](auto typed) {
    for (std::size_t i = 0; i < rows; ++i) {
      std::memcpy(&typed, raw + move.from + i * raw_size_, sizeof typed);
      const auto value =
          static_cast<OutT>(unit_ * static_cast<double>(typed) - move.shift);
      std::memcpy(to + move.to + i * row_size_, &value, sizeof value);
    }
  });
}

void
RowPlan::bring(const std::uint8_t* raw, std::size_t rows, std::uint8_t* to) const
{
  for (const Move& move : moves_) {
    const auto* from = raw + move.from;
    auto* where = to + move.to;
    if (move.converts && datatype_ == pcl::PCLPointField::FLOAT64)
      convert<double>(move, raw, rows, to);
    else if (move.converts)
      convert<float>(move, raw, rows, to);
    else if (move.size == 4)
      copyField<4>(from, raw_size_, rows, where, row_size_);
    else
      for (std::size_t i = 0; i < rows; ++i)
        std::memcpy(where + i * row_size_, from + i * raw_size_, move.size);
  }
}

} // namespace pcl::sedr::tools
