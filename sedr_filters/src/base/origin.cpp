// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/scan_frame.h>

#include <charconv>
#include <cmath>
#include <cstdio>

namespace pcl::sedr {

std::string
Origin::text(const std::string& separator) const
{
  std::string all;
  for (int axis = 0; axis < 3; ++axis) {
    char number[400]; // the largest double has 309 digits
    std::snprintf(number, sizeof number, "%.6f", place[axis]);
    std::string digits = number;
    digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.back() == '.')
      digits.pop_back();
    all += (axis > 0 ? separator : "") + (digits == "-0" ? "0" : digits);
  }
  return all;
}

bool
Origin::fromText(const std::string& text, Origin& origin)
{
  Origin read;
  const char* c = text.data();
  const char* const end = c + text.size();
  const auto skip = [&] {
    while (c != end && (*c == ' ' || *c == ',' || *c == '\t' || *c == '\r'))
      ++c;
  };
  for (int axis = 0; axis < 3; ++axis) {
    skip();
    const auto result = std::from_chars(c, end, read.place[axis]);
    if (result.ec != std::errc() || !std::isfinite(read.place[axis]))
      return false;
    c = result.ptr;
    if (c != end && *c != ' ' && *c != ',' && *c != '\t' && *c != '\r')
      return false;
  }
  skip();
  if (c != end)
    return false;
  origin = read;
  return true;
}

bool
Origin::fromComment(const std::string& line, Origin& origin)
{
  const std::string word = "sedr_origin ";
  const std::size_t at = line.find(word);
  return at != std::string::npos && fromText(line.substr(at + word.size()), origin);
}

// Not in the header: it takes five seconds to compile.
Levelling
Levelling::of(const Eigen::Vector3d& up, const Eigen::Vector3d& about)
{
  return {Eigen::Quaterniond::FromTwoVectors(up, Eigen::Vector3d::UnitZ())
              .toRotationMatrix(),
          about};
}

} // namespace pcl::sedr
