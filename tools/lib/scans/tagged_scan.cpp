// SPDX-License-Identifier: BSD-3-Clause
#include "tagged_scan.h"

#include "bytes/whole_file.h"
#include "formats/las_output.h"
#include "run_tool.h"
#include "tool_cloud.h"
#include "tool_error.h"

#include "sedr_filters/src/base/field_access.h"
#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/base/parallel.h"

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <ostream>
#include <vector>

namespace pcl::sedr::tools {

namespace {

constexpr std::array<const char*, 3> tag_names{"label", "room", "owner"};

/** @brief Returns the tags of the points of a piece. */
std::vector<PointTag>
tagsOf(const RowSource::Piece& piece,
       RowCoordinates& coordinates,
       const TagOf& tag_of,
       unsigned threads)
{
  constexpr std::size_t rows_at_once = std::size_t{1} << 12;
  const PointView points = coordinates.of(piece.rows, piece.size, threads);
  std::vector<PointTag> tags(piece.size);
  parallelFor(piece.size, rows_at_once, threads,
              [&](std::size_t i) { tags[i] = tag_of(points[i]); });
  return tags;
}

/** @brief A scan whose rows have the tags as further fields, in place of fields of
 * these names. */
class TaggedRows : public RowSource {
public:
  TaggedRows(const RowSource& scan, const TagOf& tag_of, unsigned threads)
      : scan_(scan)
      , tag_of_(tag_of)
      , threads_(threads)
  {
    const auto add = [this](pcl::PCLPointField field) {
      field.offset = static_cast<pcl::uindex_t>(row_size_);
      row_size_ += fieldSize(field.datatype) * field.count;
      fields_.push_back(field);
    };
    for (const pcl::PCLPointField& field : scan.fields())
      if (std::find(tag_names.begin(), tag_names.end(), field.name) ==
          tag_names.end()) {
        from_.push_back(field.offset);
        add(field);
      }
    for (const char* name : tag_names) {
      pcl::PCLPointField field;
      field.name = name;
      field.datatype = pcl::PCLPointField::UINT32;
      field.count = 1;
      add(field);
    }
  }

  const std::vector<pcl::PCLPointField>& fields() const override { return fields_; }
  std::size_t rowSize() const override { return row_size_; }
  std::size_t size() const override { return scan_.size(); }

  void forEachPiece(const std::function<bool(const Piece&)>& see) const override
  {
    RowCoordinates coordinates(scan_.fields(), scan_.rowSize());
    std::vector<std::uint8_t> rows;
    scan_.forEachPiece([&](const Piece& piece) {
      const std::vector<PointTag> tags = tagsOf(piece, coordinates, tag_of_, threads_);
      rows.resize(piece.size * row_size_);
      for (std::size_t i = 0; i < piece.size; ++i) {
        std::uint8_t* const to = &rows[i * row_size_];
        for (std::size_t f = 0; f < from_.size(); ++f)
          std::memcpy(to + fields_[f].offset,
                      piece.rows + i * scan_.rowSize() + from_[f],
                      fieldSize(fields_[f].datatype) * fields_[f].count);
        std::memcpy(to + row_size_ - sizeof(PointTag), &tags[i], sizeof(PointTag));
      }
      return see({rows.data(), piece.first, piece.size});
    });
  }

private:
  const RowSource& scan_;
  const TagOf& tag_of_;
  unsigned threads_;
  std::vector<pcl::PCLPointField> fields_;
  std::vector<std::size_t> from_; ///< offsets in the rows of the scan
  std::size_t row_size_ = 0;
};

/** @brief Returns what stands before the points if all files are LAS with points of one
 * layout, with the records of the first; else nothing. */
LasHead
commonHead(const JointScan& scan)
{
  LasHead common;
  for (const auto& file : scan.files()) {
    const InputFile input(file->path());
    if (!looksLikeLas(input))
      return {};
    LasHead head{std::string(input.numberAt<std::uint32_t>(las::begin), '\0')};
    input.read(0, head.bytes.size(), head.bytes.data());
    if (common.bytes.empty())
      common = head;
    else if (!common.isLike(head)) {
      warn("the points of '" + file->path() + "' have another layout than those of '" +
           scan.files()[0]->path() +
           "': times, returns and coordinate system are not in the classified scan");
      return {};
    }
  }
  return common;
}

/** @brief Makes points of LAS of those of other formats. */
class LasPoints {
public:
  explicit LasPoints(const JointScan& scan)
      : has_colours_(scan.hasColours())
  {
    const ScanFile& first = *scan.files().front();
    Chunk chunk;
    first.forEachStored(0, 1, [&](const RowSource::Piece&, const Chunk& stored) {
      chunk = stored;
      return false;
    });
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double near =
          first.storedRow().find({"xyz"[axis]})->valueIn(chunk.rows.data());
      shift_[axis] = std::isfinite(near) ? std::round(near) : 0;
    }
  }

  /** @brief Returns the head of a LAS 1.4 without points. */
  LasHead head() const
  {
    LasHead head{std::string(las::header_of_1_4, '\0')};
    head.bytes.replace(0, 4, "LASF");
    head.bytes.replace(las::software, 4, "SEDR");
    head.set(las::encoding, std::uint16_t{16}); // a coordinate system is told by WKT
    head.set(las::version, std::array<std::uint8_t, 2>{1, las::newest_minor});
    head.set(las::header_size, std::uint16_t{las::header_of_1_4});
    head.set(las::begin, std::uint32_t{las::header_of_1_4});
    const unsigned format = has_colours_ ? 7 : 6;
    head.set(las::format, static_cast<std::uint8_t>(format));
    head.set(las::record, static_cast<std::uint16_t>(las::sizes[format]));
    head.set(las::scale, std::array<double, 3>{finest, finest, finest});
    head.set(las::shift, shift_);
    return head;
  }

  /** @brief Returns the bytes of a point, null for one without coordinates. */
  const std::uint8_t*
  of(const ScanFile& file, const std::uint8_t* stored, const std::uint8_t* row)
  {
    point_.clear();
    Eigen::Vector3d place;
    for (int axis = 0; axis < 3; ++axis)
      place[axis] = file.storedRow().find({"xyz"[axis]})->valueIn(stored);
    if (!place.allFinite())
      return nullptr;
    for (std::size_t axis = 0; axis < 3; ++axis)
      appendBytes(point_, stepsTo(place[static_cast<Eigen::Index>(axis)], axis));
    const StoredField* const intensity = file.storedRow().find("intensity");
    const bool has_intensity =
        intensity && (intensity->datatype == StoredField::UINT16 ||
                      intensity->datatype == StoredField::UINT8);
    appendBytes(point_, static_cast<std::uint16_t>(
                            has_intensity ? intensity->valueIn(stored) : 0));
    appendBytes(point_, std::uint8_t{0x11}); // the first of one return
    appendBytes(
        point_,
        std::array<char, 15>{}); // flags, class, user data, angle, source and time
    const auto* const colour = file.colour();
    for (std::size_t k = 3; k-- > 0 && has_colours_;) { // blue is the first byte
      const unsigned channel = colour ? row[colour->offset + k] : 0;
      appendBytes(point_,
                  static_cast<std::uint16_t>(257 * channel)); // 255 becomes 65535
    }
    return reinterpret_cast<const std::uint8_t*>(point_.data());
  }

private:
  static constexpr double finest = 0.0001;

  std::int32_t stepsTo(double place, std::size_t axis) const
  {
    const double steps = std::round((place - shift_[axis]) / finest);
    constexpr double most = std::numeric_limits<std::int32_t>::max();
    if (std::abs(steps) > most)
      throw ToolError(formatText("LAS in steps of %g reaches %.0f units of the scan "
                                 "from %c = %.0f, but a point is at %.0f: write .pcd",
                                 finest, most * finest, "xyz"[axis], shift_[axis],
                                 place));
    return static_cast<std::int32_t>(steps);
  }

  bool has_colours_;
  std::array<double, 3> shift_{};
  std::string point_;
};

void
saveLas(const std::string& path,
        const JointScan& scan,
        const TagOf& tag_of,
        unsigned threads,
        std::ostream& stream)
{
  const LasHead common = commonHead(scan);
  const bool is_las = !common.bytes.empty();
  LasPoints points(scan);
  LasOutput output(stream, is_las ? common : points.head());
  std::size_t left_out = 0;
  for (const auto& file : scan.files()) {
    RowCoordinates coordinates(file->fields(), file->rowSize());
    const auto write = [&](const RowSource::Piece& piece, const Chunk& stored) {
      const std::vector<PointTag> tags = tagsOf(piece, coordinates, tag_of, threads);
      for (std::size_t i = 0; i < piece.size; ++i) {
        const auto* const own = &stored.rows[i * file->storedRow().size];
        const auto* const point =
            is_las ? own : points.of(*file, own, piece.rows + i * file->rowSize());
        left_out += point ? 0 : 1;
        if (point)
          output.add(point, tags[i]);
      }
      return stream.good(); // a full disk is reported when the file is closed
    };
    file->forEachStored(0, file->size(), write);
  }
  const ScanFile& first = *scan.files().front();
  if (is_las)
    output.addRest(InputFile(first.path()),
                   common.bytes.size() + first.size() * first.storedRow().size);
  output.finish();
  if (left_out > 0)
    warn(std::to_string(left_out) + " points without coordinates are not in '" + path +
         "'");
}

} // namespace

void
checkTaggedOutput(const std::string& path)
{
  checkOutput(path, "a classified scan", {".las", ".pcd"});
}

void
saveTagged(const std::string& path,
           const JointScan& scan,
           const TagOf& tag_of,
           unsigned threads)
{
  if (hasExtension(path, ".pcd"))
    return saveScan(path, TaggedRows(scan, tag_of, threads), *scan.files().front());
  writeWhole(path, [&](std::ostream& stream) {
    saveLas(path, scan, tag_of, threads, stream);
  });
}

} // namespace pcl::sedr::tools
