// SPDX-License-Identifier: BSD-3-Clause
#include "histogram_svg.h"

#include "html_text.h"
#include "results/distance_colour.h"
#include "scale.h"

#include <algorithm>

namespace pcl::sedr::tools {

namespace {

// User units of the drawing.
constexpr double width = 640;
constexpr double height = 300;
constexpr double left = 52;
constexpr double right = 12;
constexpr double top = 14;
constexpr double bottom = 50;
constexpr double base = height - bottom;

std::string
number(double value)
{
  return fixedText(value, 2);
}

std::string
textAt(double x, double y, const char* anchor, const std::string& text)
{
  return "<text class=\"axis\" x=\"" + number(x) + "\" y=\"" + number(y) +
         "\" text-anchor=\"" + anchor + "\">" + text + "</text>\n";
}

} // namespace

std::string
histogramSvg(const DistanceStatistics& distances, double range)
{
  if (distances.histogram.empty() || distances.count == 0 ||
      !(distances.histogram_range > 0))
    return "";
  const auto share = [&](std::size_t count) {
    return static_cast<double>(count) / static_cast<double>(distances.count);
  };
  const std::size_t bins = distances.histogram.size();
  double most = share(distances.beyond_histogram);
  for (const auto count : distances.histogram)
    most = std::max(most, share(count));
  const double step = roundStep(std::max(most, 1e-4) / 2); // at least two grid lines
  const double max_shown = std::max(most, step);
  const double slot = (width - left - right) / (static_cast<double>(bins) + 2);
  const auto heightOf = [&](double s) { return (base - top) * s / max_shown; };

  std::string svg = "<svg class=\"chart\" role=\"img\" aria-label=\"Histogram of "
                    "distances from the model\" viewBox=\"0 0 " +
                    number(width) + " " + number(height) + "\">\n";
  for (double s = 0; s <= max_shown * 1.0001; s += step) {
    const double y = base - heightOf(s);
    svg +=
        "<line class=\"grid\" x1=\"" + number(left) + "\" x2=\"" +
        number(width - right) + "\" y1=\"" + number(y) + "\" y2=\"" + number(y) +
        "\"/>\n" +
        textAt(left - 6, y + 4, "end", fixedText(100 * s, digitsOf(100 * step)) + " %");
  }
  const auto addBar = [&](double x, double s, double distance,
                          const std::string& what) {
    svg += "<rect x=\"" + number(x + 0.06 * slot) + "\" y=\"" +
           number(base - heightOf(s)) + "\" width=\"" + number(0.88 * slot) +
           "\" height=\"" + number(heightOf(s)) + "\" fill=\"" +
           hexCode(distanceColour(distance, range)) + "\"><title>" + what + ": " +
           fixedText(100 * s, 2) + " %</title></rect>\n";
  };
  const double bin = distances.histogram_range / static_cast<double>(bins);
  for (std::size_t k = 0; k < bins; ++k) {
    const double low = bin * static_cast<double>(k);
    addBar(left + slot * static_cast<double>(k), share(distances.histogram[k]),
           low + bin / 2, distanceText(low) + " to " + distanceText(low + bin));
  }
  const double beyond = left + slot * (static_cast<double>(bins) + 0.8);
  addBar(beyond, share(distances.beyond_histogram), distances.histogram_range,
         distanceText(distances.histogram_range) + " or more");
  const double tick = roundStep(distances.histogram_range / 4);
  for (double d = 0; d < distances.histogram_range * 0.999; d += tick)
    svg += textAt(left + slot * d / bin, base + 18, "middle",
                  fixedText(100 * d, digitsOf(100 * tick)));
  svg += textAt(beyond + slot / 2, base + 18, "middle", "more");
  svg += textAt((left + width - right) / 2, height - 10, "middle",
                "distance from the model, cm");
  return svg + "</svg>\n";
}

} // namespace pcl::sedr::tools
