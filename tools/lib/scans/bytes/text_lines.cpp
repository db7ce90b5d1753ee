// SPDX-License-Identifier: BSD-3-Clause
#include "text_lines.h"

#include <algorithm>
#include <cstdlib>

namespace pcl::sedr::tools {

namespace {

/** @brief Returns the number of bytes before the end of the first line. */
std::size_t
lengthOfLine(std::string_view text)
{
  constexpr std::size_t stride = 256; // a file may have only one of the two signs
  for (std::size_t at = 0; at < text.size(); at += stride) {
    std::string_view part = text.substr(at, stride);
    const std::size_t feed = part.find('\n');
    part = part.substr(0, feed);
    const std::size_t back = part.find('\r');
    if (feed != part.npos || back != part.npos)
      return at + std::min(feed, back);
  }
  return text.size();
}

} // namespace

bool
takeLine(std::string_view& text, std::string_view& line)
{
  if (text.empty())
    return false;
  line = text.substr(0, lengthOfLine(text));
  text.remove_prefix(line.size());
  if (!text.empty())
    text.remove_prefix(text.substr(0, 2) == "\r\n" ? 2 : 1);
  return true;
}

bool
LineReader::next(std::string_view& line)
{
  constexpr std::size_t longest = std::size_t{1} << 20;
  constexpr std::size_t step = std::size_t{1} << 12; // bytes
  // A line feed that belongs to the carriage return at the buffer's end may follow.
  while (end_ < file_.size() && rest_.size() < longest &&
         lengthOfLine(rest_) + 1 >= rest_.size()) {
    const std::size_t kept = rest_.size();
    const std::size_t more = std::min(step + kept, file_.size() - end_);
    buffer_ = std::string(rest_) + std::string(more, '\0');
    file_.read(end_, more, buffer_.data() + kept);
    end_ += more;
    rest_ = buffer_;
  }
  return takeLine(rest_, line);
}

std::vector<std::string_view>
wordsOf(std::string_view line)
{
  constexpr std::string_view blanks = " \t\r";
  std::vector<std::string_view> words;
  for (std::size_t at = line.find_first_not_of(blanks); at != line.npos;
       at = line.find_first_not_of(blanks, at)) {
    const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = end;
  }
  return words;
}

std::from_chars_result
readNumber(const char* begin, const char* end, double& value)
{
  const auto result = std::from_chars(begin, end, value);
  if (result.ec != std::errc::result_out_of_range)
    return result;
  value = std::strtod(std::string(begin, result.ptr).c_str(), nullptr);
  return {result.ptr, std::errc()};
}

} // namespace pcl::sedr::tools
