#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Makes HTML of doc/, with the API reference beside it. Any warning is an error.
#   doc/build.sh [--no-install] [FOLDER]      FOLDER: build/doc; open FOLDER/html/index.html
# With --no-install nothing is installed: exit code 77 where Sphinx or Doxygen is missing.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

may_install=yes
if [ "${1-}" = --no-install ]; then
  may_install=no
  shift
fi
folder=${1:-build/doc}
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)

have() { # Debian's own Python, whatever another in PATH may hold
  [ -x /usr/bin/sphinx-build ] && command -v doxygen >/dev/null &&
    /usr/bin/python3 -c 'import myst_parser' 2>/dev/null
}
if ! have && [ "$may_install" = yes ]; then
  bash tools/install_dependencies.sh --with-docs
fi
if ! have; then
  echo "Sphinx, myst-parser or Doxygen is missing: tools/install_dependencies.sh --with-docs" >&2
  exit 77
fi

/usr/bin/sphinx-build -q -E -W --keep-going -b html -d "$folder/doctrees" doc "$folder/html"
# Doxygen's settings from stdin: where to write is known here only.
(cat doc/Doxyfile && echo "OUTPUT_DIRECTORY = $folder/html") | doxygen -
echo "$folder/html/index.html"
