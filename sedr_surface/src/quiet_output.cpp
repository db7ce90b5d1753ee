// SPDX-License-Identifier: BSD-3-Clause
#include "quiet_output.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <vector>

#include <unistd.h>

namespace pcl {
namespace sedr {
namespace {

// What multi_grid_octree_data.hpp and its neighbours print.
bool
isPoissonComplaint(const std::string& line)
{
  static const char* const beginnings[] = {
      "Vertex pair not in list",
      "Could not find vertex",
      "Bad Edge",
      "Bad Point Index",
      "[WARNING] Couldn't find root index",
      "[WARNING] Finest node does not have",
      "[WARNING] Bad average root",
      "[WARNING] Initial residual too low",
      "[WARNING] How did we leave the subtree",
      "Octree<Degree>::NonLinearSplatOrientedPoint",
      "\t(",
      "\t0",
      "\t1"};
  for (const char* beginning : beginnings)
    if (line.rfind(beginning, 0) == 0)
      return true;
  return false;
}

int
openUnnamedFile()
{
  std::error_code error;
  const auto folder = std::filesystem::temp_directory_path(error);
  if (error)
    return -1;
  const std::string path = (folder / "sedr_output_XXXXXX").string();
  std::vector<char> name(path.begin(), path.end());
  name.push_back('\0');
  const int file = ::mkstemp(name.data());
  if (file >= 0)
    ::unlink(name.data());
  return file;
}

// Passes on what is not pcl::Poisson's and counts the rest.
std::size_t
sift(const std::string& text, std::ostream& stream)
{
  std::size_t complaints = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (isPoissonComplaint(line))
      ++complaints;
    else
      stream << line << '\n';
  }
  stream.flush();
  return complaints;
}

} // namespace

QuietOutput::QuietOutput()
{
  std::cout.flush();
  std::cerr.flush();
  std::fflush(nullptr);
  out_ = divert(STDOUT_FILENO);
  err_ = divert(STDERR_FILENO);
}

QuietOutput::~QuietOutput()
{
  finish();
}

std::size_t
QuietOutput::finish()
{
  if (out_.kept >= 0 || err_.kept >= 0) {
    std::cout.flush();
    std::cerr.flush();
    std::fflush(nullptr);
    const std::string out = restore(out_);
    const std::string err = restore(err_);
    complaints_ = sift(out, std::cout) + sift(err, std::cerr);
  }
  return complaints_;
}

QuietOutput::Diversion
QuietOutput::divert(int descriptor)
{
  Diversion diversion;
  diversion.descriptor = descriptor;
  diversion.file = openUnnamedFile();
  if (diversion.file < 0)
    return diversion;
  diversion.kept = ::dup(descriptor);
  if (diversion.kept < 0 || ::dup2(diversion.file, descriptor) < 0) {
    if (diversion.kept >= 0)
      ::close(diversion.kept);
    ::close(diversion.file);
    diversion.kept = diversion.file = -1;
  }
  return diversion;
}

std::string
QuietOutput::restore(Diversion& diversion)
{
  std::string text;
  if (diversion.kept < 0)
    return text;
  ::dup2(diversion.kept, diversion.descriptor);
  ::close(diversion.kept);
  ::lseek(diversion.file, 0, SEEK_SET);
  char block[4096];
  for (ssize_t n = 0; (n = ::read(diversion.file, block, sizeof(block))) > 0;)
    text.append(block, static_cast<std::size_t>(n));
  ::close(diversion.file);
  diversion.kept = diversion.file = -1;
  return text;
}

} // namespace sedr
} // namespace pcl
