# Sphinx's settings of the site; build.py passes the paths.
import logging
import os
import re
import sys

from breathe.renderer.sphinxrenderer import SphinxRenderer

work = os.environ["LIBRATION_WORK"]
sys.path.insert(0, os.path.join(os.environ["LIBRATION_ROOT"], "python"))

project = "Libration"
author = "the authors of Libration"
version = release = os.environ["LIBRATION_VERSION"]
extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.mathjax", "breathe"]
root_doc = "index"
smartquotes = False  # x'' is a derivative

myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4
myst_update_mathjax = False

html_theme = "furo"
html_title = f"Libration {version}"
html_static_path = [os.path.join(work, "static")]
html_css_files = ["site.css"]
html_show_sphinx = False
html_show_copyright = False
html_copy_source = False
html_show_sourcelink = False

# Formulas as drawings: no fonts, no network.
mathjax_path = "mathjax/MathJax.js"
mathjax2_config = {
    "config": ["TeX-AMS_SVG.js"],
    "showMathMenu": False,
    "messageStyle": "none",
    "displayAlign": "left",
    "tex2jax": {"ignoreClass": "tex2jax_ignore|mathjax_ignore", "processClass": "tex2jax_process|mathjax_process|math"},
    "SVG": {"linebreaks": {"automatic": True, "width": "container"}, "scale": 95},
}

breathe_projects = {"libration": os.path.join(work, "doxygen", "xml")}
breathe_default_project = "libration"
# The compiled half of the package is not needed to read its words.
autodoc_mock_imports = ["libration._libration"]
autodoc_member_order = "bysource"
autodoc_typehints = "signature"


def docstring_as_meant(app, what, name, object, options, lines):
    """|x| is an absolute value, not a substitution of reStructuredText, and an indented block is code."""
    said, above = [], ""
    for line in lines:
        if line.startswith("    ") and above and not above.startswith("    ") and not said[-1]:
            said += ["::", ""]
        above = line or above
        said.append(line.replace("|", "\\|") if not line.startswith("    ") else line)
    lines[:] = said


def target_unless_namespace(renderer, node):
    return [] if getattr(node, "kind", "") == "namespace" else renderer.target_handler.create_target(renderer.get_refid(node.id))


class NamespacesAgain(logging.Filter):
    """Many headers open the same namespaces, which Breathe shows again and Sphinx takes for a mistake."""

    def filter(self, record):
        said = record.getMessage() if isinstance(record.msg, str) else str(record.msg)
        return not re.search(r"Duplicate C\+\+ declaration(?s:.*)cpp:type:: \w+'", said)


SphinxRenderer.create_doxygen_target = target_unless_namespace
logging.getLogger("sphinx.sphinx.domains.cpp").addFilter(NamespacesAgain())


def setup(app):
    app.connect("autodoc-process-docstring", docstring_as_meant)
