// SPDX-License-Identifier: BSD-3-Clause
#include "las_output.h"
#include "scan_formats.h"
#include "tool_error.h"

#include <array>
#include <cmath>

namespace pcl::sedr::tools {

namespace {

std::string
number(std::uint64_t value)
{
  return std::to_string(value);
}

/** @brief Reads the header of a LAS file. */
class LasHeader {
public:
  explicit LasHeader(const InputFile& file)
      : file_(file)
  {
    records.format = "LAS";
    readVersion();
    readPlace();
    readRow();
  }

  Records records;

private:
  [[noreturn]] void refuse(const std::string& reason) const
  {
    throw ToolError("cannot read '" + file_.path() + "' as LAS: " + reason);
  }

  /** @brief Reads version and header size, and checks one against the other. */
  void readVersion()
  {
    constexpr std::size_t min_header = 227; // of LAS 1.0 to 1.2
    if (file_.size() < min_header)
      refuse("the file is cut off, it has " + number(file_.size()) + " bytes of the " +
             number(min_header) + " of its header");
    const auto version = file_.numberAt<std::array<std::uint8_t, 2>>(las::version);
    minor_ = version[1];
    if (version[0] != 1 || minor_ > las::newest_minor)
      refuse("it is of version " + number(version[0]) + "." + number(minor_) +
             ", known are 1.0 to 1.4");
    const std::size_t needed =
        minor_ == las::newest_minor ? las::header_of_1_4 : min_header;
    size_ = file_.numberAt<std::uint16_t>(las::header_size);
    if (size_ < needed || size_ > file_.size())
      refuse("its header is said to have " + number(size_) + " bytes, LAS 1." +
             number(minor_) + " asks for " + number(needed) + " and the file has " +
             number(file_.size()));
  }

  /** @brief Reads where the points stand: before waveforms (LAS 1.3) or further records
   * (LAS 1.4), if there are any. */
  void readPlace()
  {
    constexpr unsigned compressed_bits = 0xc0;
    const unsigned format = file_.numberAt<std::uint8_t>(las::format);
    if ((format & compressed_bits) != 0)
      throw ToolError("'" + file_.path() +
                      "' is LAZ, which is not read here: 'pdal translate IN.laz "
                      "OUT.las' or 'laszip -i IN.laz -o OUT.las' makes LAS of it");
    if (format >= las::sizes.size())
      refuse("its points are of the format " + number(format) + ", known are 0 to " +
             number(las::sizes.size() - 1));
    format_ = format;
    record_ = file_.numberAt<std::uint16_t>(las::record);
    if (record_ < las::sizes[format_])
      refuse("its points are said to have " + number(record_) + " bytes, format " +
             number(format) + " takes " + number(las::sizes[format_]));
    records.points = file_.numberAt<std::uint32_t>(las::points);
    if (minor_ == las::newest_minor)
      if (const auto many = file_.numberAt<std::uint64_t>(las::many_points))
        records.points = many;
    records.begin = file_.numberAt<std::uint32_t>(las::begin);
    if (records.begin < size_ || records.begin > file_.size())
      refuse("its points are said to begin at byte " + number(records.begin) +
             ", the header has " + number(size_) + " bytes and the file " +
             number(file_.size()));
    records.end = file_.size();
    const auto endAt = [&](std::size_t place) {
      if (const auto start = file_.numberAt<std::uint64_t>(place);
          start > records.begin)
        records.end = std::min(records.end, start);
    };
    if (minor_ >= 3 && size_ >= las::waveforms + sizeof(std::uint64_t))
      endAt(las::waveforms);
    if (minor_ >= 4 && file_.numberAt<std::uint32_t>(las::records_after) > 0)
      endAt(las::after);
  }

  /** @brief Returns whether any of 10,000 points has a colour above 255. Some programs
   * write bytes where 16 bits are meant. */
  bool usesWideColours() const
  {
    // Multiples of the golden ratio: in no step with what repeats in a file.
    constexpr std::uint64_t max_looked_at = 10000;
    constexpr double golden = 0.6180339887498949;
    const std::uint64_t points =
        std::min(records.points, (records.end - records.begin) / record_);
    for (std::uint64_t k = 0; k < std::min(points, max_looked_at); ++k) {
      const double share = std::fmod(static_cast<double>(k) * golden, 1.0);
      const auto row = static_cast<std::uint64_t>(share * static_cast<double>(points));
      const auto colour = file_.numberAt<std::array<std::uint16_t, 3>>(
          records.begin + std::min(row, points - 1) * record_ + las::colours[format_]);
      if (*std::max_element(colour.begin(), colour.end()) > 0xff)
        return true;
    }
    return false;
  }

  void readRow()
  {
    StoredRow& row = records.row;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::string name(1, "xyz"[axis]);
      StoredField& field = row.add(name, pcl::PCLPointField::INT32);
      field.scale = file_.numberAt<double>(las::scale + axis * sizeof(double));
      field.shift = file_.numberAt<double>(las::shift + axis * sizeof(double));
      if (!(field.scale > 0) || !std::isfinite(field.scale) ||
          !std::isfinite(field.shift))
        refuse("the scale of " + name + " is " + std::to_string(field.scale) +
               " and its offset " + std::to_string(field.shift) +
               ", a scale above 0 and a finite offset are needed");
    }
    row.add("intensity", pcl::PCLPointField::UINT16).becomes_float = true;
    if (las::colours[format_] > 0) {
      row.joins_colours = true;
      row.size = las::colours[format_] + (usesWideColours() ? 1 : 0);
      for (const char* name : {"red", "green", "blue"}) {
        row.add(name, pcl::PCLPointField::UINT8);
        ++row.size;
      }
    }
    row.size = record_;
  }

  const InputFile& file_;
  unsigned minor_ = 0;     ///< version 1.minor
  std::size_t size_ = 0;   ///< bytes of the header
  std::size_t record_ = 0; ///< bytes of a point
  unsigned format_ = 0;
};

} // namespace

bool
looksLikeLas(const InputFile& file)
{
  return file.beginsWith("LASF");
}

ScanContent
openLas(const InputFilePtr& file)
{
  ScanContent content;
  content.points = std::make_unique<RecordReader>(file, LasHeader(*file).records);
  return content;
}

} // namespace pcl::sedr::tools
