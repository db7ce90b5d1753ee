// SPDX-License-Identifier: BSD-3-Clause
#include "csv_line.h"

namespace pcl::sedr::benchmark {

namespace {

std::string
quoted(const std::string& cell)
{
  std::string text = "\"";
  for (const char c : cell)
    text += c == '"' ? "\"\"" : std::string(1, c);
  return text + "\"";
}

std::string
onOneLine(std::string cell)
{
  for (char& c : cell)
    if (c == '\n' || c == '\r')
      c = ' ';
  return cell;
}

} // namespace

std::string
joinCells(const std::vector<std::string>& cells)
{
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string cell = onOneLine(cells[i]);
    line += i == 0 ? "" : ",";
    line += cell.find_first_of(",\"") == std::string::npos ? cell : quoted(cell);
  }
  return line;
}

} // namespace pcl::sedr::benchmark
