// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/locale/utf.hpp>

#include <cstdint>

namespace pcl::sedr {

/** @brief Returns whether a character of Unicode shows itself and moves nothing. */
inline bool
isPrintable(std::uint32_t code)
{
  const bool is_control = code < ' ' || (code >= 0x7f && code < 0xa0);
  const bool turns = code == 0x61c || code == 0x200e || code == 0x200f || // directions
                     (code >= 0x2028 && code <= 0x202e) ||                // and lines
                     (code >= 0x2066 && code <= 0x2069);
  const bool is_none = (code & 0xfffeU) == 0xfffeU; // XML has none of these
  return boost::locale::utf::is_valid_codepoint(code) && !is_control && !turns &&
         !is_none;
}

} // namespace pcl::sedr
