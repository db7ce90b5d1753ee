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

} // namespace

/** @brief A data packet with the position of each wanted stream's piece. */
struct E57Packets::Packet {
  std::uint64_t place = 0; ///< logical
  std::size_t size = 0;    ///< bytes
  std::vector<std::size_t> begins;
  std::vector<std::size_t> sizes;
};

/** @brief Iterates over data packets. */
class E57Packets::Walk {
public:
  Walk(const E57Packets& packets, std::uint64_t place)
      : packets_(packets)
      , place_(place)
      , lengths_(2 * packets.scan_.fields.size())
  {}

  /** @brief Reads the header of the next data packet; false if there is none. */
  bool next(Packet& packet)
  {
    for (; packets_.end_ - place_ >= packet_head; place_ += packet.size) {
      std::uint8_t head[packet_head];
      packets_.pages_.copy(place_, packet_head, head);
      packet.place = place_;
      packet.size = std::size_t{valueAt<std::uint16_t>(head + 2)} + 1;
      if (head[0] > EmptyPacket)
        refuse("is of the type " + text(head[0]) + ", which is unknown");
      const std::size_t least = head[0] == DataPacket ? packet_head : min_packet;
      if (packet.size < least || packet.size > packets_.end_ - place_)
        refuse("is said to have " + text(packet.size) + " bytes, " +
               text(packets_.end_ - place_) + " are left");
      if (head[0] != DataPacket)
        continue;
      readPieces(valueAt<std::uint16_t>(head + 4), packet);
      place_ += packet.size;
      return true;
    }
    return false;
  }

private:
  [[noreturn]] void refuse(const std::string& reason) const
  {
    throw ToolError("the packet at byte " + text(packets_.pages_.physical(place_)) +
                    " " + reason);
  }

  void readPieces(std::size_t streams, Packet& packet)
  {
    const std::size_t fields = packets_.scan_.fields.size();
    if (streams != fields)
      refuse("has " + text(streams) + " streams for " + text(fields) + " fields");
    if (packet.size < packet_head + lengths_.size())
      refuse("of " + text(packet.size) + " bytes has no room for the lengths of its " +
             text(fields) + " streams");
    packets_.pages_.copy(place_ + packet_head, lengths_.size(), lengths_.data());
    packet.begins.clear();
    packet.sizes.clear();
    std::size_t begin = packet_head + lengths_.size();
    std::size_t wanted = 0;
    for (std::size_t s = 0; s < fields; ++s) {
      const std::size_t size = valueAt<std::uint16_t>(&lengths_[2 * s]);
      if (wanted < packets_.wanted_.size() && packets_.wanted_[wanted] == s) {
        packet.begins.push_back(begin);
        packet.sizes.push_back(size);
        ++wanted;
      }
      begin += size;
    }
    if (begin > packet.size)
      refuse("of " + text(packet.size) + " bytes overruns, its streams take " +
             text(begin));
  }

  const E57Packets& packets_;
  std::uint64_t place_;
  std::vector<std::uint8_t> lengths_;
};

E57Packets::E57Packets(const E57Pages& pages,
                       const E57Scan& scan,
                       std::vector<std::size_t> wanted)
    : pages_(pages)
    , scan_(scan)
    , wanted_(std::move(wanted))
{
  std::sort(wanted_.begin(), wanted_.end());
  std::uint8_t head[section_head];
  pages.copy(scan.section, section_head, head);
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

void
E57Packets::index()
{
  constexpr std::uint64_t stride = std::uint64_t{1} << 18; // bytes
  std::vector<std::uint64_t> seen(wanted_.size(), 0);
  Walk walk(*this, begin_);
  for (Packet packet; walk.next(packet);) {
    if (mark_places_.empty() || packet.place - mark_places_.back() >= stride) {
      if (!mark_places_.empty()) // else all of the file would stay in memory
        pages_.release(mark_places_.back(), packet.place);
      mark_places_.push_back(packet.place);
      mark_bytes_.insert(mark_bytes_.end(), seen.begin(), seen.end());
    }
    for (std::size_t w = 0; w < seen.size(); ++w)
      seen[w] += packet.sizes[w];
  }
  checkCount(seen);
}

void
E57Packets::checkCount(const std::vector<std::uint64_t>& seen) const
{
  const std::vector<Part> all = partsOf(0, scan_.points);
  bool has_bits = false;
  for (std::size_t w = 0; w < seen.size(); ++w) {
    if (bitsOf(w) == 0)
      continue;
    has_bits = true;
    const E57Field& field = scan_.fields[wanted_[w]];
    // Writers fill up the last integers to a machine word.
    const std::uint64_t padding =
        field.kind == E57Field::Kind::Integer ? sizeof(std::uint64_t) : bitsOf(w) / 8;
    if (seen[w] < all[w].end || seen[w] >= all[w].end + padding)
      throw ToolError("it is said to have " + text(scan_.points) +
                      " points, its packets hold " + quotedWord(field.name) + " of " +
                      text(8 * seen[w] / bitsOf(w)));
  }
  // Constants take no bytes; points of nothing else are bounded by a bit each.
  const std::uint64_t most = 8 * pages_.size();
  if (!has_bits && scan_.points > most)
    throw ToolError("all of its " + text(scan_.points) +
                    " points are one and the same, the whole file has " + text(most) +
                    " bits");
}

std::vector<E57Packets::Part>
E57Packets::partsOf(std::uint64_t begin, std::uint64_t end) const
{
  std::vector<Part> parts;
  for (std::size_t w = 0; w < wanted_.size(); ++w)
    parts.push_back({begin * bitsOf(w) / 8, (end * bitsOf(w) + 7) / 8});
  return parts;
}

std::size_t
E57Packets::markBefore(const std::vector<Part>& parts) const
{
  const auto isBefore = [&](std::size_t mark) {
    for (std::size_t w = 0; w < parts.size(); ++w)
      if (bitsOf(w) > 0 && mark_bytes_[mark * parts.size() + w] > parts[w].begin)
        return false;
    return true;
  };
  std::size_t low = 0; // precedes all parts
  std::size_t high = mark_places_.size();
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    (isBefore(middle) ? low : high) = middle;
  }
  return low;
}

std::uint64_t
E57Packets::placeOf(std::uint64_t point) const
{
  return mark_places_.empty() ? end_ : mark_places_[markBefore(partsOf(point, point))];
}

std::vector<E57Bytes>
E57Packets::read(std::uint64_t begin, std::uint64_t end) const
{
  const std::vector<Part> parts = partsOf(begin, end);
  std::vector<E57Bytes> lists(parts.size());
  for (std::size_t w = 0; w < parts.size(); ++w) {
    lists[w].first_bit = static_cast<unsigned>(begin * bitsOf(w) % 8);
    lists[w].bytes.reserve(static_cast<std::size_t>(parts[w].end - parts[w].begin) +
                           spare);
  }
  if (!mark_places_.empty()) {
    const std::size_t mark = markBefore(parts);
    const auto* first = mark_bytes_.data() + mark * parts.size();
    std::vector<std::uint64_t> seen(first, first + parts.size());
    std::vector<std::uint8_t> whole;
    Walk walk(*this, mark_places_[mark]);
    const auto isFull = [&] {
      for (std::size_t w = 0; w < parts.size(); ++w)
        if (bitsOf(w) > 0 && seen[w] < parts[w].end)
          return false;
      return true;
    };
    for (Packet packet; !isFull() && walk.next(packet);) {
      whole.clear();
      for (std::size_t w = 0; w < parts.size(); ++w) {
        const std::uint64_t from = std::max(seen[w], parts[w].begin);
        const std::uint64_t to = std::min(seen[w] + packet.sizes[w], parts[w].end);
        if (bitsOf(w) > 0 && from < to) {
          if (whole.empty()) {
            whole.resize(packet.size);
            pages_.copy(packet.place, packet.size, whole.data());
          }
          const auto* piece = whole.data() + packet.begins[w];
          lists[w].bytes.insert(lists[w].bytes.end(), piece + (from - seen[w]),
                                piece + (to - seen[w]));
        }
        seen[w] += packet.sizes[w];
      }
    }
  }
  for (std::size_t w = 0; w < parts.size(); ++w) // whole, even if the file has changed
    lists[w].bytes.resize(
        static_cast<std::size_t>(parts[w].end - parts[w].begin) + spare, 0);
  return lists;
}

} // namespace pcl::sedr::tools
