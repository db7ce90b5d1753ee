// SPDX-License-Identifier: BSD-3-Clause
#include "letter_widths.h"

#include <cstddef>

namespace pcl::sedr {
namespace {

/** @brief Helvetica's widths from blank to tilde, thousandths of the font size, from
 * Adobe's font metrics. */
constexpr int widths[] = {
    278,  278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278,
    556,  556, 556, 556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556,
    1015, 667, 667, 722, 722, 667, 611, 778, 722, 278, 500, 667, 556, 833, 722, 778,
    667,  778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 278, 278, 278, 469, 556,
    333,  556, 556, 500, 556, 556, 278, 556, 556, 222, 222, 500, 222, 833, 556, 556,
    556,  556, 333, 500, 278, 556, 500, 722, 500, 500, 500, 334, 260, 334, 584};
constexpr char32_t first = U' ';
constexpr char32_t last = U'~';
constexpr int other = 556;

/** @brief Returns how many bytes follow the first one of a UTF-8 letter. */
std::size_t
bytesAfter(unsigned char byte)
{
  return byte >= 0xf0 ? 3 : byte >= 0xe0 ? 2 : byte >= 0xc0 ? 1 : 0;
}

} // namespace

std::u32string
lettersOf(const std::string& utf8)
{
  std::u32string letters;
  for (std::size_t i = 0; i < utf8.size();) {
    const auto byte = static_cast<unsigned char>(utf8[i++]);
    std::size_t more = bytesAfter(byte);
    char32_t letter = more == 0 ? byte : byte & (0x3fU >> more);
    bool is_sound = byte < 0x80 || more > 0;
    for (; more > 0 && i < utf8.size(); --more) {
      const auto next = static_cast<unsigned char>(utf8[i]);
      if ((next & 0xc0U) != 0x80U)
        break;
      letter = (letter << 6U) | (next & 0x3fU);
      ++i;
    }
    is_sound = is_sound && more == 0;
    letters += is_sound ? letter : U'?';
  }
  return letters;
}

double
textWidth(const std::string& utf8)
{
  int width = 0;
  for (const char32_t letter : lettersOf(utf8))
    width += letter >= first && letter <= last ? widths[letter - first] : other;
  return width / 1000.0;
}

} // namespace pcl::sedr
