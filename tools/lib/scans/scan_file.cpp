// SPDX-License-Identifier: BSD-3-Clause
#include "scan_file.h"

#include "cloud_rows.h"
#include "plain_text.h"
#include "run_tool.h"
#include "tool_error.h"

#include "sedr_filters/src/base/parallel.h"

#include <algorithm>
#include <future>

namespace pcl::sedr::tools {

namespace {

void
checkCoordinates(const pcl::PCLPointCloud2& blob, const std::string& path)
{
  std::string names;
  for (const auto& field : blob.fields)
    names += " " + quotedWord(field.name);
  for (const char* name : {"x", "y", "z"}) {
    const auto times = std::count_if(blob.fields.begin(), blob.fields.end(),
                                     [&](const auto& f) { return f.name == name; });
    if (times != 1)
      throw ToolError("'" + path + "' has " + (times == 0 ? "no field" : "two fields") +
                      " '" + name + "', its fields are:" + names);
  }
}

bool
isInPieces(const FileLayout& layout)
{
  return layout.data != FileData::Ascii && layout.data != FileData::Compressed;
}

/** @brief Warns once per file that only the vertices of a mesh are read. */
void
warnOfMesh(const std::string& path, const FileLayout& layout)
{
  if (layout.faces > 0)
    warnOnce("'" + path + "' is a mesh of " + std::to_string(layout.faces) +
             (layout.faces == 1 ? " face" : " faces") + ": only its " +
             std::to_string(layout.blob.width) +
             " vertices are taken, as points; if they stand too far apart, "
             "pcl_mesh_sampling makes more of it");
}

/** @brief Calls `read`. An error of it is due to the file's end, if that got lost
 * meanwhile. */
template <typename Read>
auto
wholly(const MappedFile& file, const Read& read)
{
  try {
    return read();
  }
  catch (const ToolError&) {
    file.checkWhole();
    throw;
  }
}

} // namespace

ScanHead
readScanHead(const std::string& path, const ScanSettings& settings)
{
  const MappedFile file(path);
  const FileLayout layout =
      wholly(file, [&] { return readLayout(file, path, settings); });
  return {layout.blob.width, isInPieces(layout), layout.faces > 0};
}

/** @brief Prefetches the pages of a piece and releases them after use, while its
 * neighbours are read. */
class ScanFile::PageTurner {
public:
  explicit PageTurner(const ScanFile& scan)
      : scan_(scan)
  {}

  /** @brief Declares rows before `begin` as done and those from `end` on as next. */
  void turn(std::size_t begin, std::size_t end, std::size_t next_end)
  {
    if (!scan_.unpacked_.empty())
      return;
    if (turned_.valid())
      turned_.wait();
    const std::size_t from = scan_.placeOf(begin);
    const std::size_t to = scan_.placeOf(end);
    const std::size_t last = scan_.placeOf(next_end);
    const std::size_t done = done_;
    done_ = from;
    turned_ = std::async([this, from, to, last, done] {
      if (done < from)
        scan_.file_.release(done, from - done);
      scan_.file_.expect(to, last - to);
    });
  }

private:
  const ScanFile& scan_;
  std::size_t done_ = std::string::npos; ///< pages before this byte are released
  std::future<void> turned_;
};

ScanFile::ScanFile(const std::string& path, const ScanSettings& settings)
    : path_(path)
    , positions_(settings.positions)
    , unit_(settings.unit)
    , piece_bytes_(settings.piece_bytes)
    , file_(path)
    , layout_(wholly(file_, [&] { return readLayout(file_, path, settings); }))
{
  wholly(file_, [&] { prepare(settings); });
}

void
ScanFile::prepare(const ScanSettings& settings)
{
  if (!isInPieces(layout_)) {
    unpacked_ = readPoints(file_, layout_, path_).data;
    rows_ = unpacked_.data();
  }
  else
    rows_ = file_.data() + layout_.begin;
  checkCoordinates(layout_.blob, path_);
  settleOrigin(settings);

  pcl::PCLPointCloud2 named = rawRows(0, 1);
  if (layout_.is_ply)
    nameAsPcl(named);
  plan_ =
      std::make_unique<RowPlan>(named.fields, named.point_step, unit_, shift_,
                                settings.keeps_doubles ? pcl::PCLPointField::FLOAT64
                                                       : pcl::PCLPointField::FLOAT32,
                                path_);
  is_plain_ =
      layout_.data != FileData::BinaryBigEndian && layout_.data != FileData::Decoded &&
      plan_->isPlain() && named.point_step == layout_.blob.point_step &&
      std::equal(named.fields.begin(), named.fields.end(), layout_.blob.fields.begin(),
                 layout_.blob.fields.end(), [](const auto& a, const auto& b) {
                   return a.offset == b.offset && a.datatype == b.datatype &&
                          a.count == b.count;
                 });
}

Eigen::Vector4f
ScanFile::viewpoint() const
{
  Eigen::Vector4f viewpoint = Eigen::Vector4f::Zero();
  if (layout_.viewpoint)
    viewpoint.head<3>() = inMetres(*layout_.viewpoint);
  return viewpoint;
}

std::vector<ScanStation>
ScanFile::stations() const
{
  std::vector<ScanStation> stations;
  if (layout_.reader)
    stations = layout_.reader->stations();
  for (ScanStation& station : stations)
    station.position = unit_ * station.position - shift_;
  return stations;
}

std::size_t
ScanFile::placeOf(std::size_t row) const
{
  return layout_.reader ? layout_.reader->placeOf(row)
                        : layout_.begin + row * layout_.blob.point_step;
}

pcl::PCLPointCloud2
ScanFile::rawRows(std::size_t first, std::size_t size) const
{
  pcl::PCLPointCloud2 blob = layout_.blob;
  blob.width = static_cast<pcl::uindex_t>(size);
  blob.row_step = blob.width * blob.point_step;
  if (layout_.reader) {
    blob.data.resize(size * blob.point_step);
    layout_.reader->read(first, size, blob.data.data());
    return blob;
  }
  blob.data.assign(rows_ + first * blob.point_step,
                   rows_ + (first + size) * blob.point_step);
  if (layout_.data == FileData::BinaryBigEndian)
    swapBytes(blob);
  return blob;
}

void
ScanFile::tidyRows(std::size_t first, std::size_t size, std::uint8_t* rows) const
{
  pcl::PCLPointCloud2 blob = rawRows(first, size);
  if (layout_.is_ply)
    nameAsPcl(blob);
  plan_->bring(blob.data.data(), size, rows);
}

void
ScanFile::forEachPiece(std::size_t begin,
                       std::size_t end,
                       const std::function<bool(const Piece&)>& see) const
{
  // Larger pieces for decoded files: decoding and its start take longer than copying.
  const std::size_t rows_at_once = std::size_t{1} << (layout_.reader ? 15 : 14);
  if (begin == 0)
    warnOfMesh(path_, layout_);
  const std::size_t raw_size = layout_.blob.point_step;
  const std::size_t rows_a_piece =
      std::max<std::size_t>(1, piece_bytes_ / std::max(raw_size, rowSize()));
  std::vector<std::uint8_t> copy;
  bool goes_on = true;
  {
    PageTurner pages(*this);
    for (std::size_t first = begin; first < end && goes_on; first += rows_a_piece) {
      const std::size_t rows = std::min(rows_a_piece, end - first);
      const std::size_t next = first + rows;
      pages.turn(first, next, std::min(next + rows_a_piece, end));
      Piece piece{rows_ + first * raw_size, first, rows};
      if (!is_plain_) {
        copy.resize(rows * rowSize());
        wholly(file_, [&] {
          parallelBlocks(rows, rows_at_once, 0, [&](std::size_t from, std::size_t to) {
            tidyRows(first + from, to - from, copy.data() + from * rowSize());
          });
        });
        piece.rows = copy.data();
      }
      goes_on = see(piece);
      file_.checkWhole();
    }
  }
  if (unpacked_.empty())
    file_.release(placeOf(begin), placeOf(end) - placeOf(begin));
}

} // namespace pcl::sedr::tools
