// SPDX-License-Identifier: BSD-3-Clause
#include "plain_text.h"

#include <algorithm>
#include <cstdint>

namespace pcl::sedr::tools {

namespace {

/** @brief Returns the number of bytes of the printable character of UTF-8 at the start
 * of a text, 0 if there is none. */
std::size_t
printableBytes(std::string_view text)
{
  const auto byte = [&](std::size_t k) { return static_cast<std::uint8_t>(text[k]); };
  constexpr std::uint8_t del = 0x7f;
  if (byte(0) <= del)
    return byte(0) >= ' ' && byte(0) != del ? 1 : 0;
  // The first byte tells how many follow, and holds the highest bits.
  const std::size_t size = byte(0) >= 0xf0 ? 4 : byte(0) >= 0xe0 ? 3 : 2;
  if (byte(0) < 0xc2 || byte(0) > 0xf4 || size > text.size())
    return 0;
  std::uint32_t code = byte(0) & (0xffU >> (size + 1));
  for (std::size_t k = 1; k < size; ++k) {
    if ((byte(k) & 0xc0) != 0x80)
      return 0;
    code = code << 6 | (byte(k) & 0x3fU);
  }
  constexpr std::uint32_t first_of_3 = 0x800, first_of_4 = 0x10000;
  const bool is_overlong =
      (size == 3 && code < first_of_3) || (size == 4 && code < first_of_4);
  const bool is_control = code < 0xa0 || (code >= 0x2028 && code <= 0x202e) ||
                          (code >= 0x2066 && code <= 0x2069);
  const bool is_surrogate = code >= 0xd800 && code < 0xe000;
  return is_overlong || is_control || is_surrogate || code > 0x10ffff ? 0 : size;
}

} // namespace

std::string
plainText(std::string_view text, std::size_t most)
{
  constexpr const char* digits = "0123456789abcdef";
  std::string plain;
  while (!text.empty()) {
    const std::size_t size = printableBytes(text);
    const std::size_t taken = std::max<std::size_t>(size, 1);
    const auto byte = static_cast<std::uint8_t>(text.front());
    const std::string shown =
        size > 0 ? std::string(text.substr(0, size))
                 : std::string{'\\', 'x', digits[byte >> 4], digits[byte & 0xf]};
    if (plain.size() + shown.size() > most)
      return plain + "...";
    plain += shown;
    text.remove_prefix(taken);
  }
  return plain;
}

std::string
quotedWord(std::string_view word)
{
  constexpr std::size_t most = 40;
  return "'" + plainText(word, most) + "'";
}

} // namespace pcl::sedr::tools
