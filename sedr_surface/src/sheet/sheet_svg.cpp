// SPDX-License-Identifier: BSD-3-Clause
#include "../formats/decimal_text.h"
#include "sheet.h"
#include "sheet_looks.h"

#include <cmath>

namespace pcl::sedr {
namespace {

/** @brief Formats a length on paper, millimetres. */
std::string
mm(double value)
{
  return shortDecimalText(value, 4);
}

/** @brief Escapes a text for XML; control characters become blanks. */
std::string
escaped(const std::string& text)
{
  std::string result;
  for (const char c : text)
    result += c == '&'   ? "&amp;"
              : c == '<' ? "&lt;"
                         : std::string(1, c >= 0 && c < ' ' ? ' ' : c);
  return result;
}

std::string
colourText(SheetColour colour)
{
  if (colour == no_colour)
    return "none";
  constexpr const char* digits = "0123456789abcdef";
  std::string text = "#";
  for (int shift = 20; shift >= 0; shift -= 4)
    text += digits[(colour >> shift) & 0xf];
  return text;
}

std::string
styleSheet()
{
  std::string style = "text { font-family: Helvetica, Arial, 'Liberation Sans', "
                      "'DejaVu Sans', sans-serif; text-anchor: middle; }\n"
                      ".start { text-anchor: start; }\n";
  for (const SheetLook& look : sheet_looks) {
    style += std::string(".") + look.name + " { fill: " + colourText(look.fill) +
             "; fill-rule: evenodd; stroke: " + colourText(look.stroke);
    if (look.stroke != no_colour)
      style += "; stroke-width: " + mm(look.width);
    if (look.dash[0] > 0) {
      style += "; stroke-dasharray:";
      for (const double length : look.dash)
        if (length > 0)
          style += " " + mm(length);
    }
    style += "; }\n";
  }
  for (const TextLook& look : text_looks)
    style += std::string("text.") + look.name + " { fill: " + colourText(look.colour) +
             "; stroke: none; }\n";
  return style + "text.halo { paint-order: stroke; stroke: " + colourText(room_colour) +
         "; stroke-width: 0.8; stroke-linejoin: round; }\n";
}

/** @brief Writes the items of a sheet; y points down in SVG. */
class SvgWriter {
public:
  explicit SvgWriter(double height)
      : height_(height)
  {}

  void operator()(const SheetPath& path)
  {
    std::string d;
    for (const PlanLoop& chain : path.chains) {
      if (chain.elements.empty())
        continue;
      d += (d.empty() ? "M " : " M ") + at(chain.elements.front().start);
      for (const PlanElement& e : chain.elements)
        d += " " + pathTo(e);
      d += path.is_closed ? " Z" : "";
    }
    text += "<path class=\"" + path.look + "\" d=\"" + d + "\"/>\n";
  }

  void operator()(const SheetText& t)
  {
    const double y = height_ - t.place.y();
    text += "<text class=\"" + t.look + (t.has_halo ? " halo" : "") +
            (t.anchor == TextAnchor::Start ? " start" : "") + "\" x=\"" +
            mm(t.place.x()) + "\" y=\"" + mm(y) + "\" dy=\"0.35em\" font-size=\"" +
            mm(t.font) + '"';
    if (t.degrees != 0)
      text += " transform=\"rotate(" + mm(-t.degrees) + ' ' + mm(t.place.x()) + ' ' +
              mm(y) + ")\"";
    text += '>' + escaped(t.text) + "</text>\n";
  }

  void operator()(const SheetGroup& group)
  {
    text += group.name.empty() ? "</g>\n" : "<g id=\"" + group.name + "\">\n";
  }

  std::string text;

private:
  std::string at(const Eigen::Vector2d& p) const
  {
    return mm(p.x()) + " " + mm(height_ - p.y());
  }

  /** @brief Returns the path of an element from the current point, its start. */
  std::string pathTo(const PlanElement& e) const
  {
    if (!e.isArc())
      return "L " + at(e.end);
    const double sweep = e.sweep();
    const std::string radius = mm(e.radius);
    const auto arcTo = [&](const Eigen::Vector2d& end, double turn) {
      return "A " + radius + " " + radius + " 0 " +
             (std::abs(turn) > M_PI ? "1" : "0") + (turn > 0 ? " 0 " : " 1 ") + at(end);
    };
    if (std::abs(sweep) < 1.9 * M_PI)
      return arcTo(e.end, sweep);
    // An arc with equal ends is ambiguous, so a circle is written as two halves.
    return arcTo(e.pointAt(e.length() / 2), sweep / 2) + " " + arcTo(e.end, sweep / 2);
  }

  double height_;
};

} // namespace

std::string
sheetSvg(const Sheet& sheet)
{
  const std::string width = mm(sheet.size.x());
  const std::string height = mm(sheet.size.y());
  SvgWriter writer(sheet.size.y());
  writer.text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"" +
                width + "mm\" height=\"" + height + "mm\" viewBox=\"0 0 " + width +
                " " + height + "\">\n<title>" + escaped(sheet.title) + "</title>\n";
  if (!sheet.description.empty())
    writer.text += "<desc>" + escaped(sheet.description) + "</desc>\n";
  writer.text += "<style>\n" + styleSheet() + "</style>\n" +
                 "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
  for (const auto& item : sheet.items)
    std::visit(writer, item);
  return writer.text + "</svg>\n";
}

} // namespace pcl::sedr
