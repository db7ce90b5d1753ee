// SPDX-License-Identifier: BSD-3-Clause
#include "e57_packets.h"

#include "plain_text.h"
#include "tool_error.h"

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
  const E57Field& field = *field_;
  const auto* const bytes = bytes_.data();
  const std::uint64_t begin = first_bit_ + std::uint64_t{first} * field.bits;
  if (field.bits == 0)
    std::fill_n(values, size, scaled(field, 0));
  else if (field.kind == E57Field::Kind::Float)
    for (std::size_t i = 0; i < size; ++i)
      values[i] = valueAt<float>(bytes + (first + i) * sizeof(float));
  else if (field.kind == E57Field::Kind::Double)
    std::memcpy(values, bytes + first * sizeof(double), size * sizeof(double));
  else
    for (std::size_t i = 0; i < size; ++i)
      values[i] = scaled(field, bitsAt(bytes, begin + i * field.bits, field.bits));
}

E57Packets::E57Packets(const E57Pages& pages,
                       const E57Scan& scan,
                       const std::vector<std::size_t>& wanted)
    : pages_(pages)
    , scan_(scan)
    , wanted_(wanted)
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
  index();
}

bool
E57Packets::next(std::uint64_t& place, const Read& read, Packet& packet) const
{
  const auto refuse = [&](const std::string& reason) {
    throw ToolError("the packet at byte " + text(pages_.physical(place)) + " " +
                    reason);
  };
  for (; end_ - place >= packet_head; place += packet.size) {
    std::uint8_t head[packet_head];
    read(place, packet_head, head);
    packet.place = place;
    packet.size = std::size_t{valueAt<std::uint16_t>(head + 2)} + 1;
    if (head[0] > EmptyPacket)
      refuse("is of the type " + text(head[0]) + ", which is unknown");
    const std::size_t least = head[0] == DataPacket ? packet_head : min_packet;
    if (packet.size < least || packet.size > end_ - place)
      refuse("is said to have " + text(packet.size) + " bytes, " + text(end_ - place) +
             " are left");
    if (head[0] != DataPacket)
      continue;
    readPieces(valueAt<std::uint16_t>(head + 4), read, packet);
    place += packet.size;
    return true;
  }
  return false;
}

void
E57Packets::readPieces(std::size_t streams, const Read& read, Packet& packet) const
{
  const auto refuse = [&](const std::string& reason) {
    throw ToolError("the packet at byte " + text(pages_.physical(packet.place)) +
                    " of " + text(packet.size) + " bytes has " + text(streams) +
                    " streams for " + text(scan_.fields.size()) + " fields" + reason);
  };
  std::size_t begin = packet_head + 2 * scan_.fields.size();
  if (streams != scan_.fields.size() || packet.size < begin)
    refuse("");
  std::vector<std::uint16_t> lengths(streams);
  read(packet.place + packet_head, 2 * streams, lengths.data());
  packet.begins.assign(wanted_.size(), 0);
  packet.sizes.assign(wanted_.size(), 0);
  for (std::size_t s = 0; s < streams; ++s) {
    for (std::size_t w = 0; w < wanted_.size(); ++w)
      if (wanted_[w] == s) {
        packet.begins[w] = begin;
        packet.sizes[w] = lengths[s];
      }
    begin += lengths[s];
  }
  if (begin > packet.size)
    refuse(", which take " + text(begin));
}

void
E57Packets::index()
{
  constexpr std::uint64_t stride = std::uint64_t{1} << 16; // bytes
  std::vector<std::uint64_t> seen(wanted_.size(), 0);
  const Read read = [&](std::uint64_t begin, std::size_t size, void* to) {
    pages_.read(begin, size, to);
  };
  std::uint64_t place = begin_;
  for (Packet packet; next(place, read, packet);) {
    if (marks_.empty() || packet.place - marks_.back().place >= stride)
      marks_.push_back({packet.place, seen});
    for (std::size_t w = 0; w < seen.size(); ++w)
      seen[w] += packet.sizes[w];
  }
  marks_.push_back({end_, seen});
  checkCount(seen);
}

void
E57Packets::checkCount(const std::vector<std::uint64_t>& seen) const
{
  bool has_bits = false;
  for (std::size_t w = 0; w < seen.size(); ++w) {
    const E57Field& own = field(w);
    if (own.bits == 0)
      continue;
    has_bits = true;
    // Writers fill up the last integers to a machine word.
    const std::uint64_t padding =
        own.kind == E57Field::Kind::Integer ? sizeof(std::uint64_t) : own.bits / 8;
    const std::uint64_t needed = (scan_.points * own.bits + 7) / 8;
    if (seen[w] < needed || seen[w] >= needed + padding)
      throw ToolError("it is said to have " + text(scan_.points) +
                      " points, its packets hold " + quotedWord(own.name) + " of " +
                      text(8 * seen[w] / own.bits));
  }
  // Constants take no bytes; points of nothing else are bounded by a bit each.
  const std::uint64_t most = 8 * pages_.size();
  if (!has_bits && scan_.points > most)
    throw ToolError("all of its " + text(scan_.points) +
                    " points are one and the same, the whole file has " + text(most) +
                    " bits");
}

std::size_t
E57Packets::markAt(std::uint64_t point, bool is_end) const
{
  const auto isBefore = [&](const Mark& mark, std::uint64_t at) {
    bool are_all = true;
    bool is_any = false;
    for (std::size_t w = 0; w < wanted_.size(); ++w) {
      const std::uint64_t bits = field(w).bits;
      const std::uint64_t byte = is_end ? (at * bits + 7) / 8 : at * bits / 8;
      are_all = are_all && (bits == 0 || mark.seen[w] <= byte);
      is_any = is_any || (bits > 0 && mark.seen[w] < byte);
    }
    return is_end ? is_any : are_all;
  };
  const auto mark = std::lower_bound(marks_.begin(), marks_.end() - 1, point, isBefore);
  const auto number = static_cast<std::size_t>(mark - marks_.begin());
  return is_end || number == 0 ? number : number - 1;
}

std::vector<E57Values>
E57Packets::read(std::uint64_t begin, std::uint64_t end) const
{
  const std::size_t first = markAt(begin, false);
  const std::uint64_t from = marks_[first].place;
  const std::uint64_t to = marks_[markAt(end, true)].place;
  // Kept, as the system would hand out new pages of memory for every chunk.
  thread_local std::vector<std::uint8_t> bytes;
  bytes.resize(static_cast<std::size_t>(std::max(from, to) - from));
  pages_.read(from, bytes.size(), bytes.data());
  pages_.expect(from + bytes.size(), bytes.size());
  const Read copy = [&](std::uint64_t at, std::size_t size, void* where) {
    if (size > bytes.size() || at - from > bytes.size() - size)
      throw ToolError("it has changed while it was read");
    std::memcpy(where, bytes.data() + (at - from), size);
  };

  const auto sizeOf = [&](std::size_t w) {
    const std::uint64_t bits = field(w).bits;
    return static_cast<std::size_t>((end * bits + 7) / 8 - begin * bits / 8);
  };
  std::vector<E57Values> values(wanted_.size());
  std::vector<std::uint64_t> seen = marks_[first].seen;
  for (std::size_t w = 0; w < values.size(); ++w) {
    values[w].field_ = &field(w);
    values[w].first_bit_ = static_cast<unsigned>(begin * field(w).bits % 8);
    values[w].bytes_.reserve(sizeOf(w) + spare);
  }
  Packet packet;
  for (std::uint64_t place = from; place < to && next(place, copy, packet);)
    for (std::size_t w = 0; w < values.size(); ++w) {
      const std::uint64_t bits = field(w).bits;
      const std::uint64_t part = std::max(seen[w], begin * bits / 8);
      const std::uint64_t part_end =
          std::min(seen[w] + packet.sizes[w], (end * bits + 7) / 8);
      const auto* const piece =
          bytes.data() + (packet.place - from) + packet.begins[w] - seen[w];
      if (bits > 0 && part < part_end)
        values[w].bytes_.insert(values[w].bytes_.end(), piece + part, piece + part_end);
      seen[w] += packet.sizes[w];
    }
  for (std::size_t w = 0; w < values.size(); ++w) // all, even if the file has changed
    values[w].bytes_.resize(sizeOf(w) + spare, 0);
  return values;
}

void
E57Packets::check() const
{
  constexpr std::uint64_t step = std::uint64_t{1} << 23; // bytes
  std::vector<std::uint8_t> bytes(step);
  for (std::uint64_t at = begin_; at < end_; at += step)
    pages_.read(at, static_cast<std::size_t>(std::min(step, end_ - at)), bytes.data());
}

} // namespace pcl::sedr::tools
