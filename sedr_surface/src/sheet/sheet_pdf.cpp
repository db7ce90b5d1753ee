// SPDX-License-Identifier: BSD-3-Clause
#include "../formats/decimal_text.h"
#include "letter_widths.h"
#include "sheet.h"
#include "sheet_looks.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl::sedr {
namespace {

constexpr double points_per_mm = 72 / 25.4;

std::string
number(double value)
{
  return shortDecimalText(value, 4);
}

std::string
at(const Eigen::Vector2d& p)
{
  return number(p.x()) + " " + number(p.y());
}

/** @brief Returns a colour and its use: "0.5 0.5 0.5 rg". */
std::string
colourText(SheetColour colour, const char* use)
{
  std::string text;
  for (const int shift : {16, 8, 0})
    text += shortDecimalText(((colour >> shift) & 0xff) / 255.0, 3) + " ";
  return text + use + "\n";
}

/** @brief Returns a text in brackets, one byte per letter in WinAnsi, which practically
 * equals Unicode up to 255. */
std::string
stringText(const std::string& utf8)
{
  std::string text = "(";
  for (const char32_t letter : lettersOf(utf8)) {
    const bool is_there = (letter >= U' ' && letter <= U'~') ||
                          (letter >= U'\u00a0' && letter <= U'\u00ff');
    const char byte = is_there ? static_cast<char>(letter) : '?';
    if (byte == '(' || byte == ')' || byte == '\\')
      text += '\\';
    text += byte;
  }
  return text + ")";
}

/** @brief Writes the items of a sheet as operators of a page with millimetre units. */
class PdfWriter {
public:
  void operator()(const SheetPath& path)
  {
    const SheetLook& look = lookNamed(sheet_looks, path.look);
    const bool is_filled = look.fill != no_colour;
    const bool is_drawn = look.stroke != no_colour;
    if (is_filled)
      text += colourText(look.fill, "rg");
    if (is_drawn) {
      text += colourText(look.stroke, "RG") + number(look.width) + " w [";
      for (const double length : look.dash)
        if (length > 0)
          text += " " + number(length);
      text += "] 0 d\n";
    }
    for (const PlanLoop& chain : path.chains) {
      if (chain.elements.empty())
        continue;
      text += at(chain.elements.front().start) + " m\n";
      for (const PlanElement& e : chain.elements)
        writeElement(e);
      text += path.is_closed ? "h\n" : "";
    }
    text += is_filled && is_drawn ? "B*\n" : is_filled ? "f*\n" : "S\n";
  }

  void operator()(const SheetText& t)
  {
    const double turn = t.degrees * M_PI / 180;
    const Eigen::Vector2d way(std::cos(turn), std::sin(turn));
    const Eigen::Vector2d up(-way.y(), way.x());
    const double half_width =
        t.anchor == TextAnchor::Middle ? t.font * textWidth(t.text) / 2 : 0;
    const Eigen::Vector2d start = t.place - half_width * way - 0.35 * t.font * up;
    const auto write = [&](int mode) {
      text += "BT /F1 " + number(t.font) + " Tf " + std::to_string(mode) + " Tr " +
              at(way) + " " + at(up) + " " + at(start) + " Tm " + stringText(t.text) +
              " Tj ET\n";
    };
    constexpr int fill = 0;
    constexpr int stroke = 1;
    if (t.has_halo) {
      text += colourText(room_colour, "RG") + "0.8 w [] 0 d 1 j\n";
      write(stroke);
      text += "0 j\n";
    }
    text += colourText(lookNamed(text_looks, t.look).colour, "rg");
    write(fill);
  }

  void operator()(const SheetGroup&) {}

  std::string text;

private:
  /** @brief Writes arcs as cubic curves of at most 30 degrees, accurate to a millionth
   * of the radius. */
  void writeElement(const PlanElement& e)
  {
    if (!e.isArc()) {
      text += at(e.end) + " l\n";
      return;
    }
    constexpr double widest = M_PI / 6;
    const auto n = static_cast<int>(std::ceil(std::abs(e.sweep()) / widest - 1e-9));
    const double step = e.sweep() / n;
    const double handle = 4.0 / 3 * std::tan(step / 4);
    const Eigen::Vector2d first = e.start - e.centre;
    for (int k = 0; k < n; ++k) {
      const Eigen::Vector2d a = Eigen::Rotation2Dd(k * step) * first;
      const Eigen::Vector2d b = Eigen::Rotation2Dd((k + 1) * step) * first;
      const Eigen::Vector2d from =
          e.centre + a + handle * Eigen::Vector2d(-a.y(), a.x());
      const Eigen::Vector2d to = e.centre + b - handle * Eigen::Vector2d(-b.y(), b.x());
      text += at(from) + " " + at(to) + " " + at(e.centre + b) + " c\n";
    }
  }
};

} // namespace

std::string
sheetPdf(const Sheet& sheet)
{
  PdfWriter writer;
  const std::string unit = shortDecimalText(points_per_mm, 8);
  writer.text = unit + " 0 0 " + unit + " 0 0 cm\n";
  for (const auto& item : sheet.items)
    std::visit(writer, item);
  const Eigen::Vector2d size = sheet.size * points_per_mm;
  const std::vector<std::string> objects{
      "<< /Type /Catalog /Pages 2 0 R >>",
      "<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
      "<< /Type /Page /Parent 2 0 R /MediaBox [0 0 " + at(size) +
          "] /Contents 4 0 R /Resources << /Font << /F1 5 0 R >> >> >>",
      "<< /Length " + std::to_string(writer.text.size()) + " >>\nstream\n" +
          writer.text + "\nendstream",
      "<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding "
      ">>",
      "<< /Title " + stringText(sheet.title) + " /Subject " +
          stringText(sheet.description) + " >>"};
  std::string file = "%PDF-1.4\n%\xe2\xe3\xcf\xd3\n"; // marks the file as binary
  std::string table = "0000000000 65535 f \n";
  for (std::size_t k = 0; k < objects.size(); ++k) {
    const std::string offset = std::to_string(file.size());
    table += std::string(10 - std::min<std::size_t>(10, offset.size()), '0') + offset +
             " 00000 n \n";
    file += std::to_string(k + 1) + " 0 obj\n" + objects[k] + "\nendobj\n";
  }
  const std::string count = std::to_string(objects.size() + 1);
  const std::string start = std::to_string(file.size());
  return file + "xref\n0 " + count + "\n" + table + "trailer\n<< /Size " + count +
         " /Root 1 0 R /Info 6 0 R >>\nstartxref\n" + start + "\n%%EOF\n";
}

} // namespace pcl::sedr
