// SPDX-License-Identifier: BSD-3-Clause
#include "e57_reader.h"
#include "formats/scan_formats.h"
#include "sedr_filters/src/base/parallel.h"
#include "tool_error.h"

#include <boost/crc.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>

namespace pcl::sedr::tools {

namespace {

constexpr std::uint64_t section_head = 32; // bytes
constexpr std::uint64_t packet_head = 6;   // bytes before the lengths of the pieces
constexpr std::uint64_t min_packet = 4;    // bytes of an empty one
constexpr std::size_t spare = 8;           // bytes after the end of a stream

enum PacketType : std::uint8_t { IndexPacket = 0, DataPacket = 1, EmptyPacket = 2 };

template <typename T>
T
valueAt(const std::uint8_t* bytes)
{
  T value{};
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

std::string
text(std::uint64_t number)
{
  return std::to_string(number);
}

/** @brief Returns the number stored in `bits` bits from bit `at` on. */
std::uint64_t
bitsAt(const std::uint8_t* bytes, std::uint64_t at, unsigned bits)
{
  const auto* first = bytes + at / 8;
  const auto skipped = static_cast<unsigned>(at % 8);
  std::uint64_t word = valueAt<std::uint64_t>(first) >> skipped;
  if (skipped + bits > 64) // the remainder is in a ninth byte
    word |= std::uint64_t{first[8]} << (64 - skipped);
  return bits < 64 ? word & ((std::uint64_t{1} << bits) - 1) : word;
}

double
scaled(const E57Field& field, std::uint64_t stored)
{
  // Unsigned, as the sum may exceed a signed integer.
  const auto raw =
      static_cast<std::int64_t>(static_cast<std::uint64_t>(field.minimum) + stored);
  return static_cast<double>(raw) * field.scale + field.offset;
}

constexpr std::uint64_t header_size = 48;
constexpr std::uint64_t checksum_size = 4;
constexpr std::uint64_t read_at_once = std::uint64_t{1} << 16; // bytes, a thread

/** @brief CRC-32C (Castagnoli) of RFC 3720. */
using Crc32c = boost::crc_optimal<32, 0x1edc6f41, 0xffffffff, 0xffffffff, true, true>;

} // namespace

void
E57Values::read(std::size_t first, std::size_t size, double* values) const
{
  const auto* const from = bytes.data();
  const std::uint64_t begin = first_bit + std::uint64_t{first} * field->bits;
  if (field->bits == 0)
    std::fill_n(values, size, scaled(*field, 0));
  else if (field->kind == E57Field::Kind::Float)
    for (std::size_t i = 0; i < size; ++i)
      values[i] = valueAt<float>(from + (first + i) * sizeof(float));
  else if (field->kind == E57Field::Kind::Double)
    std::memcpy(values, from + first * sizeof(double), size * sizeof(double));
  else
    for (std::size_t i = 0; i < size; ++i)
      values[i] = scaled(*field, bitsAt(from, begin + i * field->bits, field->bits));
}

E57Streams::E57Streams(const E57Pages& pages,
                       const E57Scan& scan,
                       const std::vector<const E57Field*>& fields)
    : pages_(pages)
    , scan_(scan)
    , fields_(fields)
    , pieces_(fields.size())
{
  std::uint8_t head[section_head];
  pages.read(scan.section, section_head, head);
  const auto size = valueAt<std::uint64_t>(head + 8);
  if (head[0] != 1)
    throw ToolError("the list of its points begins with the number " + text(head[0]) +
                    " in place of 1");
  if (size < section_head || size > pages.size() - scan.section)
    throw ToolError("the list of its points is said to have " + text(size) +
                    " bytes, " + text(pages.size() - scan.section) + " are left");
  begin_ = pages.logical(valueAt<std::uint64_t>(head + 16), "the first packet");
  end_ = scan.section + size;
  if (begin_ < scan.section || begin_ > end_)
    throw ToolError("its first packet is said to begin at byte " +
                    text(pages.physical(begin_)) + ", outside of its list of points");
  findPieces();
  checkCount();
}

void
E57Streams::findPieces()
{
  for (auto& pieces : pieces_)
    pieces.push_back({});
  std::size_t size = 0;
  for (std::uint64_t at = begin_; end_ - at >= packet_head; at += size) {
    std::uint8_t head[packet_head];
    pages_.read(at, packet_head, head);
    size = std::size_t{valueAt<std::uint16_t>(head + 2)} + 1;
    const std::string packet = "the packet at byte " + text(pages_.physical(at));
    if (head[0] > EmptyPacket)
      throw ToolError(packet + " is of the type " + text(head[0]) +
                      ", which is unknown");
    if (size < (head[0] == DataPacket ? packet_head : min_packet) || size > end_ - at)
      throw ToolError(packet + " is said to have " + text(size) + " bytes, " +
                      text(end_ - at) + " are left");
    if (head[0] == DataPacket)
      addPieces(at, size, valueAt<std::uint16_t>(head + 4));
  }
}

void
E57Streams::addPieces(std::uint64_t packet, std::size_t size, std::size_t streams)
{
  std::vector<std::uint16_t> lengths(scan_.fields.size());
  std::size_t begin = packet_head + 2 * lengths.size();
  const bool is_complete = streams == lengths.size() && begin <= size;
  if (is_complete)
    pages_.read(packet + packet_head, 2 * streams, lengths.data());
  for (std::size_t s = 0; s < streams && is_complete; begin += lengths[s++])
    for (std::size_t f = 0; f < fields_.size(); ++f)
      if (fields_[f] == &scan_.fields[s]) {
        pieces_[f].back().place = packet + begin;
        pieces_[f].push_back({0, pieces_[f].back().first + lengths[s]});
      }
  if (!is_complete || begin > size)
    throw ToolError("the packet at byte " + text(pages_.physical(packet)) + " of " +
                    text(size) + " bytes has " + text(streams) + " streams for " +
                    text(lengths.size()) + " fields, which take " + text(begin));
}

void
E57Streams::checkCount() const
{
  bool has_bits = false;
  for (std::size_t f = 0; f < fields_.size(); ++f) {
    if (!fields_[f] || fields_[f]->bits == 0)
      continue;
    const E57Field& own = *fields_[f];
    has_bits = true;
    // Writers fill up the last integers to a machine word.
    const std::uint64_t padding =
        own.kind == E57Field::Kind::Integer ? sizeof(std::uint64_t) : own.bits / 8;
    const std::uint64_t needed = (scan_.points * own.bits + 7) / 8;
    const std::uint64_t there = pieces_[f].back().first;
    if (there < needed || there >= needed + padding)
      throw ToolError("it is said to have " + text(scan_.points) +
                      " points, its packets hold " + quotedWord(own.name) + " of " +
                      text(8 * there / own.bits));
  }
  // Constants take no bytes; points of nothing else are bounded by a bit each.
  const std::uint64_t most = 8 * pages_.size();
  if (!has_bits && scan_.points > most)
    throw ToolError("all of its " + text(scan_.points) +
                    " points are one and the same, the whole file has " + text(most) +
                    " bits");
}

std::vector<E57Values>
E57Streams::read(std::uint64_t begin, std::uint64_t end) const
{
  struct Part {
    std::uint64_t place;
    std::size_t size;
    std::uint8_t* to;
  };
  std::vector<Part> parts;
  std::vector<E57Values> values(fields_.size());
  for (std::size_t f = 0; f < values.size(); ++f) {
    const std::uint64_t bits = fields_[f] ? fields_[f]->bits : 0;
    const std::uint64_t first = begin * bits / 8;
    const std::uint64_t last = (end * bits + 7) / 8;
    values[f].field = fields_[f];
    values[f].first_bit = static_cast<unsigned>(begin * bits % 8);
    values[f].bytes.resize(static_cast<std::size_t>(last - first) + spare);
    auto piece = std::upper_bound(
        pieces_[f].begin(), pieces_[f].end() - 1, first,
        [](std::uint64_t at, const Piece& one) { return at < one.first; });
    std::uint64_t at = first;
    for (piece -= at < last ? 1 : 0; at < last; ++piece) {
      const std::uint64_t part_end = std::min(last, piece[1].first);
      parts.push_back({piece->place + (at - piece->first),
                       static_cast<std::size_t>(part_end - at),
                       values[f].bytes.data() + (at - first)});
      at = part_end;
    }
  }
  parallelFor(parts.size(), 1, 0, [&](std::size_t p) {
    pages_.read(parts[p].place, parts[p].size, parts[p].to);
  });
  return values;
}

void
E57Streams::check() const
{
  constexpr std::uint64_t step = std::uint64_t{1} << 23; // bytes
  std::vector<std::uint8_t> bytes(step);
  for (std::uint64_t at = begin_; at < end_; at += step)
    pages_.read(at, static_cast<std::size_t>(std::min(step, end_ - at)), bytes.data());
}

bool
looksLikeE57(const InputFile& file)
{
  return file.beginsWith("ASTM-E57");
}

E57Pages::E57Pages(std::shared_ptr<const InputFile> file)
    : file_(std::move(file))
{
  const auto number = [](std::uint64_t value) { return std::to_string(value); };
  if (file_->size() < header_size)
    throw ToolError("the file is cut off, it has " + number(file_->size()) +
                    " bytes of the " + number(header_size) + " of its header");
  const auto version = file_->numberAt<std::uint32_t>(8);
  const auto length = file_->numberAt<std::uint64_t>(16);
  const auto xml_physical = file_->numberAt<std::uint64_t>(24);
  xml_size_ = file_->numberAt<std::uint64_t>(32);
  page_size_ = file_->numberAt<std::uint64_t>(40);
  constexpr std::uint64_t min_page = 64;
  constexpr std::uint64_t largest_page = std::uint64_t{1} << 24;
  if (version != 1)
    throw ToolError("it is of version " + number(version) + ", known is version 1");
  if (page_size_ < min_page || page_size_ > largest_page)
    throw ToolError("its pages are said to have " + number(page_size_) + " bytes");
  if (length > file_->size())
    throw ToolError("the file is cut off, its header promises " + number(length) +
                    " bytes, " + number(file_->size()) + " are there");
  if (length == 0 || length % page_size_ != 0)
    throw ToolError("its " + number(length) +
                    " bytes are no whole number of pages of " + number(page_size_));
  payload_ = page_size_ - checksum_size;
  pages_ = length / page_size_;
  std::uint8_t first = 0;
  read(0, 1, &first); // compares the checksum of the page
  xml_begin_ = logical(xml_physical, "its XML");
  if (xml_size_ > size() - xml_begin_)
    throw ToolError("its XML is said to have " + number(xml_size_) +
                    " bytes from byte " + number(xml_physical) + " on, " +
                    number(size() - xml_begin_) + " follow");
}

std::uint64_t
E57Pages::logical(std::uint64_t physical, const std::string& what) const
{
  if (physical < header_size || physical >= pages_ * page_size_ ||
      physical % page_size_ >= payload_)
    throw ToolError(what + " is said to begin at byte " + std::to_string(physical) +
                    ", which is not within the bytes of the " + std::to_string(pages_) +
                    " pages of " + std::to_string(page_size_) + " bytes");
  return physical / page_size_ * payload_ + physical % page_size_;
}

void
E57Pages::check(std::uint64_t first, std::size_t count, const std::uint8_t* bytes) const
{
  // Side by side, as every step of a checksum waits for the one before.
  constexpr std::size_t lanes = 8;
  constexpr std::size_t step = 16; // bytes
  for (std::size_t done = 0; done < count; done += lanes) {
    const std::size_t pages = std::min(lanes, count - done);
    const std::uint8_t* const begin = bytes + done * page_size_;
    std::array<Crc32c, lanes> crcs;
    for (std::size_t at = 0; at < payload_; at += step)
      for (std::size_t p = 0; p < pages; ++p)
        crcs[p].process_bytes(begin + p * page_size_ + at,
                              std::min<std::size_t>(step, payload_ - at));
    for (std::size_t p = 0; p < pages; ++p) {
      std::uint32_t stored = 0; // the only big-endian number of the format
      for (std::uint64_t k = 0; k < checksum_size; ++k)
        stored = stored << 8 | begin[p * page_size_ + payload_ + k];
      if (stored == crcs[p].checksum())
        continue;
      char text[80];
      std::snprintf(text, sizeof text, "its checksum is %08x, that of its bytes %08x",
                    stored, static_cast<unsigned>(crcs[p].checksum()));
      throw ToolError("page " + std::to_string(first + done + p + 1) + " of " +
                      std::to_string(pages_) + " is damaged, " + text);
    }
  }
}

void
E57Pages::read(std::uint64_t begin, std::size_t size, void* to) const
{
  if (begin > this->size() || size > this->size() - begin)
    throw ToolError(std::to_string(size) + " bytes are wanted from byte " +
                    std::to_string(physical(begin)) + " on, which is beyond its end");
  if (size == 0)
    return;
  const std::size_t pages_at_once =
      std::max<std::uint64_t>(1, read_at_once / page_size_);
  const std::uint64_t end = begin + size;
  const std::uint64_t first = begin / payload_;
  const auto count = static_cast<std::size_t>((end - 1) / payload_ + 1 - first);
  const auto copyPages = [&](std::size_t from, std::size_t past) {
    std::vector<std::uint8_t> bytes((past - from) * page_size_);
    file_->read((first + from) * page_size_, bytes.size(), bytes.data());
    check(first + from, past - from, bytes.data());
    for (std::size_t k = from; k < past; ++k) {
      const std::uint8_t* const page = bytes.data() + (k - from) * page_size_;
      const std::uint64_t page_begin = (first + k) * payload_;
      const std::uint64_t part_begin = std::max(begin, page_begin);
      const std::uint64_t part_end = std::min(end, page_begin + payload_);
      std::memcpy(static_cast<std::uint8_t*>(to) + (part_begin - begin),
                  page + (part_begin - page_begin), part_end - part_begin);
    }
  };
  if (count <= pages_at_once) // such as the header of a packet
    copyPages(0, count);
  else
    parallelBlocks(count, pages_at_once, 0, copyPages);
}

} // namespace pcl::sedr::tools
