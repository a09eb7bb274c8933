# SPDX-License-Identifier: LGPL-2.1-or-later
# A Debian package for each component of Install.cmake; scripts/package makes them. They hold no
# library of others, those are Debian's.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_DIRECTORY "${PROJECT_BINARY_DIR}/packages")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL development python workbench)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_CONTACT "PN Surfaces <noreply@example.org>")
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS OFF)

# The package of a component: its name, section, what it depends on, and its description, the first
# line of which is the synopsis.
macro(pn_package component name section depends description)
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name})
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section})
  set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "${depends}")
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${description}")
  install(FILES cmake/copyright DESTINATION share/doc/${name} COMPONENT ${component})
endmacro()

pn_package(development libpnsurfaces-dev libdevel
  "libflint-dev, libflint-arb-dev, libeigen3-dev, libtbb-dev"
  "Exact rational offset surfaces as B-splines (development files)
Headers, static libraries, CMake and pkg-config files.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS
  "libocct-modeling-algorithms-dev, libocct-data-exchange-dev, libocct-ocaf-dev, libocct-visualization-dev")

# Compiled modules are made for one minor version of Python.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
math(EXPR next_minor "${Python3_VERSION_MINOR} + 1")
pn_package(python python3-pnkernel python
  "python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${next_minor}), python3-numpy"
  "Exact rational offset surfaces as B-splines (Python modules)
The modules pnkernel, for surfaces, and pnocct, for shapes and STEP files.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)

pn_package(workbench freecad-pnsurfaces science
  "freecad (>= 0.20), python3-pnkernel (>= ${PROJECT_VERSION})"
  "Exact rational offset surfaces as B-splines (FreeCAD workbench)
Pipes of varying radius, ruled surfaces, quadrics and skins of mid-surfaces,
and their offsets, as B-splines that are no fits.")
set(CPACK_DEBIAN_WORKBENCH_PACKAGE_ARCHITECTURE all)

include(CPack)
