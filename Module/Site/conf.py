# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Sphinx's configuration of the site, which Module/docs.sh builds."""

import os

project = "Relevo"
copyright = "The Relevo developers"  # noqa: A001, Sphinx's name
release = version = os.environ["RELEVO_VERSION"]

extensions = ["myst_parser"]
source_suffix = {".md": "markdown", ".rst": "restructuredtext"}
myst_heading_anchors = 6  # those of GitHub
smartquotes = False  # quotes are those of code
nitpicky = False  # classes of VTK have no pages here
toc_object_entries = False  # the list of contents would have all methods
add_module_names = False
python_use_unqualified_type_names = True

html_theme = "furo"
html_title = f"Relevo {release}"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_copy_source = False
html_show_sphinx = False
html_theme_options = {"navigation_with_keys": True}
