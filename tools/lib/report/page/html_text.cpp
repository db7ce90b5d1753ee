// SPDX-License-Identifier: BSD-3-Clause
#include "html_text.h"

#include "scale.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>

namespace pcl::sedr::tools {

namespace {

/** @brief Replaces invalid UTF-8 by U+FFFD. */
std::string
repaired(const std::string& text)
{
  using Json = nlohmann::json;
  return Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace))
      .get<std::string>();
}

} // namespace

std::string
hexCode(Colour colour)
{
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", colour.red, colour.green,
                colour.blue);
  return text;
}

std::string
escaped(const std::string& text)
{
  std::string html;
  for (const char c : repaired(text))
    switch (c) {
    case '&':
      html += "&amp;";
      break;
    case '<':
      html += "&lt;";
      break;
    case '>':
      html += "&gt;";
      break;
    case '"':
      html += "&quot;";
      break;
    case '\'':
      html += "&#39;";
      break;
    default: {
      const auto byte = static_cast<unsigned char>(c);
      const bool is_control = (byte < 0x20 && c != '\n' && c != '\t') || byte == 0x7f;
      html += is_control ? std::string("\xef\xbf\xbd") : std::string(1, c);
    }
    }
  return html;
}

std::string
htmlTable(const std::vector<std::string>& heads,
          const std::vector<std::vector<std::string>>& rows,
          const std::vector<bool>& is_text)
{
  const auto kindOf = [&](std::size_t column) {
    const bool text = column == 0 || (column < is_text.size() && is_text[column]);
    return text ? " class=\"text\">" : ">";
  };
  std::string html = "<div class=\"wide\"><table>\n<thead><tr>";
  for (std::size_t k = 0; k < heads.size(); ++k)
    html += std::string("<th scope=\"col\"") + kindOf(k) + heads[k] + "</th>";
  html += "</tr></thead>\n<tbody>\n";
  for (const auto& row : rows) {
    html += "<tr>";
    for (std::size_t k = 0; k < row.size(); ++k)
      html += std::string("<td") + kindOf(k) + row[k] + "</td>";
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string
htmlSection(const std::string& id, const std::string& heading, const std::string& body)
{
  return "<section id=\"" + id + "\">\n<h2>" + heading + "</h2>\n" + body +
         "</section>\n";
}

std::string
htmlPicture(const std::string& png, const std::string& caption)
{
  return "<figure><img alt=\"" + caption + "\" src=\"data:image/png;base64," +
         base64(png) + "\"><figcaption>" + caption + "</figcaption></figure>\n";
}

std::string
numberText(double value, int digits)
{
  if (!std::isfinite(value))
    return "–";
  std::string text = fixedText(value, digits);
  const std::size_t first = text[0] == '-' ? 1 : 0;
  const std::size_t point = text.find('.');
  for (std::size_t place = point == std::string::npos ? text.size() : point;
       place > first + 3;) {
    place -= 3;
    text.insert(place, "\xe2\x80\xaf"); // narrow no-break space
  }
  return text;
}

std::string
percentText(double share)
{
  const double percent = 100 * share;
  const bool is_small = percent > 0.05 && percent < 9.95;
  return numberText(percent, is_small ? 1 : 0) + "&nbsp;%";
}

std::string
base64(const std::uint8_t* bytes, std::size_t count)
{
  constexpr const char* letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((count + 2) / 3 * 4);
  for (std::size_t i = 0; i < count; i += 3) {
    const auto byteAt = [&](std::size_t k) -> std::uint32_t {
      return i + k < count ? bytes[i + k] : 0;
    };
    const std::uint32_t three = byteAt(0) << 16 | byteAt(1) << 8 | byteAt(2);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > count ? '=' : letters[three >> (18 - 6 * k) & 63];
  }
  return text;
}

std::string
base64(const std::string& bytes)
{
  return base64(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

} // namespace pcl::sedr::tools
