// SPDX-License-Identifier: BSD-3-Clause
#include "window.h"

#include "tool_error.h"

#include <X11/Xlib.h>

#include <cstdlib>
#include <memory>
#include <string>

namespace pcl::sedr::tools {

namespace {

constexpr const char* remedy =
    "; without a screen, start it as: xvfb-run pcl_sedr_viewer ... --screenshot FILE";

} // namespace

void
requireDisplay()
{
  const char* name = std::getenv("DISPLAY");
  if (!name || *name == '\0')
    throw ToolError(std::string("there is no display: DISPLAY is not set") + remedy);
  const std::unique_ptr<Display, int (*)(Display*)> display(XOpenDisplay(nullptr),
                                                            XCloseDisplay);
  if (!display)
    throw ToolError("there is no display: no X server answers at DISPLAY '" +
                    std::string(name) + "'" + remedy);
  int opcode = 0;
  int event = 0;
  int error = 0;
  if (!XQueryExtension(display.get(), "GLX", &opcode, &event, &error))
    throw ToolError("the X server at DISPLAY '" + std::string(name) +
                    "' has no GLX, so it cannot draw in three dimensions" + remedy);
}

} // namespace pcl::sedr::tools
