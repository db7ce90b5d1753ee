// SPDX-License-Identifier: BSD-3-Clause
#include "scan_file.h"

#include <array>
#include <cstring>

namespace pcl::sedr::tools {

namespace {

constexpr std::array<const char*, 4> colour_bytes{"blue", "green", "red", "alpha"};

/** @brief Returns the bytes of a stored colour, low byte first: three, four with alpha;
 * empty if colours are not joined. */
std::vector<StoredField>
colourOf(const StoredRow& stored)
{
  std::vector<StoredField> bytes;
  for (std::size_t k = 0; k < colour_bytes.size() && stored.joins_colours; ++k) {
    const StoredField* byte = stored.find(colour_bytes[k]);
    if (byte && byte->datatype == pcl::PCLPointField::UINT8 && bytes.size() == k)
      bytes.push_back(*byte);
  }
  if (bytes.size() < 3)
    bytes.clear();
  return bytes;
}

/** @brief Returns the axis of a coordinate, -1 for other fields. */
int
axisOf(const StoredField& field)
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

RowPlan::RowPlan(const StoredRow& stored, double unit, const Eigen::Vector3d& shift)
    : stored_size_(stored.size)
{
  using Field = pcl::PCLPointField;
  const bool has_colour = !colourOf(stored).empty();
  for (const StoredField& field : stored.fields) {
    const bool is_joined =
        has_colour && std::find(colour_bytes.begin(), colour_bytes.end(), field.name) !=
                          colour_bytes.end();
    if (field.name == "_" || is_joined) // the first is padding
      continue;
    Move move{field, row_size_};
    const int axis = axisOf(field);
    if (axis >= 0 && (unit != 1 || shift[axis] != 0 || field.count != 1 ||
                      field.datatype != Field::FLOAT32 || field.becomes_float)) {
      move.is_number = true;
      move.unit = unit;
      move.shift = shift[axis];
    }
    else if (field.becomes_float)
      move.is_number = true;
    is_plain_ = is_plain_ && !move.is_number && move.to == field.offset;
    addField(field.name,
             move.is_number ? static_cast<std::uint8_t>(Field::FLOAT32)
                            : field.datatype,
             move.is_number ? 1 : field.count);
    moves_.push_back(move);
  }
  if (has_colour)
    addColour(stored);
  is_plain_ = is_plain_ && row_size_ == stored_size_;
}

void
RowPlan::addField(const std::string& name, std::uint8_t datatype, std::size_t count)
{
  pcl::PCLPointField field;
  field.name = name;
  field.offset = static_cast<pcl::uindex_t>(row_size_);
  field.datatype = datatype;
  field.count = static_cast<pcl::uindex_t>(count);
  fields_.push_back(field);
  row_size_ += fieldSize(datatype) * count;
}

void
RowPlan::addColour(const StoredRow& stored)
{
  const std::vector<StoredField> bytes = colourOf(stored);
  const bool has_alpha = bytes.size() == colour_bytes.size();
  for (std::size_t k = 0; k < bytes.size(); ++k)
    moves_.push_back({bytes[k], row_size_ + k});
  if (!has_alpha)
    opaque_ = static_cast<std::ptrdiff_t>(row_size_) + 3;
  addField(has_alpha ? "rgba" : "rgb",
           has_alpha ? pcl::PCLPointField::UINT32 : pcl::PCLPointField::FLOAT32);
  is_plain_ = false;
}

void
RowPlan::convert(const Move& move,
                 const std::uint8_t* stored,
                 std::size_t rows,
                 std::uint8_t* to) const
{
  const StoredField& field = move.from;
  withFieldType(field.datatype, [&](auto typed) {
    for (std::size_t i = 0; i < rows; ++i) {
      std::memcpy(&typed, stored + i * stored_size_ + field.offset, sizeof typed);
      const double number = static_cast<double>(typed) * field.scale + field.shift;
      const auto value = static_cast<float>(move.unit * number - move.shift);
      std::memcpy(to + i * row_size_ + move.to, &value, sizeof value);
    }
  });
}

void
RowPlan::convert(const std::uint8_t* stored, std::size_t rows, std::uint8_t* to) const
{
  constexpr std::size_t batch = 1024; // rows that fit into a fast cache
  for (; rows > batch; rows -= batch) {
    convert(stored, batch, to);
    stored += batch * stored_size_;
    to += batch * row_size_;
  }
  for (const Move& move : moves_) {
    const auto* from = stored + move.from.offset;
    auto* where = to + move.to;
    const std::size_t size = fieldSize(move.from.datatype) * move.from.count;
    if (move.is_number)
      convert(move, stored, rows, to);
    else if (size == 4)
      copyField<4>(from, stored_size_, rows, where, row_size_);
    else if (size == 1)
      copyField<1>(from, stored_size_, rows, where, row_size_);
    else
      for (std::size_t i = 0; i < rows; ++i)
        std::memcpy(where + i * row_size_, from + i * stored_size_, size);
  }
  for (std::size_t i = 0; opaque_ >= 0 && i < rows; ++i)
    to[i * row_size_ + static_cast<std::size_t>(opaque_)] = 0xff;
}

} // namespace pcl::sedr::tools
