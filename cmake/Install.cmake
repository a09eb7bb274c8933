# SPDX-License-Identifier: LGPL-2.1-or-later
# What `cmake --install` puts where, in three components:
#
#   development   headers, static libraries, their CMake package PNSurfaces and pkg-config files
#   python        the modules pnkernel and pnocct
#   workbench     FreeCAD's addon
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

# Debian's Python reads this folder under /usr, and FreeCAD with it.
set(PN_PYTHON_DIR lib/python3/dist-packages CACHE STRING "Where Python modules are installed")
set(PN_ADDON_DIR share/freecad/Mod/PNSurfaces CACHE STRING "Where FreeCAD's addon is installed")
set(PN_CMAKE_DIR "${CMAKE_INSTALL_LIBDIR}/cmake/PNSurfaces")
set(PN_PKGCONFIG_DIR "${CMAKE_INSTALL_LIBDIR}/pkgconfig")

# Targets have an export set of their own each: who wants `pn` only needs no OpenCASCADE.
function(pn_install_library target)
  install(TARGETS ${target} EXPORT ${target}
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT development
    INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
  install(EXPORT ${target} NAMESPACE PNSurfaces:: FILE ${target}-targets.cmake
    DESTINATION "${PN_CMAKE_DIR}" COMPONENT development)
endfunction()

# Static libraries bring their own dependencies along, so all are public. FLINT before version 3 has
# no pkg-config file.
function(pn_install_pkgconfig)
  set(folders "${Flint_INCLUDE_DIR}" "${Flint_INCLUDE_DIR}/flint" "${Arb_INCLUDE_DIR}")
  list(REMOVE_DUPLICATES folders)
  list(TRANSFORM folders PREPEND "-I")
  list(JOIN folders " " PN_FLINT_FLAGS)
  set(libraries "")
  foreach(library IN ITEMS "${Arb_LIBRARY}" "${Flint_LIBRARY}")
    if(library)
      get_filename_component(name "${library}" NAME_WE)
      string(REGEX REPLACE "^lib" "-l" name "${name}")
      list(APPEND libraries "${name}")
    endif()
  endforeach()
  list(JOIN libraries " " PN_FLINT_LIBRARIES)
  file(RELATIVE_PATH PN_PREFIX_FROM_PC "/${PN_PKGCONFIG_DIR}" "/")
  configure_file(cmake/pnsurfaces.pc.in pnsurfaces.pc @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/pnsurfaces.pc"
    DESTINATION "${PN_PKGCONFIG_DIR}" COMPONENT development)
endfunction()

pn_install_library(pn)
pn_install_pkgconfig()
install(DIRECTORY cpp/pn DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT development
  FILES_MATCHING PATTERN "*.hpp" PATTERN occt EXCLUDE)
if(PN_WITH_OCCT)
  pn_install_library(pn_occt)
  install(DIRECTORY cpp/pn/occt DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/pn" COMPONENT development
    FILES_MATCHING PATTERN "*.hpp")
endif()

configure_package_config_file(cmake/PNSurfacesConfig.cmake.in PNSurfacesConfig.cmake
  INSTALL_DESTINATION "${PN_CMAKE_DIR}" NO_SET_AND_CHECK_MACRO)
# Before version 1.0 every minor version may change the interface.
write_basic_package_version_file(PNSurfacesConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES cmake/FindFlint.cmake
  "${PROJECT_BINARY_DIR}/PNSurfacesConfig.cmake" "${PROJECT_BINARY_DIR}/PNSurfacesConfigVersion.cmake"
  DESTINATION "${PN_CMAKE_DIR}" COMPONENT development)

if(PN_WITH_PYTHON)
  install(TARGETS pnkernel LIBRARY DESTINATION "${PN_PYTHON_DIR}" COMPONENT python)
  if(PN_WITH_OCCT)
    install(TARGETS pnocct LIBRARY DESTINATION "${PN_PYTHON_DIR}" COMPONENT python)
  endif()
endif()

install(FILES Init.py InitGui.py package.xml README.md CHANGELOG.md LICENSE
  DESTINATION "${PN_ADDON_DIR}" COMPONENT workbench)
install(DIRECTORY docs resources workbench DESTINATION "${PN_ADDON_DIR}" COMPONENT workbench
  PATTERN __pycache__ EXCLUDE)
