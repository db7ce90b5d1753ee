// SPDX-License-Identifier: BSD-3-Clause
#include "tagged_scan.h"

#include "bytes/whole_file.h"
#include "run_tool.h"
#include "tool_cloud.h"
#include "tool_error.h"

#include "sedr_filters/src/base/field_access.h"
#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/base/parallel_for.h"
#include <pcl/sedr_filters/structure_label.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <ostream>
#include <vector>

namespace pcl::sedr::tools {

namespace {

constexpr std::array<const char*, 3> tag_names{"label", "room", "owner"};
constexpr std::size_t rows_at_once = std::size_t{1} << 12;

/** @brief Returns the tags of the points of a piece. */
std::vector<PointTag>
tagsOf(const RowSource::Piece& piece,
       RowCoordinates& coordinates,
       const TagOf& tag_of,
       unsigned threads)
{
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

/** @brief Writes a LAS file: points first, then the header before them. */
class LasStream {
public:
  LasStream(std::ostream& stream, const ScanFile& first, bool has_colours)
      : stream_(stream)
      , has_colours_(has_colours)
  {
    Chunk chunk;
    first.forEachStored(0, 1, [&](const RowSource::Piece&, const Chunk& stored) {
      chunk = stored;
      return false;
    });
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const StoredField& field = *first.storedRow().find({"xyz"[axis]});
      const bool is_whole = field.datatype == pcl::PCLPointField::INT32;
      const double near = field.valueIn(chunk.rows.data());
      scale_[axis] = is_whole ? field.scale : finest;
      shift_[axis] = is_whole              ? field.shift
                     : std::isfinite(near) ? std::round(near)
                                           : 0;
    }
    writeHeader();
  }

  void add(const Eigen::Vector3d& place,
           std::uint16_t intensity,
           const std::array<std::uint8_t, 3>& colour,
           const PointTag& tag)
  {
    if (!place.allFinite()) {
      ++left_out_;
      return;
    }
    const std::uint32_t room = std::max(tag.room, tag.owner);
    if (room > std::numeric_limits<std::uint16_t>::max())
      throw ToolError("room " + std::to_string(room) +
                      " has no number of 16 bits, as LAS needs: write .pcd");
    bytes_.clear();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<Eigen::Index>(axis);
      const double steps = std::round((place[a] - shift_[axis]) / scale_[axis]);
      constexpr double most = std::numeric_limits<std::int32_t>::max();
      if (std::abs(steps) > most)
        throw ToolError(formatText("LAS in steps of %g reaches %.0f units of the scan "
                                   "from %c = %.0f, but a point is at %.0f: write .pcd",
                                   scale_[axis], most * scale_[axis], "xyz"[axis],
                                   shift_[axis], place[a]));
      put(static_cast<std::int32_t>(steps));
    }
    bounds_.extend(place);
    put(intensity);
    put(std::uint8_t{0x11}); // the first of one return
    put(std::uint8_t{0});
    put(classOf(tag.label));
    put(std::uint8_t{0});        // user data
    put(std::array<char, 12>{}); // angle, source and time
    for (const std::uint8_t channel : colour)
      if (has_colours_)
        put(static_cast<std::uint16_t>(257 * channel)); // 255 becomes 65535
    put(static_cast<std::uint8_t>(tag.label));
    put(static_cast<std::uint16_t>(tag.room));
    put(static_cast<std::uint16_t>(tag.owner));
    stream_.write(bytes_.data(), static_cast<std::streamsize>(bytes_.size()));
    ++points_;
  }

  /** @brief Writes the header again, which counts the points.
   * @return how many were left out */
  std::size_t finish()
  {
    stream_.seekp(0);
    writeHeader();
    return left_out_;
  }

private:
  static constexpr double finest = 0.0001;
  static constexpr std::uint16_t header_size = 375;
  static constexpr std::uint16_t descriptor_size = 192;
  static constexpr std::uint16_t all_descriptors = tag_names.size() * descriptor_size;
  static constexpr std::uint32_t points_begin = header_size + 54 + all_descriptors;

  static std::uint8_t classOf(std::uint32_t label)
  {
    const auto is = [label](StructureLabel l) {
      return label == static_cast<std::uint32_t>(l);
    };
    const bool is_building = is(StructureLabel::Wall) || is(StructureLabel::Ceiling) ||
                             is(StructureLabel::Detail) || is(StructureLabel::Column);
    return is(StructureLabel::Floor) ? 2 : is_building ? 6 : 1;
  }

  template <typename T>
  void put(const T& value)
  {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }

  void putText(const std::string& text, std::size_t size)
  {
    bytes_ += text;
    bytes_.append(size - text.size(), '\0');
  }

  void writeHeader()
  {
    bytes_.clear();
    putText("LASF", 4 + 2);
    put(std::uint16_t{16}); // coordinate systems are told by WKT, if at all
    putText("", 16);
    put(std::array<std::uint8_t, 2>{1, 4});
    putText("", 32);
    putText("SEDR", 32 + 4);
    put(header_size);
    put(points_begin);
    put(std::uint32_t{1}); // records before the points
    put(std::uint8_t(has_colours_ ? 7 : 6));
    put(std::uint16_t(has_colours_ ? 36 + 5 : 30 + 5));
    putText("", 6 * 4); // counts of LAS 1.3
    for (const auto& numbers : {scale_, shift_})
      for (const double number : numbers)
        put(number);
    for (int axis = 0; axis < 3; ++axis) {
      put(points_ > 0 ? bounds_.max()[axis] : 0.0);
      put(points_ > 0 ? bounds_.min()[axis] : 0.0);
    }
    putText("", 8 + 8 + 4); // waveforms, records behind the points
    put(points_);
    put(points_); // first returns
    putText("", 14 * 8);
    putText("", 2);
    putText("LASF_Spec", 16);
    put(std::uint16_t{4}); // extra bytes
    put(all_descriptors);
    putText("", 32);
    const std::array<const char*, 3> texts{"1ceil 2floor 3wall 4detail 5col",
                                           "room of the label, 0 none",
                                           "room around the point, 0 none"};
    for (std::size_t k = 0; k < tag_names.size(); ++k) {
      putText("", 2);
      put(std::uint8_t(k == 0 ? 1 : 3)); // 8 or 16 bits without sign
      putText("", 1);
      putText(tag_names[k], 32);
      putText("", 4 + 5 * 24);
      putText(texts[k], 32);
    }
    stream_.write(bytes_.data(), static_cast<std::streamsize>(bytes_.size()));
  }

  std::ostream& stream_;
  bool has_colours_;
  std::array<double, 3> scale_{};
  std::array<double, 3> shift_{};
  Eigen::AlignedBox3d bounds_;
  std::uint64_t points_ = 0;
  std::size_t left_out_ = 0;
  std::string bytes_;
};

/** @brief Appends the points of a file. */
void
addPoints(const ScanFile& scan,
          const TagOf& tag_of,
          unsigned threads,
          std::ostream& stream,
          LasStream& las)
{
  const StoredRow& row = scan.storedRow();
  const auto* const colour = scan.colour();
  const StoredField* const intensity = row.find("intensity");
  const bool has_intensity = intensity && (intensity->datatype == StoredField::UINT16 ||
                                           intensity->datatype == StoredField::UINT8);
  RowCoordinates coordinates(scan.fields(), scan.rowSize());
  scan.forEachStored(
      0, scan.size(), [&](const RowSource::Piece& piece, const Chunk& stored) {
        const std::vector<PointTag> tags = tagsOf(piece, coordinates, tag_of, threads);
        for (std::size_t i = 0; i < piece.size; ++i) {
          const std::uint8_t* const own = &stored.rows[i * row.size];
          Eigen::Vector3d place;
          for (int axis = 0; axis < 3; ++axis)
            place[axis] = row.find({"xyz"[axis]})->valueIn(own);
          std::array<std::uint8_t, 3> rgb{};
          if (colour) // blue is the first byte
            for (std::size_t k = 0; k < 3; ++k)
              rgb[k] = piece.rows[i * scan.rowSize() + colour->offset + 2 - k];
          las.add(
              place,
              static_cast<std::uint16_t>(has_intensity ? intensity->valueIn(own) : 0),
              rgb, tags[i]);
        }
        return stream.good(); // a full disk is reported when the file is closed
      });
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
    LasStream las(stream, *scan.files().front(), scan.hasColours());
    for (const auto& file : scan.files())
      addPoints(*file, tag_of, threads, stream, las);
    if (const std::size_t left_out = las.finish(); left_out > 0)
      warn(std::to_string(left_out) + " points without coordinates are not in '" +
           path + "'");
  });
}

} // namespace pcl::sedr::tools
