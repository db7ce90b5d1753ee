// SPDX-License-Identifier: BSD-3-Clause
// libFuzzer's entry point for one scan reader, FUZZED_FORMAT: any bytes must be read or
// rejected with a ToolError.
#include "formats/scan_formats.h"
#include "scan_file.h"
#include "tool_error.h"
#include "tools/scans/e57_writer.h"

#include <sys/mman.h>
#include <unistd.h>

namespace {

using namespace pcl::sedr::tools;

/** Overwrites the start with the format's magic, since most inputs would be rejected
 * without it. */
std::string
withMagic(std::string bytes)
{
  const std::string format = FUZZED_FORMAT;
  const std::string magic = format == "e57"   ? "ASTM-E57"
                            : format == "las" ? "LASF"
                            : format == "ply" ? "ply\n"
                            : format == "pcd" ? "# .PCD"
                                              : "";
  if (bytes.size() >= magic.size())
    bytes.replace(0, magic.size(), magic);
  return bytes;
}

/** Adds the checksums of an E57 file, which random changes would never match. */
std::string
sealed(const std::string& payload)
{
  using programs::E57Writer;
  std::string file;
  for (std::size_t at = 0; at < payload.size(); at += E57Writer::payload) {
    std::string page = payload.substr(at, E57Writer::payload);
    page.resize(E57Writer::payload, '\0');
    file += E57Writer::sealed(page);
  }
  return file;
}

/** A file in memory with a path. */
class MemoryFile {
public:
  explicit MemoryFile(const std::string& bytes)
      : file_(memfd_create("scan", 0))
  {
    if (file_ < 0 ||
        write(file_, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()))
      std::abort();
  }
  ~MemoryFile() { close(file_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  std::string path() const { return "/proc/self/fd/" + std::to_string(file_); }

private:
  int file_;
};

/** Reads a file as the scanner positions of another scan. */
void
readAsPositions(const std::string& path)
{
  constexpr std::size_t rows = 100;
  static const MemoryFile other("1 2 3\n");
  static const ScanFile scan(other.path());
  try {
    scan.positionsIn(path, rows);
  }
  catch (const ToolError&) {
    return;
  }
}

} // namespace

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  constexpr std::size_t max_points = 100000; // zeros of zero bits take no bytes
  std::string bytes = withMagic({reinterpret_cast<const char*>(data), size});
  const bool is_e57 = std::strcmp(FUZZED_FORMAT, "e57") == 0;
  if (is_e57)
    bytes = sealed(bytes);
  const MemoryFile file(bytes);
  const bool is_text = std::strcmp(FUZZED_FORMAT, "text") == 0;
  if (is_text)
    readAsPositions(file.path());
  try {
    ScanSettings settings;
    settings.skip_broken = is_e57 && size % 2 == 1; // others refuse it
    settings.piece_bytes = 4096;
    settings.unit = size % 5 == 1 ? 0.001 : 1;
    if (is_text && size % 3 == 1)
      settings.columns = "z,_,x,y";
    if (openScan(file.path(), settings).points->size() > max_points)
      return 0;
    const ScanFile scan(file.path(), settings);
    scan.positions();
    unsigned sum = 0;
    scan.forEachPiece([&](const pcl::sedr::RowSource::Piece& piece) {
      for (std::size_t i = 0; i < piece.size * scan.rowSize(); ++i)
        sum += piece.rows[i];
      return true;
    });
    static volatile unsigned seen;
    seen = sum; // every byte was read
  }
  catch (const ToolError&) {
    return 0;
  }
  return 0;
}
