// SPDX-License-Identifier: BSD-3-Clause
#include "scan_files.h"

#include "bytes/whole_file.h"

#include <ostream>

namespace pcl::sedr::sim {

void
writePcd(const std::filesystem::path& path, const std::vector<ScanPoint>& points)
{
  static_assert(sizeof(ScanPoint) == 20, "a point is written as it lies in memory");
  tools::writeWhole(path.string(), [&](std::ostream& file) {
    file << "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n"
         << "FIELDS x y z label room\nSIZE 4 4 4 4 4\nTYPE F F F U U\nCOUNT 1 1 "
            "1 1 1\n"
         << "WIDTH " << points.size() << "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\n"
         << "POINTS " << points.size() << "\nDATA binary\n";
    file.write(reinterpret_cast<const char*>(points.data()),
               static_cast<std::streamsize>(points.size() * sizeof(ScanPoint)));
  });
}

void
writePositions(const std::filesystem::path& path,
               const std::vector<ScanPosition>& positions)
{
  tools::writeWhole(path.string(), [&](std::ostream& file) {
    file.precision(10);
    file << "# x y z points\n";
    for (const ScanPosition& position : positions)
      file << position.place.x() << ' ' << position.place.y() << ' '
           << position.place.z() << ' ' << position.points << '\n';
  });
}

} // namespace pcl::sedr::sim
