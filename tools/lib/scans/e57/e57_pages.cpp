// SPDX-License-Identifier: BSD-3-Clause
#include "e57_pages.h"

#include "crc32c.h"
#include "tool_error.h"

#include <algorithm>
#include <cstdio>
#include <cstring>

namespace pcl::sedr::tools {

namespace {

constexpr char signature[] = "ASTM-E57";
constexpr std::size_t signature_size = sizeof signature - 1;
constexpr std::uint64_t header_size = 48;
constexpr std::uint64_t checksum_size = 4;

template <typename T>
T
valueAt(const MappedFile& file, std::size_t position)
{
  T value{};
  std::memcpy(&value, file.data() + position, sizeof value);
  return value;
}

} // namespace

bool
looksLikeE57(const MappedFile& file)
{
  return file.size() >= signature_size &&
         std::memcmp(file.data(), signature, signature_size) == 0;
}

E57Pages::E57Pages(const MappedFile& file)
    : file_(file)
{
  const auto number = [](std::uint64_t value) { return std::to_string(value); };
  if (file.size() < header_size)
    throw ToolError("the file is cut off, it has " + number(file.size()) +
                    " bytes of the " + number(header_size) + " of its header");
  const auto version = valueAt<std::uint32_t>(file, 8);
  const auto length = valueAt<std::uint64_t>(file, 16);
  const auto xml_physical = valueAt<std::uint64_t>(file, 24);
  xml_size_ = valueAt<std::uint64_t>(file, 32);
  page_size_ = valueAt<std::uint64_t>(file, 40);
  constexpr std::uint64_t min_page = 64;
  constexpr std::uint64_t largest_page = std::uint64_t{1} << 24;
  if (version != 1)
    throw ToolError("it is of version " + number(version) + ", known is version 1");
  if (page_size_ < min_page || page_size_ > largest_page)
    throw ToolError("its pages are said to have " + number(page_size_) + " bytes");
  if (length > file.size())
    throw ToolError("the file is cut off, its header promises " + number(length) +
                    " bytes, " + number(file.size()) + " are there");
  if (length == 0 || length % page_size_ != 0)
    throw ToolError("its " + number(length) +
                    " bytes are no whole number of pages of " + number(page_size_));
  payload_ = page_size_ - checksum_size;
  pages_ = length / page_size_;
  checkPage(0);
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
E57Pages::checkPage(std::uint64_t page) const
{
  const auto* bytes = file_.data() + page * page_size_;
  std::uint32_t stored = 0; // the only big-endian number of the format
  for (std::uint64_t k = 0; k < checksum_size; ++k)
    stored = stored << 8 | bytes[payload_ + k];
  const std::uint32_t computed = crc32c(bytes, payload_);
  if (stored == computed)
    return;
  char text[80];
  std::snprintf(text, sizeof text, "its checksum is %08x, that of its bytes %08x",
                stored, computed);
  throw ToolError("page " + std::to_string(page + 1) + " of " + std::to_string(pages_) +
                  " is damaged, " + text);
}

void
E57Pages::copy(std::uint64_t begin, std::size_t size, std::uint8_t* to) const
{
  if (begin > this->size() || size > this->size() - begin)
    throw ToolError(std::to_string(size) + " bytes are wanted from byte " +
                    std::to_string(physical(begin)) + " on, which is beyond its end");
  while (size > 0) {
    const std::uint64_t page = begin / payload_;
    const std::uint64_t within = begin % payload_;
    const auto part =
        static_cast<std::size_t>(std::min<std::uint64_t>(size, payload_ - within));
    checkPage(page);
    std::memcpy(to, file_.data() + page * page_size_ + within, part);
    begin += part;
    to += part;
    size -= part;
  }
}

void
E57Pages::check(std::uint64_t begin, std::uint64_t size) const
{
  const std::uint64_t first = begin / payload_;
  constexpr std::uint64_t stride = 1024; // pages
  for (std::uint64_t page = first; page < pages_ && page * payload_ < begin + size;
       ++page) {
    checkPage(page);
    if ((page - first) % stride == stride - 1)
      release((page + 1 - stride) * payload_, page * payload_);
  }
  release(begin, begin + size);
}

void
E57Pages::release(std::uint64_t begin, std::uint64_t end) const
{
  const std::uint64_t from = physical(begin);
  file_.release(static_cast<std::size_t>(from),
                static_cast<std::size_t>(physical(end) - from));
}

} // namespace pcl::sedr::tools
