// SPDX-License-Identifier: BSD-3-Clause
#include "csv_line.h"

#include <stdexcept>

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

std::vector<std::string>
splitCells(const std::string& line)
{
  std::vector<std::string> cells(1);
  bool in_quotes = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool is_quote = line[i] == '"';
    if (is_quote && in_quotes && i + 1 < line.size() && line[i + 1] == '"')
      cells.back() += line[++i];
    else if (is_quote)
      in_quotes = !in_quotes;
    else if (line[i] == ',' && !in_quotes)
      cells.emplace_back();
    else
      cells.back() += line[i];
  }
  if (in_quotes)
    throw std::invalid_argument("a quote in cell " + std::to_string(cells.size()) +
                                " is not closed");
  return cells;
}

} // namespace pcl::sedr::benchmark
