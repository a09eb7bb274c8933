# SPDX-License-Identifier: LGPL-2.1-or-later
# FLINT with ball arithmetic, as the imported target Flint::Flint.
# FLINT 3 contains Arb; before, Arb is a library of its own (Debian calls it flint-arb, upstream arb)
# and its headers lie in a folder of their own or beside those of FLINT.
find_path(Flint_INCLUDE_DIR flint/fmpq_poly.h)
find_library(Flint_LIBRARY flint)
find_path(Arb_INCLUDE_DIR acb_poly.h PATH_SUFFIXES flint arb)
find_library(Arb_LIBRARY NAMES flint-arb arb)
find_library(GMP_LIBRARY gmp)
find_library(MPFR_LIBRARY mpfr)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Flint REQUIRED_VARS Flint_LIBRARY Flint_INCLUDE_DIR Arb_INCLUDE_DIR)

if(Flint_FOUND AND NOT TARGET Flint::Flint)
  add_library(Flint::Flint INTERFACE IMPORTED)
  target_include_directories(Flint::Flint INTERFACE
    ${Flint_INCLUDE_DIR} ${Flint_INCLUDE_DIR}/flint ${Arb_INCLUDE_DIR})
  target_link_libraries(Flint::Flint INTERFACE
    $<$<BOOL:${Arb_LIBRARY}>:${Arb_LIBRARY}> ${Flint_LIBRARY} ${MPFR_LIBRARY} ${GMP_LIBRARY})
endif()
