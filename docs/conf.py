"""How Sphinx builds the manual: every cell is executed, nothing is taken from the network."""

from __future__ import annotations

import logging
import os
import shutil
import sys
from pathlib import Path

from nbclient import NotebookClient

import chasles

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE / "_extensions"))

project = "chasles"
version = release = chasles.__version__
project_copyright = "The chasles authors"

extensions = ["sphinx.ext.autodoc", "sphinx.ext.napoleon", "myst_nb", "links", "mathml"]
exclude_patterns = ["_build", "_extensions"]
nitpicky = True
# Types that have no page of their own: those of other libraries, and of the rooms behind the public names.
nitpick_ignore_regex = [("py:.*", r"(?!chasles\.(prove|solve|compile|load|kernels|checked)$).*")]

html_theme = "furo"
html_title = "chasles"
html_math_renderer = "mathml"
html_static_path = ["_static"]
html_css_files = ["manual.css"]
html_copy_source = False
html_show_sphinx = False

myst_enable_extensions = ["dollarmath", "deflist"]
myst_heading_anchors = 3

nb_execution_mode = "force"
nb_execution_raise_on_error = True
nb_execution_timeout = 300
nb_execution_in_temp = True
nb_execution_show_tb = True
nb_merge_streams = True
nb_render_markdown_format = "myst"

autodoc_typehints = "signature"
autodoc_member_order = "bysource"
napoleon_google_docstring = True
default_role = "code"

# Who executes a page need not be told of each.
logging.getLogger("traitlets").setLevel(logging.WARNING)
# What a command prints arrives in pieces, which do not end where lines do.
NotebookClient.coalesce_streams = True

# Cells run commands as a reader would: found beside this Python, without colours, remembering nothing, stopping where
# one of them fails. What they compile is not optimised, which takes a third of the time.
COMPILER = shutil.which("cc")
FIRST = [HERE / "_extensions" / "tools"] if COMPILER and os.name == "posix" else []
os.environ |= {
    "PATH": os.pathsep.join(map(str, (*FIRST, Path(sys.executable).parent, os.environ["PATH"]))),
    "COMPILER": COMPILER or "",
    "NO_COLOR": "1",
    "COLUMNS": "88",
    "PYTHONIOENCODING": "utf-8",
    "CHASLES_CACHE": "",
    "CHECKOUT": str(HERE.parent),
    "CMAKE_GENERATOR": "Ninja",
    "BASH_ENV": str(HERE / "_extensions" / "cells.sh"),
}
