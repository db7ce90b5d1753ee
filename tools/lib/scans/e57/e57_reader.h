// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bytes/input_file.h"
#include "formats/scan_formats.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace pcl::sedr::tools {

/** @brief The bytes of an E57 file (ASTM E2807) without the checksums at the end of its
 * pages, which are verified on reading. Offsets exclude checksums (logical) unless
 * called physical. Throws ToolError with a reason, without the file name. */
class E57Pages {
public:
  /** @brief Reads the header of 48 bytes. */
  explicit E57Pages(std::shared_ptr<const InputFile> file);

  /** @brief Returns the number of bytes without checksums. */
  std::uint64_t size() const { return pages_ * payload_; }

  std::uint64_t xmlBegin() const { return xml_begin_; }
  std::uint64_t xmlSize() const { return xml_size_; }

  /** @brief Converts a physical offset to a logical one; `what` names its content in
   * errors. */
  std::uint64_t logical(std::uint64_t physical, const std::string& what) const;

  /** @brief Converts a logical offset to a physical one. */
  std::uint64_t physical(std::uint64_t logical) const
  {
    return logical / payload_ * page_size_ + logical % payload_;
  }

  /** @brief Copies bytes and verifies the checksums of their pages; thread-safe. */
  void read(std::uint64_t begin, std::size_t size, void* to) const;

private:
  /** @brief Verifies the checksums of `count` pages from `first` on. */
  void check(std::uint64_t first, std::size_t count, const std::uint8_t* bytes) const;

  std::shared_ptr<const InputFile> file_;
  std::uint64_t page_size_ = 0;
  std::uint64_t payload_ = 0; ///< bytes per page without its checksum
  std::uint64_t pages_ = 0;
  std::uint64_t xml_begin_ = 0;
  std::uint64_t xml_size_ = 0;
};

/** @brief A value of every point and its encoding; each field has its own stream. */
struct E57Field {
  enum class Kind { Float, Double, Integer, Other };

  std::string name;         ///< in the XML, such as cartesianX
  Kind kind = Kind::Other;  ///< Other is not read
  unsigned bits = 0;        ///< per value; 0 if all are `minimum`
  std::int64_t minimum = 0; ///< value of the stored number 0
  double scale = 1;         ///< for integers
  double offset = 0;        ///< for integers
  double low = 0, high = 0; ///< range of values, scaled; 0, 0 if unknown
};

/** @brief Description of a scan in the XML. */
struct E57Scan {
  std::size_t number = 0; ///< from 1
  std::string name;       ///< may be empty
  std::uint64_t points = 0;
  std::uint64_t section = 0; ///< logical offset of its points
  bool has_pose = false;
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero(); ///< file's unit, metres
  std::vector<E57Field> fields; ///< in the order of their streams
  /// Minimum and maximum of red, green and blue; 0, 0 if unknown.
  std::vector<std::pair<double, double>> colour_limits;

  /** @brief Returns the field called `name`, null if there is none. */
  const E57Field* find(const std::string& name) const;

  /** @brief Returns "scan 2 ('kitchen')". */
  std::string title() const;
};

/** @brief A scan, or the reason why it cannot be read. */
struct E57Entry {
  E57Scan scan;
  std::string problem; ///< a sentence; empty if there is none
};

/** @brief Reads the scans listed in the XML of an E57 file. Throws ToolError if the XML
 * cannot be read; problems of a single scan are stored with it. */
std::vector<E57Entry> readE57Scans(const E57Pages& pages);

/** @brief The values of a field for a range of points. */
struct E57Values {
  const E57Field* field = nullptr; ///< null: the scan does not have it
  std::vector<std::uint8_t> bytes; ///< padded, so that nine can be read at the last
  unsigned first_bit = 0;          ///< of the first value in the first byte

  /** @brief Reads the values [first, first + size), relative to the first one in the
   * range, scaled. */
  void read(std::size_t first, std::size_t size, double* values) const;
};

/** @brief Locates the values of a scan. They are stored in packets of at most 64 KiB
 * with a piece of the stream of every field; values may straddle two packets.
 *
 * All packet headers are read at first, so that any points can be read without those
 * before them. Throws ToolError with a reason on failure. */
class E57Streams {
public:
  /** @param fields those of the scan to read; null for none */
  E57Streams(const E57Pages& pages,
             const E57Scan& scan,
             const std::vector<const E57Field*>& fields);

  /** @brief Returns the values of the points [begin, end) for each field, in their
   * order; thread-safe. */
  std::vector<E57Values> read(std::uint64_t begin, std::uint64_t end) const;

  /** @brief Verifies the checksums of all pages of the scan. */
  void check() const;

private:
  /** @brief A part of a stream in one packet. */
  struct Piece {
    std::uint64_t place = 0; ///< logical
    std::uint64_t first = 0; ///< bytes of the stream before it
  };

  void findPieces();
  void addPieces(std::uint64_t packet, std::size_t size, std::size_t streams);

  /** @brief Throws ToolError unless the streams have the bytes for all points, and not
   * for more. */
  void checkCount() const;

  const E57Pages& pages_;
  const E57Scan& scan_;
  std::vector<const E57Field*> fields_; ///< null for none
  std::uint64_t begin_ = 0;             ///< of the packets, logical
  std::uint64_t end_ = 0;
  std::vector<std::vector<Piece>> pieces_; ///< by field; the last one at the end
};

/** @brief The points of a scan of an E57 file, moved by its pose. Throws ToolError with
 * a reason if they cannot be read. */
struct E57Points {
  /** @brief What is read: x, y and z, or range, azimuth and elevation; the others if
   * the scan has them. */
  enum Role : std::size_t { X, Y, Z, Invalid, Intensity, Blue, Green, Red };

  /** @param first_row number of its first point in the whole file */
  E57Points(const E57Pages& pages, const E57Scan& scan, std::size_t first_row);

  bool has(Role role) const { return fields[role] != nullptr; }

  /** @brief Decodes `size` points from `first` on into rows of a layout: x, y and z,
   * doubles, then others; what the scan does not have stays as it is. */
  void read(std::size_t first,
            std::size_t size,
            const StoredRow& row,
            std::uint8_t* rows) const;

  E57Scan scan;
  std::size_t begin;                   ///< number of its first point in the whole file
  std::size_t end;                     ///< number behind its last one
  std::vector<const E57Field*> fields; ///< of each role, null: none
  E57Streams streams;
};

/** @brief The points of the scans of an E57 file (ASTM E2807-11), in sequence, see
 * openE57(). Coordinates are Cartesian, or else spherical: floats of single or double
 * precision, integers or scaled integers of 0 to 64 bits. Throws ToolError that names
 * the scan. */
class E57Reader : public PointReader {
public:
  E57Reader(const InputFilePtr& file, const ScanSettings& settings);

  std::vector<ScanStation> stations() const override;

protected:
  void read(Chunk& chunk) const override;

private:
  void open(const E57Entry& entry, bool skip_broken);

  std::string path_;
  std::unique_ptr<const E57Pages> pages_;
  std::vector<std::unique_ptr<const E57Points>> scans_; ///< scans with points
};

/** @brief Lists the scans of an E57 file, including those that cannot be read. */
std::vector<E57Entry> listE57Scans(const std::string& path);

} // namespace pcl::sedr::tools
