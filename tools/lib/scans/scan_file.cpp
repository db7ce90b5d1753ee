// SPDX-License-Identifier: BSD-3-Clause
#include "scan_file.h"

#include "plain_text.h"
#include "run_tool.h"
#include "tool_error.h"

#include "sedr_filters/src/base/parallel.h"

#include <algorithm>

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

} // namespace

bool
isMesh(const std::string& path)
{
  return openScan(path, {}).faces > 0;
}

ScanFile::ScanFile(const std::string& path, const ScanSettings& settings)
    : path_(path)
    , positions_(settings.positions)
    , unit_(settings.unit)
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

} // namespace pcl::sedr::tools
