// SPDX-License-Identifier: BSD-3-Clause
#include "tool_error.h"

#include "sedr_filters/src/base/printable.h"

#include <boost/locale/utf.hpp>

#include <cstdint>

namespace pcl::sedr::tools {

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
