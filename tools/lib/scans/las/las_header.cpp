// SPDX-License-Identifier: BSD-3-Clause
#include "las_header.h"

#include "cloud_readers.h"
#include "tool_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace pcl::sedr::tools {

namespace {

/** @brief A point format: record size and offset of the colour. */
struct PointFormat {
  std::size_t record;
  std::size_t colour_offset; ///< 0: none
};

constexpr std::array<PointFormat, 11> formats{{{20, 0},
                                               {28, 0},
                                               {26, 20},
                                               {34, 28},
                                               {57, 0},
                                               {63, 28},
                                               {30, 0},
                                               {36, 30},
                                               {38, 30},
                                               {59, 0},
                                               {67, 30}}};

constexpr std::size_t min_header = 227; // of LAS 1.0 to 1.2
constexpr std::size_t header_of_1_4 = 375;
constexpr unsigned newest_minor = 4;

// Offsets of numbers in the header.
constexpr std::size_t version_place = 24;
constexpr std::size_t header_size_place = 94;
constexpr std::size_t begin_place = 96;
constexpr std::size_t records_place = 100;
constexpr std::size_t format_place = 104;
constexpr std::size_t record_place = 105;
constexpr std::size_t points_place = 107;
constexpr std::size_t scale_place = 131;
constexpr std::size_t shift_place = 155;
constexpr std::size_t waveforms_place = 227;     // LAS 1.3
constexpr std::size_t after_place = 235;         // LAS 1.4: records after the points
constexpr std::size_t records_after_place = 243; // how many these are
constexpr std::size_t points_place_of_1_4 = 247;

template <typename T>
T
valueAt(const MappedFile& file, std::size_t position)
{
  T value{};
  std::memcpy(&value, file.data() + position, sizeof value);
  return value;
}

[[noreturn]] void
refuse(const std::string& path, const std::string& reason)
{
  throw ToolError("cannot read '" + path + "' as LAS: " + reason);
}

std::string
text(std::uint64_t number)
{
  return std::to_string(number);
}

/** @brief Returns the header size, after checking it against the version. */
std::size_t
checkedHeaderSize(const MappedFile& file, const std::string& path)
{
  if (file.size() < min_header)
    refuse(path, "the file is cut off, it has " + text(file.size()) + " bytes of the " +
                     text(min_header) + " of its header");
  const unsigned major = file.data()[version_place];
  const unsigned minor = file.data()[version_place + 1];
  if (major != 1 || minor > newest_minor)
    refuse(path, "it is of version " + text(major) + "." + text(minor) +
                     ", known are 1.0 to 1.4");
  const std::size_t needed = minor == newest_minor ? header_of_1_4 : min_header;
  const std::size_t size = valueAt<std::uint16_t>(file, header_size_place);
  if (size < needed || size > file.size())
    refuse(path, "its header is said to have " + text(size) + " bytes, LAS 1." +
                     text(minor) + " asks for " + text(needed) + " and the file has " +
                     text(file.size()));
  return size;
}

void
readScales(const MappedFile& file, const std::string& path, LasHeader& header)
{
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const auto place = static_cast<std::size_t>(axis) * sizeof(double);
    header.scale[axis] = valueAt<double>(file, scale_place + place);
    header.shift[axis] = valueAt<double>(file, shift_place + place);
    if (!(header.scale[axis] > 0) || !std::isfinite(header.scale[axis]) ||
        !std::isfinite(header.shift[axis]))
      refuse(path, std::string("the scale of ") + "xyz"[axis] + " is " +
                       std::to_string(header.scale[axis]) + " and its offset " +
                       std::to_string(header.shift[axis]) +
                       ", a scale above 0 and a finite offset are needed");
  }
}

std::uint64_t
pointsOf(const MappedFile& file, std::size_t header_size)
{
  const bool has_both =
      file.data()[version_place + 1] == newest_minor && header_size >= header_of_1_4;
  const auto many =
      has_both ? valueAt<std::uint64_t>(file, points_place_of_1_4) : std::uint64_t{0};
  return many > 0 ? many : valueAt<std::uint32_t>(file, points_place);
}

/** @brief Returns the number of bytes between the begin of the points and what may
 * follow them: waveforms (LAS 1.3) or further records (LAS 1.4). */
std::uint64_t
pointBytes(const MappedFile& file, std::size_t header_size, std::uint64_t begin)
{
  const unsigned minor = file.data()[version_place + 1];
  std::uint64_t end = file.size();
  const auto endAt = [&](std::uint64_t start) {
    if (start > begin)
      end = std::min(end, start);
  };
  if (minor >= 3 && header_size >= waveforms_place + sizeof(std::uint64_t))
    endAt(valueAt<std::uint64_t>(file, waveforms_place));
  if (minor >= 4 && header_size >= header_of_1_4 &&
      valueAt<std::uint32_t>(file, records_after_place) > 0)
    endAt(valueAt<std::uint64_t>(file, after_place));
  return end - begin;
}

/** @brief Refuses a header that counts more points than there are, or fewer. */
void
checkCount(const LasHeader& header, std::uint64_t bytes, const std::string& path)
{
  const std::string promise = "its header promises " + text(header.points) +
                              " points of " + text(header.record) + " bytes, but " +
                              text(bytes) + " bytes ";
  if (header.points > bytes / header.record)
    refuse(path, "the file is cut off, " + promise + "follow");
  if (header.points > 0 &&
      areMorePoints(bytes - header.points * header.record, header.record, path))
    refuse(path, promise + "are there for them");
}

/** @brief Walks the variable-length records between header and points. Their own
 * lengths reveal a wrong number of records. */
void
checkRecords(const MappedFile& file,
             const std::string& path,
             std::size_t header_size,
             std::uint64_t begin)
{
  constexpr std::size_t record_header = 54;
  constexpr std::size_t length_place = 20;
  const std::uint64_t records = valueAt<std::uint32_t>(file, records_place);
  std::uint64_t at = header_size;
  for (std::uint64_t k = 0; k < records; ++k) {
    const std::uint64_t start = at;
    at += record_header;
    if (at <= begin)
      at += valueAt<std::uint16_t>(file, start + length_place);
    if (at > begin)
      refuse(path, "it is said to have " + text(records) +
                       " records before its points, but number " + text(k + 1) +
                       ", from byte " + text(start) + " on, does not end before byte " +
                       text(begin) + ", where the points begin");
  }
}

} // namespace

bool
looksLikeLas(const MappedFile& file)
{
  return file.size() >= 4 && std::memcmp(file.data(), "LASF", 4) == 0;
}

LasHeader
readLasHeader(const MappedFile& file, const std::string& path)
{
  const std::size_t header_size = checkedHeaderSize(file, path);
  constexpr unsigned compressed_bits = 0xc0;
  const unsigned stored_format = file.data()[format_place];
  const unsigned format = stored_format & ~compressed_bits;
  LasHeader header;
  header.begin = valueAt<std::uint32_t>(file, begin_place);
  header.record = valueAt<std::uint16_t>(file, record_place);
  header.points = pointsOf(file, header_size);
  header.is_compressed = format != stored_format;
  if (format >= formats.size())
    refuse(path, "its points are of the format " + text(format) + ", known are 0 to " +
                     text(formats.size() - 1));
  header.colour_offset = formats[format].colour_offset;
  if (header.record < formats[format].record)
    refuse(path, "its points are said to have " + text(header.record) +
                     " bytes, format " + text(format) + " takes " +
                     text(formats[format].record));
  if (header.begin < header_size || header.begin > file.size())
    refuse(path, "its points are said to begin at byte " + text(header.begin) +
                     ", the header has " + text(header_size) + " bytes and the file " +
                     text(file.size()));
  checkRecords(file, path, header_size, header.begin);
  readScales(file, path, header);
  if (!header.is_compressed)
    checkCount(header, pointBytes(file, header_size, header.begin), path);
  return header;
}

} // namespace pcl::sedr::tools
