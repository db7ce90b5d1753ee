// SPDX-License-Identifier: BSD-3-Clause
#include "scan_file.h"
#include "run_tool.h"
#include "sedr_filters/src/base/parallel.h"
#include "tool_error.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace pcl::sedr::tools {

namespace {

/** @brief Warns once per file that only the vertices of a mesh are read. */
void
warnOfMesh(const std::string& path, const ScanContent& content)
{
  if (content.faces > 0)
    warnOnce("'" + path + "' is a mesh of " + std::to_string(content.faces) +
             (content.faces == 1 ? " face" : " faces") + ": only its " +
             std::to_string(content.points->size()) +
             " vertices are taken, as points; if they stand too far apart, "
             "pcl_mesh_sampling makes more of it");
}

/** @brief Returns the rotation that turns an axis, such as y or -z, to z; x stays, or y
 * if x is turned. */
Eigen::Matrix3d
turnToZ(const std::string& up)
{
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  const auto axis = up.empty() ? 2 : Eigen::Index{up.back() - 'x'};
  turn.row(2) = (up.size() > 1 ? -1 : 1) * Eigen::RowVector3d::Unit(axis);
  if (axis == 0) {
    turn.row(1) = Eigen::RowVector3d::UnitY();
    turn.row(0) = turn.row(1).cross(turn.row(2));
  }
  else
    turn.row(1) = turn.row(2).cross(turn.row(0));
  return turn;
}

/** @brief Returns a row whose coordinates and normals are in another frame, along the
 * same axes. */
StoredRow
turned(const StoredRow& row, const Eigen::Matrix3d& turn)
{
  StoredRow result = row;
  for (const std::string group : {"", "normal_"})
    for (Eigen::Index axis = 0; axis < 3 && !turn.isIdentity(0); ++axis) {
      Eigen::Index old = 0;
      turn.row(axis).cwiseAbs().maxCoeff(&old);
      for (std::size_t k = 0; k < row.fields.size(); ++k)
        if (row.fields[k].name == group + "xyz"[old])
          for (StoredField& field : result.fields)
            if (field.name == group + "xyz"[axis]) { // keeps its place among the fields
              const std::string name = field.name;
              field = row.fields[k];
              field.name = name;
              field.scale *= turn(axis, old);
              field.shift *= turn(axis, old);
              field.becomes_float = true;
            }
    }
  return result;
}

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

bool
isMesh(const std::string& path)
{
  return openScan(path, {}).faces > 0;
}

ScanFile::ScanFile(const std::string& path, const ScanSettings& settings)
    : path_(path)
    , positions_(settings.positions)
    , unit_(settings.unit.value_or(1))
    , piece_bytes_(settings.piece_bytes)
    , turn_(turnToZ(settings.up))
    , content_(openScan(path, settings))
    , row_(turned(content_.points->row(), turn_))
{
  checkCoordinates();
  content_.orientation = Eigen::Quaternionf(turn_.cast<float>()) * content_.orientation;
  content_.counted_from.place = turn_ * content_.counted_from.place;
  settleOrigin(settings);
  plan_.emplace(row_, unit_, shift_);
}

void
ScanFile::checkCoordinates() const
{
  const auto& fields = row_.fields;
  std::string names;
  for (const auto& field : fields)
    names += " " + quotedWord(field.name);
  for (const char* name : {"x", "y", "z"}) {
    const auto times = std::count_if(fields.begin(), fields.end(),
                                     [&](const auto& f) { return f.name == name; });
    if (times != 1)
      throw ToolError("'" + path_ + "' has " +
                      (times == 0 ? "no field" : "two fields") + " '" + name +
                      "', its fields are:" + names);
  }
}

Eigen::Vector4f
ScanFile::viewpoint() const
{
  Eigen::Vector4f viewpoint = Eigen::Vector4f::Zero();
  if (content_.viewpoint)
    viewpoint.head<3>() = inMetres(*content_.viewpoint);
  return viewpoint;
}

void
ScanFile::forEachStored(
    std::size_t begin,
    std::size_t end,
    const std::function<bool(const Piece&, const Chunk&)>& see) const
{
  constexpr std::size_t rows_at_once = std::size_t{1} << 14;
  if (begin == 0)
    warnOfMesh(path_, content_);
  const std::size_t stored_size = row_.size;
  const std::size_t rows_a_piece =
      std::max<std::size_t>(1, piece_bytes_ / std::max(stored_size, rowSize()));
  std::vector<std::uint8_t> rows;
  Chunk chunk;
  chunk.first = begin;
  for (bool goes_on = true; goes_on && begin < end; begin += chunk.size) {
    content_.points->next(chunk, std::min(rows_a_piece, end - begin));
    Piece piece{chunk.rows.data(), chunk.first, chunk.size};
    if (!plan_->isPlain()) {
      rows.resize(chunk.size * rowSize());
      parallelBlocks(chunk.size, rows_at_once, 0,
                     [&](std::size_t from, std::size_t to) {
                       plan_->convert(chunk.rows.data() + from * stored_size, to - from,
                                      rows.data() + from * rowSize());
                     });
      piece.rows = rows.data();
    }
    goes_on = see(piece, chunk);
  }
}

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
