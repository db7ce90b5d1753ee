// SPDX-License-Identifier: BSD-3-Clause
#include "html_text.h"
#include "page_sections.h"

namespace pcl::sedr::tools {

namespace {

/** @brief Formats a coordinate: "-0.30". */
std::string
coordinate(double metres)
{
  return (metres < 0 ? "−" : "") + numberText(metres < 0 ? -metres : metres, 1);
}

std::string
gapTable(const std::vector<GapFacts>& gaps)
{
  std::vector<std::vector<std::string>> rows;
  for (const GapFacts& gap : gaps)
    rows.push_back({escaped(gap.reason), numberText(gap.area, 1),
                    coordinate(gap.x) + ", " + coordinate(gap.y),
                    coordinate(gap.floor) + " to " + coordinate(gap.ceiling),
                    gap.counts ? "yes" : "no"});
  return htmlTable({"left out", "area, m²", "around x, y, m", "z, m", "counts"}, rows,
                   {true, false, false, false, true});
}

} // namespace

std::string
coveragePart(const ReportData& data)
{
  if (!data.coverage)
    return "";
  const CoverageFacts& coverage = *data.coverage;
  std::string html = "<p>" + numberText(coverage.modelled, 1) + "&nbsp;m² of " +
                     numberText(coverage.seen, 1) +
                     "&nbsp;m² of floor that was seen are in the plan, <strong>" +
                     percentText(coverage.share) + "</strong>.</p>\n";
  if (!coverage.left_out.empty())
    html +=
        gapTable(coverage.left_out) +
        "<p class=\"note\">What counts is floor to stand on inside the building. "
        "What has no headroom or no walls around it does not: cavities, and what was "
        "seen outdoors or through glass.</p>\n";
  return htmlSection("coverage", "What was modelled", html);
}

} // namespace pcl::sedr::tools
