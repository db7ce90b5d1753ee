# SPDX-License-Identifier: BSD-3-Clause
# Sphinx builds doc/ into HTML by this file: see build.sh.
project = "SEDR for PCL"
author = "the SEDR authors"
copyright = "the SEDR authors, BSD-3-Clause"

extensions = ["myst_parser"]
source_suffix = {".rst": "restructuredtext", ".md": "markdown"}
exclude_patterns = ["tutorials/sources"]
myst_heading_anchors = 3

html_theme = "alabaster"
html_theme_options = {
    "description": "Structural elements of indoor laser scans",
    "page_width": "1100px",
    "sidebar_width": "260px",
    "sidebar_includehidden": False,
}
html_static_path = ["static"]
html_css_files = ["pages.css"]
html_show_sphinx = False
highlight_language = "none"
