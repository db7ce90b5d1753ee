// SPDX-License-Identifier: BSD-3-Clause
#include "picture_file.h"

#include "bytes/whole_file.h"
#include "tool_error.h"

namespace pcl::sedr::tools {

void
addPictureOption(Options& options, std::string& path)
{
  options.text("picture", path, "PNG file for a picture of what was decided");
}

void
checkPictureOutput(const std::string& path)
{
  if (path.empty())
    return;
  if (path.size() < 4 || path.compare(path.size() - 4, 4, ".png") != 0)
    throw ToolError("cannot write '" + path + "': the name of a picture ends in .png");
  checkWritable(path);
}

void
StageFiles::addOptions(Options& options)
{
  addPictureOption(options, picture);
}

void
StageFiles::check() const
{
  checkCloudOutput(output);
  checkPictureOutput(picture);
}

void
StageFiles::save(const ToolCloud& cloud) const
{
  saveCloud(output, cloud);
}

void
savePicture(const std::string& path, const Picture& picture)
{
  const std::string bytes = picture.png();
  writeWhole(path, [&](std::ostream& stream) { stream << bytes; });
}

} // namespace pcl::sedr::tools
