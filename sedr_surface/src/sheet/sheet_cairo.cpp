// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/plan/plan_geometry.h"
#include "sheet.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

namespace pcl::sedr {
namespace {

/** @brief The font of all drawings; others of the same widths follow in SVG. */
constexpr const char* font_family = "Liberation Sans";
/** @brief Half the height of a digit over the font size. */
constexpr double half_digit = 0.35;

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

cairo_status_t
append(void* text, const unsigned char* bytes, unsigned count)
{
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

void
setFont(cairo_t* cairo, double size, bool is_bold)
{
  cairo_select_font_face(cairo, font_family, CAIRO_FONT_SLANT_NORMAL,
                         is_bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, size);
}

/** @brief Draws the items of a sheet; y points down there. */
class CairoPainter {
public:
  /** @param scale device units per unit of the sheet */
  CairoPainter(cairo_surface_t* surface,
               const Sheet& sheet,
               double scale,
               bool with_texts)
      : cairo_(cairo_create(surface), &cairo_destroy)
      , top_(sheet.bottom + sheet.size.y())
      , origin_(0, top_)
      , with_texts_(with_texts)
  {
    cairo_scale(cairo_.get(), scale, scale);
    cairo_set_tolerance(cairo_.get(), 0.01 / scale);
    cairo_set_fill_rule(cairo_.get(), CAIRO_FILL_RULE_EVEN_ODD);
    cairo_set_line_join(cairo_.get(), CAIRO_LINE_JOIN_ROUND);
    // Letters are as wide at any size.
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_set_font_options(cairo_.get(), options);
    cairo_font_options_destroy(options);
  }

  ~CairoPainter() { cairo_show_page(cairo_.get()); }
  CairoPainter(const CairoPainter&) = delete;
  CairoPainter& operator=(const CairoPainter&) = delete;

  void operator()(const SheetPath& path)
  {
    for (const PlanLoop& chain : path.chains) {
      if (chain.elements.empty())
        continue;
      cairo_new_sub_path(cairo_.get());
      moveTo(chain.elements.front().start);
      for (const PlanElement& e : chain.elements)
        e.isArc() ? arcTo(e) : lineTo(e.end);
      if (path.is_closed)
        cairo_close_path(cairo_.get());
    }
    const SheetLook& look = path.look;
    if (look.fill != no_colour) {
      setColour(look.fill);
      cairo_fill_preserve(cairo_.get());
    }
    if (look.stroke != no_colour) {
      setColour(look.stroke);
      cairo_set_line_width(cairo_.get(), look.width);
      cairo_set_dash(cairo_.get(), look.dash.data(), static_cast<int>(look.dash.size()),
                     0);
      cairo_stroke_preserve(cairo_.get());
    }
    cairo_new_path(cairo_.get());
  }

  void operator()(const SheetBoxes& boxes)
  {
    setColour(boxes.fill);
    cairo_set_antialias(cairo_.get(), CAIRO_ANTIALIAS_NONE);
    for (const Eigen::AlignedBox2d& box : boxes.boxes) {
      addBox(box, 1);
      cairo_fill(cairo_.get()); // one by one: Cairo would unite them first
    }
    cairo_set_antialias(cairo_.get(), CAIRO_ANTIALIAS_DEFAULT);
  }

  void operator()(const SheetText& text)
  {
    cairo_save(cairo_.get());
    cairo_translate(cairo_.get(), text.place.x(), top_ - text.place.y());
    cairo_rotate(cairo_.get(), -text.degrees * M_PI / 180);
    const double width = text.font * textWidth(text.text, text.is_bold);
    const double left = text.anchor == TextAnchor::Start    ? 0
                        : text.anchor == TextAnchor::Middle ? -width / 2
                                                            : -width;
    const double half = half_digit * text.font;
    if (text.ground != no_colour) {
      constexpr double around = 0.15; // over the font size
      setColour(text.ground);
      cairo_rectangle(cairo_.get(), left - around * text.font,
                      -half - around * text.font, width + 2 * around * text.font,
                      2 * (half + around * text.font));
      cairo_fill(cairo_.get());
    }
    if (with_texts_) {
      setColour(text.colour);
      setFont(cairo_.get(), text.font, text.is_bold);
      cairo_move_to(cairo_.get(), left, half);
      cairo_show_text(cairo_.get(), text.text.c_str());
    }
    cairo_restore(cairo_.get());
  }

  void operator()(const SheetGroup&) {}

  void operator()(const SheetView& map)
  {
    cairo_reset_clip(cairo_.get());
    origin_ = {0, top_};
    zoom_ = 1;
    if (map.box.isEmpty())
      return;
    addBox(map.box);
    cairo_clip(cairo_.get());
    const double zoom = map.box.sizes().x() / map.view.sizes().x();
    origin_ = at(map.box.min() - zoom * map.view.min());
    zoom_ = zoom;
  }

private:
  void setColour(SheetColour colour)
  {
    cairo_set_source_rgb(cairo_.get(), ((colour >> 16) & 0xff) / 255.0,
                         ((colour >> 8) & 0xff) / 255.0, (colour & 0xff) / 255.0);
  }
  /** @brief Returns a place in the coordinates of the surface. */
  Eigen::Vector2d at(const Eigen::Vector2d& place) const
  {
    return {origin_.x() + zoom_ * place.x(), origin_.y() - zoom_ * place.y()};
  }
  void moveTo(const Eigen::Vector2d& place)
  {
    cairo_move_to(cairo_.get(), at(place).x(), at(place).y());
  }
  void lineTo(const Eigen::Vector2d& place)
  {
    cairo_line_to(cairo_.get(), at(place).x(), at(place).y());
  }
  void arcTo(const PlanElement& e)
  {
    const Eigen::Vector2d from = e.start - e.centre;
    const double start = -std::atan2(from.y(), from.x()); // as y points down
    const double sweep = -e.sweep();
    const Eigen::Vector2d centre = at(e.centre);
    (sweep < 0 ? cairo_arc_negative : cairo_arc)(
        cairo_.get(), centre.x(), centre.y(), zoom_ * e.radius, start, start + sweep);
  }
  /** @param thinnest width and height, at least */
  void addBox(const Eigen::AlignedBox2d& box, double thinnest = 0)
  {
    // By its corners: Cairo rounds sizes apart from places, and seams would be left.
    const Eigen::Vector2d low = at(box.min());
    const double right = std::max(at(box.max()).x(), low.x() + thinnest);
    const double top = std::min(at(box.max()).y(), low.y() - thinnest);
    cairo_move_to(cairo_.get(), low.x(), low.y());
    cairo_line_to(cairo_.get(), right, low.y());
    cairo_line_to(cairo_.get(), right, top);
    cairo_line_to(cairo_.get(), low.x(), top);
    cairo_close_path(cairo_.get());
  }

  Context cairo_;
  double top_;
  Eigen::Vector2d origin_; ///< of the coordinates of shapes, on the surface
  double zoom_ = 1;        ///< of these coordinates
  bool with_texts_;
};

/** @brief Throws if Cairo met an error, such as a lack of memory. */
void
finish(cairo_surface_t* surface)
{
  cairo_surface_finish(surface);
  if (cairo_surface_status(surface) != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error(cairo_status_to_string(cairo_surface_status(surface)));
}

template <typename Iterator>
void
paint(CairoPainter&& painter, Iterator first, Iterator last)
{
  std::for_each(first, last,
                [&](const Sheet::Item& item) { std::visit(painter, item); });
}

std::string
number(double value)
{
  return shortDecimalText(value, 4);
}

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

/** @brief Returns a text as an element of SVG. */
std::string
svgText(const SheetText& t, double top)
{
  constexpr const char* anchors[] = {"start", "middle", "end"};
  constexpr const char* digits = "0123456789abcdef";
  std::string colour = "#";
  for (int shift = 20; shift >= 0; shift -= 4)
    colour += digits[(t.colour >> shift) & 0xf];
  const std::string x = number(t.place.x());
  const std::string y = number(top - t.place.y());
  std::string text = "<text x=\"" + x + "\" y=\"" + y +
                     "\" dy=\"0.35em\" font-size=\"" + number(t.font) +
                     "\" text-anchor=\"" + anchors[static_cast<int>(t.anchor)] +
                     "\" fill=\"" + colour + '"';
  if (t.is_bold)
    text += " font-weight=\"bold\"";
  if (t.degrees != 0)
    text += " transform=\"rotate(" + number(-t.degrees) + ' ' + x + ' ' + y + ")\"";
  return text + '>' + escaped(t.text) + "</text>\n";
}

/** @brief Returns what Cairo draws of some items, as elements of SVG. */
template <typename Iterator>
std::string
svgShapes(const Sheet& sheet, Iterator first, Iterator last)
{
  std::string svg;
  const Surface surface(cairo_svg_surface_create_for_stream(
                            &append, &svg, sheet.size.x(), sheet.size.y()),
                        &cairo_surface_destroy);
  paint(CairoPainter(surface.get(), sheet, 1, false), first, last);
  finish(surface.get());
  // Between the group of the surface, whose number counts up, and its end.
  const std::size_t group = svg.find("<g id=\"surface");
  const std::size_t begin = svg.find('\n', group) + 1;
  const std::size_t end = svg.rfind("</g>");
  return group == std::string::npos || end < begin ? ""
                                                   : svg.substr(begin, end - begin);
}

} // namespace

void
Sheet::addLine(const SheetLook& look,
               const std::vector<Eigen::Vector2d>& places,
               bool is_closed)
{
  PlanLoop chain;
  for (std::size_t k = 0; k + 1 < places.size(); ++k)
    chain.elements.push_back(segment(places[k], places[k + 1]));
  add(SheetPath{look, {chain}, is_closed});
}

void
Sheet::addBox(const SheetLook& look, const Eigen::AlignedBox2d& box)
{
  const Eigen::Vector2d& low = box.min();
  const Eigen::Vector2d& high = box.max();
  addLine(look, {low, {high.x(), low.y()}, high, {low.x(), high.y()}}, true);
}

double
textWidth(const std::string& utf8, bool is_bold)
{
  constexpr double size = 100; // the advances of letters are rounded
  const Surface surface(cairo_recording_surface_create(CAIRO_CONTENT_ALPHA, nullptr),
                        &cairo_surface_destroy);
  const Context cairo(cairo_create(surface.get()), &cairo_destroy);
  setFont(cairo.get(), size, is_bold);
  cairo_text_extents_t extents;
  cairo_text_extents(cairo.get(), utf8.c_str(), &extents);
  return extents.x_advance / size;
}

void
loadFonts()
{
  // Fontconfig crashes where memory does not suffice: this tells before.
  constexpr std::size_t needed = std::size_t{32} << 20; // bytes
  std::vector<char> room;
  room.reserve(needed);
  *static_cast<volatile char*>(room.data()) = 0; // not optimised away
  textWidth("0", false);
  textWidth("0", true);
}

std::string
sheetSvg(const Sheet& sheet)
{
  const std::string width = number(sheet.size.x());
  const std::string height = number(sheet.size.y());
  std::string svg = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                    "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" "
                    "width=\"" +
                    width + "mm\" height=\"" + height + "mm\" viewBox=\"0 0 " + width +
                    " " + height + "\" font-family=\"" + font_family +
                    ", Arial, Helvetica, sans-serif\">\n<title>" +
                    escaped(sheet.title) + "</title>\n";
  if (!sheet.description.empty())
    svg += "<desc>" + escaped(sheet.description) + "</desc>\n";
  svg += "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
  const auto isGroup = [](const Sheet::Item& item) {
    return std::holds_alternative<SheetGroup>(item);
  };
  for (auto first = sheet.items.begin(); first != sheet.items.end();) {
    const auto last = std::find_if(first + 1, sheet.items.end(), isGroup);
    const auto* const group = std::get_if<SheetGroup>(&*first);
    svg += group && !group->name.empty() ? "<g id=\"" + group->name + "\">\n" : "<g>\n";
    svg += svgShapes(sheet, first, last);
    for (; first != last; ++first)
      if (const auto* const text = std::get_if<SheetText>(&*first))
        svg += svgText(*text, sheet.bottom + sheet.size.y());
    svg += "</g>\n";
  }
  return svg + "</svg>\n";
}

std::string
sheetPdf(const Sheet& sheet)
{
  constexpr double points = 72 / 25.4; // per millimetre
  std::string pdf;
  const Surface surface(cairo_pdf_surface_create_for_stream(&append, &pdf,
                                                            points * sheet.size.x(),
                                                            points * sheet.size.y()),
                        &cairo_surface_destroy);
  const auto set = [&](cairo_pdf_metadata_t what, const std::string& text) {
    cairo_pdf_surface_set_metadata(surface.get(), what, text.c_str());
  };
  set(CAIRO_PDF_METADATA_TITLE, sheet.title);
  set(CAIRO_PDF_METADATA_SUBJECT, sheet.description);
  set(CAIRO_PDF_METADATA_CREATE_DATE, ""); // else the bytes would differ every time
  paint(CairoPainter(surface.get(), sheet, points, true), sheet.items.begin(),
        sheet.items.end());
  finish(surface.get());
  return pdf;
}

std::string
sheetPng(const Sheet& sheet, double pixels)
{
  const auto count = [&](double length) {
    return std::max(1, static_cast<int>(std::lround(pixels * length)));
  };
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24,
                                                   count(sheet.size.x()),
                                                   count(sheet.size.y())),
                        &cairo_surface_destroy);
  const Context cairo(cairo_create(surface.get()), &cairo_destroy);
  cairo_set_source_rgb(cairo.get(), 1, 1, 1);
  cairo_paint(cairo.get());
  paint(CairoPainter(surface.get(), sheet, pixels, true), sheet.items.begin(),
        sheet.items.end());
  std::string png;
  if (cairo_surface_write_to_png_stream(surface.get(), &append, &png) !=
      CAIRO_STATUS_SUCCESS)
    throw std::runtime_error("the picture is too large");
  finish(surface.get());
  return png;
}

} // namespace pcl::sedr
