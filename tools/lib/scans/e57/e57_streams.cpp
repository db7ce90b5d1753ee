// SPDX-License-Identifier: BSD-3-Clause
#include "e57_reader.h"

#include "plain_text.h"
#include "tool_error.h"

#include "sedr_filters/src/base/parallel.h"

#include <algorithm>
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
                       const std::vector<int>& fields)
    : pages_(pages)
    , scan_(scan)
    , numbers_(fields)
    , pieces_(fields.size())
{
  for (const int number : fields)
    fields_.push_back(number < 0 ? nullptr
                                 : &scan.fields[static_cast<std::size_t>(number)]);
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
    for (std::size_t f = 0; f < numbers_.size(); ++f)
      if (numbers_[f] == static_cast<int>(s)) {
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

} // namespace pcl::sedr::tools
