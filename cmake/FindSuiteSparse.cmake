# SPDX-License-Identifier: GPL-3.0-or-later
# Debian 12's SuiteSparse has neither a CMake package nor a pkg-config file.  Defines
# SuiteSparse::KLU.

find_path(SuiteSparse_INCLUDE_DIR klu.h PATH_SUFFIXES suitesparse)
set(_libraries)
foreach(_name klu amd colamd btf suitesparseconfig)
  find_library(SuiteSparse_${_name} ${_name})
  list(APPEND _libraries SuiteSparse_${_name})
endforeach()
mark_as_advanced(SuiteSparse_INCLUDE_DIR ${_libraries})

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(SuiteSparse REQUIRED_VARS SuiteSparse_INCLUDE_DIR ${_libraries}
  REASON_FAILURE_MESSAGE "install it with: apt-get install libsuitesparse-dev.")

if(SuiteSparse_FOUND AND NOT TARGET SuiteSparse::KLU)
  add_library(SuiteSparse::KLU INTERFACE IMPORTED)
  target_include_directories(SuiteSparse::KLU INTERFACE ${SuiteSparse_INCLUDE_DIR})
  foreach(_library IN LISTS _libraries)
    target_link_libraries(SuiteSparse::KLU INTERFACE ${${_library}})
  endforeach()
endif()
