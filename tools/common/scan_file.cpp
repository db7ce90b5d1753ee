// SPDX-License-Identifier: BSD-3-Clause
#include "scan_file.h"

#include "cloud_rows.h"
#include "run_tool.h"
#include "tool_error.h"

#include <pcl/sedr_filters/field_access.h>
#include <pcl/sedr_filters/middle_value.h>
#include <pcl/sedr_filters/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <future>
#include <mutex>
#include <set>
#include <sstream>

namespace pcl {
namespace sedr {
namespace tools {

namespace {

constexpr double float_step = 1.0 / (1 << 23); // between floats, relative
constexpr double coarsest = 0.001;             // metres
constexpr std::size_t sample_size = 20000;

void
checkCoordinates(const pcl::PCLPointCloud2& blob, const std::string& path)
{
  std::string names;
  for (const auto& field : blob.fields)
    names += " " + field.name;
  for (const char* name : {"x", "y", "z"})
    if (!findField(blob, name))
      throw ToolError("'" + path + "' has no field '" + name +
                      "', its fields are:" + names);
}

/** @brief Leaves out padding and turns x, y and z into FLOAT32 metres, scaled as
 * doubles. */
void
tidyFields(pcl::PCLPointCloud2& blob, const std::string& path, double unit)
{
  pcl::PCLPointCloud2 tidy;
  std::vector<pcl::PCLPointField> sources;
  std::vector<bool> is_converted;
  bool is_tidy = true;
  for (const auto& field : blob.fields) {
    const bool is_coordinate =
        field.name == "x" || field.name == "y" || field.name == "z";
    const bool converts =
        is_coordinate && (unit != 1 || field.datatype != pcl::PCLPointField::FLOAT32 ||
                          field.count != 1);
    is_tidy = is_tidy && field.name != "_" && !converts;
    if (field.name == "_")
      continue;
    sources.push_back(field);
    is_converted.push_back(converts);
    tidy.fields.push_back(field);
    if (converts) {
      tidy.fields.back().datatype = pcl::PCLPointField::FLOAT32;
      tidy.fields.back().count = 1;
    }
  }
  if (is_tidy)
    return;
  layOut(tidy, blob.width, path);
  tidy.data.assign(std::size_t{tidy.width} * tidy.point_step, 0);
  for (std::size_t i = 0; i < tidy.width; ++i)
    for (std::size_t f = 0; f < sources.size(); ++f) {
      const auto& to = tidy.fields[f];
      const auto* from = &blob.data[i * blob.point_step + sources[f].offset];
      auto* where = &tidy.data[i * tidy.point_step + to.offset];
      if (is_converted[f])
        writeField(where, to.datatype, unit * readField(from, sources[f].datatype));
      else
        std::memcpy(where, from, fieldSize(to.datatype) * to.count);
    }
  blob = std::move(tidy);
}

/** @brief Whether heights spread, but for a hundredth at each end, over more metres
 * than any building has. */
bool
couldBeMillimetres(std::vector<double> heights)
{
  constexpr double highest = 200;
  std::sort(heights.begin(), heights.end());
  const std::size_t cut = heights.size() / 100;
  return heights[heights.size() - 1 - cut] - heights[cut] > highest;
}

/** @brief x, y, z and the largest of their sizes, metres, of rows that are finite. */
using Places = std::array<std::vector<double>, 4>;

FileLayout
layoutOf(const MappedFile& file, const std::string& path)
{
  if (!looksLikePly(file) && !looksLikePcd(file))
    throw ToolError("'" + path + "' is neither a PCD nor a PLY file");
  return looksLikePly(file) ? readPlyLayout(file, path) : readPcdLayout(file, path);
}

bool
isInPieces(const FileLayout& layout)
{
  return layout.data == FileData::Binary || layout.data == FileData::BinaryBigEndian;
}

void
addPlaces(const pcl::PCLPointCloud2& blob, double unit, Places& places)
{
  const std::array<const pcl::PCLPointField*, 3> xyz{
      findField(blob, "x"), findField(blob, "y"), findField(blob, "z")};
  for (std::size_t i = 0; i < blob.width; ++i) {
    std::array<double, 3> p{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      p[axis] = unit * readField(&blob.data[i * blob.point_step + xyz[axis]->offset],
                                 xyz[axis]->datatype);
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
      continue;
    for (std::size_t axis = 0; axis < 3; ++axis)
      places[axis].push_back(p[axis]);
    places[3].push_back(std::max({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])}));
  }
}

/** @brief Says, once for a file, that of a mesh the vertices alone are read. */
void
warnOfMesh(const std::string& path, const FileLayout& layout)
{
  static std::mutex mutex;
  static std::set<std::string> told;
  const std::lock_guard<std::mutex> lock(mutex);
  if (layout.faces > 0 && told.insert(path).second)
    warn("'" + path + "' is a mesh of " + std::to_string(layout.faces) +
         (layout.faces == 1 ? " face" : " faces") + ": only its " +
         std::to_string(layout.blob.width) +
         " vertices are taken, as points; if they stand too far apart, "
         "pcl_mesh_sampling makes more of it");
}

} // namespace

ScanHead
readScanHead(const std::string& path)
{
  const FileLayout layout = layoutOf(MappedFile(path), path);
  return {layout.blob.width, isInPieces(layout), layout.faces > 0};
}

ScanFile::ScanFile(const std::string& path, double unit, std::size_t piece_bytes)
    : path_(path)
    , unit_(unit)
    , piece_bytes_(piece_bytes)
    , file_(path)
    , layout_(layoutOf(file_, path))
{
  if (!isInPieces(layout_)) {
    unpacked_ = readPoints(file_, layout_, path).data;
    rows_ = unpacked_.data();
  }
  else
    rows_ = file_.data() + layout_.begin;
  checkCoordinates(layout_.blob, path);
  checkExtent();

  tidy_ = rawRows(0, 1);
  tidy(tidy_);
  is_plain_ =
      layout_.data != FileData::BinaryBigEndian && unit == 1 &&
      tidy_.point_step == layout_.blob.point_step &&
      std::equal(tidy_.fields.begin(), tidy_.fields.end(), layout_.blob.fields.begin(),
                 layout_.blob.fields.end(), [](const auto& a, const auto& b) {
                   return a.offset == b.offset && a.datatype == b.datatype &&
                          a.count == b.count;
                 });
}

Eigen::Vector4f
ScanFile::origin() const
{
  Eigen::Vector4f origin = layout_.origin;
  origin.head<3>() *= static_cast<float>(unit_);
  return origin;
}

pcl::PCLPointCloud2
ScanFile::rawRows(std::size_t first, std::size_t size) const
{
  pcl::PCLPointCloud2 blob = layout_.blob;
  blob.width = static_cast<pcl::uindex_t>(size);
  blob.row_step = blob.width * blob.point_step;
  blob.data.assign(rows_ + first * blob.point_step,
                   rows_ + (first + size) * blob.point_step);
  if (layout_.data == FileData::BinaryBigEndian)
    swapBytes(blob);
  return blob;
}

void
ScanFile::tidy(pcl::PCLPointCloud2& blob) const
{
  if (layout_.is_ply)
    nameAsPcl(blob);
  tidyFields(blob, path_, unit_);
}

void
ScanFile::forEachPiece(std::size_t begin,
                       std::size_t end,
                       const std::function<bool(const Piece&)>& see) const
{
  constexpr std::size_t rows_at_once = std::size_t{1} << 14;
  if (begin == 0)
    warnOfMesh(path_, layout_);
  const std::size_t raw_size = layout_.blob.point_step;
  const std::size_t rows_a_piece =
      std::max<std::size_t>(1, piece_bytes_ / std::max(raw_size, rowSize()));
  const bool is_mapped = unpacked_.empty();
  std::vector<std::uint8_t> copy;
  std::future<void> turned; // pages, while their neighbours are read
  const auto turnPages = [&](std::size_t at, std::size_t size, bool is_first) {
    if (turned.valid())
      turned.wait();
    turned = std::async([this, at, size, is_first] {
      if (!is_first)
        file_.release(at - size, size);
      file_.expect(at + size, size);
    });
  };
  bool goes_on = true;
  for (std::size_t first = begin; first < end && goes_on; first += rows_a_piece) {
    const std::size_t rows = std::min(rows_a_piece, end - first);
    if (is_mapped)
      turnPages(layout_.begin + first * raw_size, rows_a_piece * raw_size,
                first == begin);
    Piece piece{rows_ + first * raw_size, first, rows};
    if (!is_plain_) {
      copy.resize(rows * rowSize());
      parallelBlocks(rows, rows_at_once, 0, [&](std::size_t from, std::size_t to) {
        pcl::PCLPointCloud2 blob = rawRows(first + from, to - from);
        tidy(blob);
        std::copy(blob.data.begin(), blob.data.end(),
                  copy.begin() + static_cast<std::ptrdiff_t>(from * rowSize()));
      });
      piece.rows = copy.data();
    }
    goes_on = see(piece);
  }
  turned = {};
  if (is_mapped)
    file_.release(layout_.begin + begin * raw_size, (end - begin) * raw_size);
}

/** Refuses scans without a finite point, and those that lie, but for stray points, too
 * far from the origin for a float of metres. */
void
ScanFile::checkExtent() const
{
  constexpr std::size_t run = 100; // rows beside one another share a page
  Places places;
  const std::size_t step = std::max<std::size_t>(1, size() / (sample_size / run));
  if (size() > sample_size)
    for (std::size_t first = 0; first + run <= size(); first += step)
      addPlaces(rawRows(first, run), unit_, places);
  // All of a small scan, and enough of one in which hardly a point is finite.
  const bool is_enough = places[3].size() >= run;
  if (!is_enough)
    places = Places();
  for (std::size_t first = 0;
       !is_enough && first < size() && places[3].size() < sample_size;
       first += sample_size)
    addPlaces(rawRows(first, std::min(sample_size, size() - first)), unit_, places);
  if (unpacked_.empty())
    file_.release(layout_.begin, size() * layout_.blob.point_step);
  if (places[3].empty())
    throw ToolError("'" + path_ + "' has no finite point among its " +
                    std::to_string(size()));
  const double farthest = middleValue(places[3]);
  if (farthest * float_step <= coarsest)
    return;
  if (unit_ == 1 && couldBeMillimetres(places[2]))
    throw ToolError(
        "the coordinates of '" + path_ +
        "' are too large for metres; if the unit is the millimetre, scale by "
        "0.001 (--unit 0.001 in pcl_sedr)");
  std::ostringstream sentence;
  sentence.precision(2);
  sentence << "the coordinates of '" << path_ << "' are too large: at "
           << static_cast<long long>(std::min(farthest, 1e18))
           << " m a float resolves no finer than " << farthest * float_step * 1000
           << " mm; subtract an origin first, say (";
  for (std::size_t axis = 0; axis < 3; ++axis)
    sentence << (axis > 0 ? ", " : "")
             << static_cast<long long>(std::clamp(
                    std::round(middleValue(places[axis]) / 1000) * 1000, -1e18, 1e18));
  throw ToolError(sentence.str() + ") m");
}

} // namespace tools
} // namespace sedr
} // namespace pcl
