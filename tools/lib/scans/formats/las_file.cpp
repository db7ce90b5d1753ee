// SPDX-License-Identifier: BSD-3-Clause
#include "record_reader.h"
#include "scan_formats.h"
#include "tool_error.h"

#include <array>
#include <cmath>

namespace pcl::sedr::tools {

namespace {

/** @brief A point format: record size and offset of the colour. */
struct LasFormat {
  std::size_t record;
  std::size_t colour; ///< 0: none
};

constexpr std::array<LasFormat, 11> las_formats{{{20, 0},
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

/** @brief What the header tells of the points. */
struct LasHeader {
  std::size_t size = 0; ///< bytes of the header
  unsigned minor = 0;   ///< version 1.minor
  std::uint64_t begin = 0;
  std::uint64_t points = 0;
  std::size_t record = 0; ///< bytes of a point
  LasFormat format{};
};

[[noreturn]] void
refuseLas(const InputFile& file, const std::string& reason)
{
  throw ToolError("cannot read '" + file.path() + "' as LAS: " + reason);
}

std::string
number(std::uint64_t value)
{
  return std::to_string(value);
}

/** @brief Reads version and header size, and checks one against the other. */
void
readVersion(const InputFile& file, LasHeader& header)
{
  if (file.size() < min_header)
    refuseLas(file, "the file is cut off, it has " + number(file.size()) +
                        " bytes of the " + number(min_header) + " of its header");
  const auto version = file.numberAt<std::array<std::uint8_t, 2>>(version_place);
  header.minor = version[1];
  if (version[0] != 1 || header.minor > newest_minor)
    refuseLas(file, "it is of version " + number(version[0]) + "." +
                        number(header.minor) + ", known are 1.0 to 1.4");
  const std::size_t needed = header.minor == newest_minor ? header_of_1_4 : min_header;
  header.size = file.numberAt<std::uint16_t>(header_size_place);
  if (header.size < needed || header.size > file.size())
    refuseLas(file, "its header is said to have " + number(header.size) +
                        " bytes, LAS 1." + number(header.minor) + " asks for " +
                        number(needed) + " and the file has " + number(file.size()));
}

LasHeader
readLasHeader(const InputFile& file)
{
  LasHeader header;
  readVersion(file, header);
  constexpr unsigned compressed_bits = 0xc0;
  const unsigned format = file.numberAt<std::uint8_t>(format_place);
  if ((format & compressed_bits) != 0)
    throw ToolError("'" + file.path() +
                    "' is LAZ, which is not read here: 'pdal translate IN.laz "
                    "OUT.las' or 'laszip -i IN.laz -o OUT.las' makes LAS of it");
  if (format >= las_formats.size())
    refuseLas(file, "its points are of the format " + number(format) +
                        ", known are 0 to " + number(las_formats.size() - 1));
  header.format = las_formats[format];
  header.begin = file.numberAt<std::uint32_t>(begin_place);
  header.record = file.numberAt<std::uint16_t>(record_place);
  header.points = file.numberAt<std::uint32_t>(points_place);
  if (header.minor == newest_minor)
    if (const auto many = file.numberAt<std::uint64_t>(points_place_of_1_4))
      header.points = many;
  if (header.record < header.format.record)
    refuseLas(file, "its points are said to have " + number(header.record) +
                        " bytes, format " + number(format) + " takes " +
                        number(header.format.record));
  if (header.begin < header.size || header.begin > file.size())
    refuseLas(file, "its points are said to begin at byte " + number(header.begin) +
                        ", the header has " + number(header.size) +
                        " bytes and the file " + number(file.size()));
  return header;
}

/** @brief Walks the variable-length records between header and points. Their own
 * lengths reveal a wrong number of records. */
void
checkRecords(const InputFile& file, const LasHeader& header)
{
  constexpr std::size_t record_header = 54;
  constexpr std::size_t length_place = 20;
  const std::uint64_t records = file.numberAt<std::uint32_t>(records_place);
  std::uint64_t at = header.size;
  for (std::uint64_t k = 0; k < records; ++k) {
    const std::uint64_t start = at;
    at += record_header;
    if (at <= header.begin)
      at += file.numberAt<std::uint16_t>(start + length_place);
    if (at > header.begin)
      refuseLas(file, "it is said to have " + number(records) +
                          " records before its points, but number " + number(k + 1) +
                          ", from byte " + number(start) +
                          " on, does not end before byte " + number(header.begin) +
                          ", where the points begin");
  }
}

/** @brief Refuses a header that counts more points than there are, or fewer, before
 * waveforms (LAS 1.3) or further records (LAS 1.4). */
void
checkLasCount(const InputFile& file, const LasHeader& header)
{
  std::uint64_t end = file.size();
  const auto endAt = [&](std::uint64_t start) {
    if (start > header.begin)
      end = std::min(end, start);
  };
  if (header.minor >= 3 && header.size >= waveforms_place + sizeof(std::uint64_t))
    endAt(file.numberAt<std::uint64_t>(waveforms_place));
  if (header.minor >= 4 && file.numberAt<std::uint32_t>(records_after_place) > 0)
    endAt(file.numberAt<std::uint64_t>(after_place));
  const std::uint64_t bytes = end - header.begin;
  const std::string promise = "its header promises " + number(header.points) +
                              " points of " + number(header.record) + " bytes, but " +
                              number(bytes) + " bytes are there for them";
  if (header.points > bytes / header.record)
    refuseLas(file, "the file is cut off, " + promise);
  if (header.points > 0 &&
      areMorePoints(bytes - header.points * header.record, header.record, file.path()))
    refuseLas(file, promise);
}

/** @brief Returns whether any of 10,000 points has a colour above 255. Some programs
 * write bytes where 16 bits are meant. */
bool
usesWideColours(const InputFile& file, const LasHeader& header)
{
  // Multiples of the golden ratio: in no step with what repeats in a file.
  constexpr std::uint64_t max_looked_at = 10000;
  constexpr double golden = 0.6180339887498949;
  for (std::uint64_t k = 0; k < std::min(header.points, max_looked_at); ++k) {
    const double share = std::fmod(static_cast<double>(k) * golden, 1.0);
    const auto row =
        static_cast<std::uint64_t>(share * static_cast<double>(header.points));
    const auto colour = file.numberAt<std::array<std::uint16_t, 3>>(
        header.begin + std::min(row, header.points - 1) * header.record +
        header.format.colour);
    if (*std::max_element(colour.begin(), colour.end()) > 0xff)
      return true;
  }
  return false;
}

StoredRow
lasRow(const InputFile& file, const LasHeader& header)
{
  StoredRow row;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string name(1, "xyz"[axis]);
    StoredField& field = row.add(name, pcl::PCLPointField::INT32);
    field.scale = file.numberAt<double>(scale_place + axis * sizeof(double));
    field.shift = file.numberAt<double>(shift_place + axis * sizeof(double));
    if (!(field.scale > 0) || !std::isfinite(field.scale) ||
        !std::isfinite(field.shift))
      refuseLas(file, "the scale of " + name + " is " + std::to_string(field.scale) +
                          " and its offset " + std::to_string(field.shift) +
                          ", a scale above 0 and a finite offset are needed");
  }
  row.add("intensity", pcl::PCLPointField::UINT16).becomes_float = true;
  if (header.format.colour > 0) {
    row.joins_colours = true;
    row.size = header.format.colour + (usesWideColours(file, header) ? 1 : 0);
    for (const char* name : {"red", "green", "blue"}) {
      row.add(name, pcl::PCLPointField::UINT8);
      ++row.size;
    }
  }
  row.size = header.record;
  return row;
}

} // namespace

bool
looksLikeLas(const InputFile& file)
{
  return file.beginsWith("LASF");
}

ScanContent
openLas(const InputFilePtr& file)
{
  const LasHeader header = readLasHeader(*file);
  checkRecords(*file, header);
  checkLasCount(*file, header);
  ScanContent content;
  content.points = std::make_unique<RecordReader>(file, header.begin, header.points,
                                                  lasRow(*file, header));
  return content;
}

} // namespace pcl::sedr::tools
