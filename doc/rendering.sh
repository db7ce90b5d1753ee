# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash
# Sourced by the scripts of doc/ that draw in perspective.

# render SCRIPT ARGUMENTS...: runs a Python script that renders with VTK, without anyone at the screen;
# says what is missing and leaves the pictures as they are where a package is missing.
render() {
  local package missing=()
  for package in python3-numpy python3-matplotlib python3-vtk9 python3-pil xvfb xauth; do
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)" = installed ] || missing+=("$package")
  done
  if [ ${#missing[@]} -gt 0 ]; then
    echo "The renderings stay as they are: they need the Debian packages ${missing[*]}."
    return 0
  fi
  xvfb-run -a -s "-screen 0 1600x1200x24" /usr/bin/python3 "$@"
}
