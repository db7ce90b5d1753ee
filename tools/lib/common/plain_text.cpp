// SPDX-License-Identifier: BSD-3-Clause
#include "plain_text.h"

#include <boost/locale/utf.hpp>

#include <cstdint>

namespace pcl::sedr::tools {

namespace {

/** @brief Returns whether a character of Unicode shows itself and moves nothing. */
bool
isPrintable(std::uint32_t code)
{
  const bool is_control = code < ' ' || (code >= 0x7f && code < 0xa0);
  const bool turns = (code >= 0x2028 && code <= 0x202e) || // lines, directions
                     (code >= 0x2066 && code <= 0x2069);
  return boost::locale::utf::is_valid_codepoint(code) && !is_control && !turns;
}

} // namespace

std::string
plainText(std::string_view text, std::size_t most)
{
  constexpr const char* digits = "0123456789abcdef";
  std::string plain;
  for (const char* at = text.data(); at != text.data() + text.size();) {
    const char* next = at;
    const auto code =
        boost::locale::utf::utf_traits<char>::decode(next, text.data() + text.size());
    const auto byte = static_cast<std::uint8_t>(*at);
    std::string shown{'\\', 'x', digits[byte >> 4], digits[byte & 0xf]};
    if (isPrintable(code))
      shown.assign(at, next);
    if (plain.size() + shown.size() > most)
      return plain + "...";
    at = isPrintable(code) ? next : at + 1;
    plain += shown;
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
