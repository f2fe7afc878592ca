# SPDX-License-Identifier: GPL-3.0-or-later
# Debian 12's gmsh has neither a CMake package nor a pkg-config file.  Defines Gmsh_INCLUDE_DIR and
# Gmsh_SONAME, the library's file name with its version, as dlopen takes it.

find_path(Gmsh_INCLUDE_DIR gmshc.h)
find_library(Gmsh_LIBRARY gmsh)
mark_as_advanced(Gmsh_INCLUDE_DIR Gmsh_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Gmsh REQUIRED_VARS Gmsh_INCLUDE_DIR Gmsh_LIBRARY
  REASON_FAILURE_MESSAGE "install it with: apt-get install libgmsh-dev.")

if(Gmsh_FOUND)
  get_filename_component(Gmsh_SONAME "${Gmsh_LIBRARY}" REALPATH)
  get_filename_component(Gmsh_SONAME "${Gmsh_SONAME}" NAME)
endif()
