# SPDX-License-Identifier: BSD-3-Clause
# Sphinx with MyST, the theme of the site and matplotlib for its charts, as modules of Python 3; the site's formulas want
# Debian's MathJax.
find_program(Python3_EXECUTABLE python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_package(Python3 QUIET COMPONENTS Interpreter)
set(Sphinx_VERSION "")
if(Python3_EXECUTABLE)
  execute_process(COMMAND ${Python3_EXECUTABLE} -c
    "import sphinx, myst_parser, sphinx_rtd_theme, matplotlib; print(sphinx.__version__)"
    OUTPUT_VARIABLE Sphinx_VERSION OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_VARIABLE sphinx_error)
endif()
if(Sphinx_VERSION AND NOT EXISTS /usr/share/javascript/mathjax/MathJax.js)
  set(Sphinx_VERSION "")
  set(sphinx_error "no MathJax")
endif()
set(Sphinx_NOT_FOUND_MESSAGE "the site wants python3-sphinx, python3-myst-parser, python3-sphinx-rtd-theme, \
python3-matplotlib and libjs-mathjax of Debian (scripts/setup installs them)")
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Sphinx REQUIRED_VARS Python3_EXECUTABLE Sphinx_VERSION VERSION_VAR Sphinx_VERSION)
