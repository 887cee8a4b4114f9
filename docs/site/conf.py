# Sphinx, for the tree that build.py puts together.
project = "subcert"
author = ""
copyright = ""
version = release = "@VERSION@"
extensions = ["myst_parser", "sphinx.ext.autodoc"]
exclude_patterns = ["_extra", ".doctrees"]
myst_heading_anchors = 6
highlight_language = "none"
html_theme = "furo"
html_title = "subcert"
html_static_path = ["_static"]
html_extra_path = ["_extra"]
html_css_files = ["site.css"]
html_copy_source = False
html_show_copyright = False
html_show_sphinx = False
html_theme_options = {"top_of_page_button": None}
