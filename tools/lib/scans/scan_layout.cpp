// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_readers.h"
#include "e57/e57_reader.h"
#include "las/las_reader.h"
#include "text/text_reader.h"
#include "tool_error.h"

namespace pcl::sedr::tools {

namespace {

/** @brief Widens coordinates of text to doubles, so that the origin is subtracted
 * before conversion to float. */
void
widenCoordinates(FileLayout& layout, const std::string& path)
{
  for (auto& field : layout.blob.fields)
    if ((field.name == "x" || field.name == "y" || field.name == "z") &&
        field.datatype == pcl::PCLPointField::FLOAT32)
      field.datatype = pcl::PCLPointField::FLOAT64;
  layOut(layout.blob, layout.blob.width, path);
}

FileLayout
decodedLayout(const std::shared_ptr<const PointReader>& reader, const std::string& path)
{
  FileLayout layout;
  layout.data = FileData::Decoded;
  layout.blob.fields = reader->fields();
  layOut(layout.blob, reader->size(), path);
  layout.reader = reader;
  const auto stations = reader->stations();
  if (stations.size() == 1) {
    layout.viewpoint = stations.front().position;
    layout.orientation = stations.front().orientation.cast<float>();
  }
  return layout;
}

} // namespace

FileLayout
readLayout(const MappedFile& file,
           const std::string& path,
           const ScanSettings& settings)
{
  if (!looksLikeE57(file) && settings.scan > 1)
    throw ToolError("'" + path +
                    "' is no E57 file and holds one scan, there is no scan " +
                    std::to_string(settings.scan));
  if (!looksLikeE57(file) && settings.skip_broken)
    throw ToolError("'" + path +
                    "' is no E57 file and holds one scan, --skip-broken has no others");
  const auto refuseColumns = [&] {
    if (!settings.columns.empty())
      throw ToolError("'" + path +
                      "' tells its columns itself, --columns names those of a text");
  };
  if (looksLikeE57(file)) {
    refuseColumns();
    return decodedLayout(
        std::make_shared<E57Reader>(file, path,
                                    E57Choice{settings.scan, settings.skip_broken}),
        path);
  }
  if (looksLikeLas(file)) {
    refuseColumns();
    return decodedLayout(openLas(file, path), path);
  }
  if (!looksLikePly(file) && !looksLikePcd(file)) {
    if (!looksLikeColumns(file))
      throw ToolError("'" + path +
                      "' is neither PCD nor PLY, E57, LAS or columns of numbers");
    return decodedLayout(std::make_shared<TextReader>(file, path, settings.columns),
                         path);
  }
  refuseColumns();
  FileLayout layout =
      looksLikePly(file) ? readPlyLayout(file, path) : readPcdLayout(file, path);
  if (layout.data == FileData::Ascii)
    widenCoordinates(layout, path);
  return layout;
}

} // namespace pcl::sedr::tools
