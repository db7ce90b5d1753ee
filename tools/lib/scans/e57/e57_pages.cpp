// SPDX-License-Identifier: BSD-3-Clause
#include "e57_reader.h"

#include "formats/scan_formats.h"
#include "tool_error.h"

#include "sedr_filters/src/base/parallel.h"

#include <boost/crc.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>

namespace pcl::sedr::tools {

namespace {

constexpr std::uint64_t header_size = 48;
constexpr std::uint64_t checksum_size = 4;
constexpr std::uint64_t read_at_once = std::uint64_t{1} << 16; // bytes, a thread

/** @brief CRC-32C (Castagnoli) of RFC 3720. */
using Crc32c = boost::crc_optimal<32, 0x1edc6f41, 0xffffffff, 0xffffffff, true, true>;

} // namespace

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
