// SPDX-License-Identifier: BSD-3-Clause
#include "las_output.h"

#include "tagged_scan.h"
#include "tool_error.h"

#include <pcl/sedr_filters/point_types.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <ostream>
#include <utility>

namespace pcl::sedr::tools {

namespace {

/** @brief The class of ASPRS that a label fits. */
std::uint8_t
classOf(std::uint32_t label)
{
  const auto is = [label](StructureLabel l) {
    return label == static_cast<std::uint32_t>(l);
  };
  const bool is_building = is(StructureLabel::Wall) || is(StructureLabel::Ceiling) ||
                           is(StructureLabel::Detail) || is(StructureLabel::Column);
  return is(StructureLabel::Floor) ? 2 : is_building ? 6 : 1;
}

constexpr std::size_t record_head = 54; ///< of a record that describes points
constexpr std::size_t described = 192;  ///< of a field of extra bytes

/** @brief Describes extra bytes: one field, or `count` bytes of type 0. */
std::string
descriptor(const char* name, std::uint8_t type, std::uint8_t count, const char* text)
{
  std::string bytes(described, '\0');
  bytes[2] = static_cast<char>(type);
  bytes[3] = static_cast<char>(count);
  bytes.replace(4, std::strlen(name), name);
  bytes.replace(160, std::strlen(text), text);
  return bytes;
}

/** @brief Returns how many bytes of a point are described. */
std::size_t
sizeOf(const std::string& descriptors)
{
  constexpr std::array<std::size_t, 10> sizes{1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  std::size_t size = 0;
  for (std::size_t at = 0; at + described <= descriptors.size(); at += described) {
    const auto type = static_cast<std::uint8_t>(descriptors[at + 2]);
    size += type == 0 ? static_cast<std::uint8_t>(descriptors[at + 3])
                      : sizes[(type - 1) % 10] * ((type - 1) / 10 + 1);
  }
  return size;
}

} // namespace

LasOutput::LasOutput(std::ostream& stream, LasHead before)
    : stream_(stream)
    , head_(std::move(before))
    , size_(head_.get<std::uint16_t>(las::record))
    , is_old_(head_.format() < 6)
{
  describeTags();
  stream_ << head_.bytes;
}

void
LasOutput::add(const std::uint8_t* record, const PointTag& tag)
{
  const std::uint32_t room = std::max(tag.room, tag.owner);
  if (room > std::numeric_limits<std::uint16_t>::max())
    throw ToolError("room " + std::to_string(room) +
                    " has no number of 16 bits, as LAS needs: write .pcd");
  bytes_.assign(reinterpret_cast<const char*>(record), size_);
  const int flags = is_old_ ? record[15] & 0xe0 : 0; // in one byte with the class
  bytes_[is_old_ ? 15 : 16] = static_cast<char>(flags | classOf(tag.label));
  appendBytes(bytes_, static_cast<std::uint8_t>(tag.label));
  appendBytes(bytes_, static_cast<std::uint16_t>(tag.room));
  appendBytes(bytes_, static_cast<std::uint16_t>(tag.owner));
  stream_ << bytes_;
  std::array<std::int32_t, 3> steps{};
  std::memcpy(steps.data(), record, sizeof steps);
  bounds_.extend(Eigen::Map<const Eigen::Vector3i>(steps.data()));
  ++returns_[std::max(1, record[14] & (is_old_ ? 0x07 : 0x0f)) - 1];
  ++points_;
}

void
LasOutput::addRest(const InputFile& file, std::size_t end)
{
  constexpr std::size_t most = std::size_t{1} << 20;
  const std::size_t begin =
      head_.bytes.size() + points_ * head_.get<std::uint16_t>(las::record);
  for (const std::size_t place : {las::waveforms, las::after})
    if (place + sizeof(std::uint64_t) <= head_.get<std::uint16_t>(las::header_size) &&
        head_.get<std::uint64_t>(place) >= end)
      head_.set(place, head_.get<std::uint64_t>(place) + begin - end);
  for (std::size_t at = end; at < file.size(); at += bytes_.size()) {
    bytes_.resize(std::min(most, file.size() - at));
    file.read(at, bytes_.size(), bytes_.data());
    stream_ << bytes_;
  }
}

/** @brief Sets the number of points, and of those of each return. */
template <typename T>
void
LasOutput::setCounts(std::size_t from, std::size_t to)
{
  head_.set(from, static_cast<T>(points_));
  for (std::size_t k = 0; from + (k + 2) * sizeof(T) <= to; ++k)
    head_.set(from + (k + 1) * sizeof(T), static_cast<T>(returns_[k]));
}

void
LasOutput::finish()
{
  for (std::size_t axis = 0; axis < 3 && points_ > 0; ++axis)
    for (const bool is_least : {false, true}) {
      const std::size_t next = axis * sizeof(double);
      const int steps = (is_least ? bounds_.min() : bounds_.max())[axis];
      head_.set(las::bounds + 2 * next + (is_least ? sizeof(double) : 0),
                steps * head_.get<double>(las::scale + next) +
                    head_.get<double>(las::shift + next));
    }
  if (is_old_ && points_ <= std::numeric_limits<std::uint32_t>::max())
    setCounts<std::uint32_t>(las::points, las::scale);
  if (head_.get<std::uint8_t>(las::version + 1) == las::newest_minor)
    setCounts<std::uint64_t>(las::many_points, las::header_of_1_4);
  stream_.seekp(0);
  stream_ << head_.bytes;
}

/** @brief Appends the tags to the descriptions of extra bytes, those that points have
 * without a description before them; tags of an earlier run are replaced. */
void
LasOutput::describeTags()
{
  const std::string tags =
      descriptor("label", 1, 0, "1ceil 2floor 3wall 4detail 5col") +
      descriptor("room", 3, 0, "room of the label, 0 none") +
      descriptor("owner", 3, 0, "room around the point, 0 none");
  const std::size_t begin = head_.bytes.size();
  const std::size_t first = head_.get<std::uint16_t>(las::header_size);
  std::string fields;
  std::string kept = head_.bytes.substr(0, first);
  std::uint32_t count = 1;
  std::size_t at = first;
  for (auto left = head_.get<std::uint32_t>(las::descriptions);
       left > 0 && at + record_head <= begin; --left) {
    const std::size_t size = record_head + head_.get<std::uint16_t>(at + 20);
    if (at + size > begin)
      break;
    const bool are_fields = head_.bytes.compare(at + 2, 10, "LASF_Spec", 10) == 0 &&
                            head_.get<std::uint16_t>(at + 18) == 4;
    (are_fields ? fields : kept) += head_.bytes.substr(
        at + (are_fields ? record_head : 0), size - (are_fields ? record_head : 0));
    count += are_fields ? 0 : 1;
    at += size;
  }
  const std::size_t extra = size_ - las::sizes[head_.format()];
  if (sizeOf(fields) > extra ||
      fields.size() > std::numeric_limits<std::uint16_t>::max() - 2 * tags.size())
    fields.clear();
  for (std::size_t bare = extra - sizeOf(fields); bare > 0;) {
    const std::size_t some = std::min<std::size_t>(bare, 255);
    fields += descriptor("", 0, static_cast<std::uint8_t>(some), "");
    bare -= some;
  }
  if (fields.size() >= tags.size() &&
      fields.compare(fields.size() - tags.size(), tags.size(), tags) == 0)
    size_ -= sizeOf(tags);
  else
    fields += tags;
  LasHead record{std::string(record_head, '\0')};
  record.bytes.replace(2, 9, "LASF_Spec");
  record.set(18, std::uint16_t{4}); // extra bytes
  record.set(20, static_cast<std::uint16_t>(fields.size()));
  head_.bytes = kept + record.bytes + fields + head_.bytes.substr(at);
  head_.set(las::begin, static_cast<std::uint32_t>(head_.bytes.size()));
  head_.set(las::descriptions, count);
  head_.set(las::record, static_cast<std::uint16_t>(size_ + sizeOf(tags)));
}

} // namespace pcl::sedr::tools
