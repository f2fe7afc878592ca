# SPDX-License-Identifier: GPL-3.0-or-later
# Runs the generator over the declarations; sets `generated`, the list of C files it writes, and
# `generated_all`, true when they are those of every declaration in elements/ and no other.

set(generated_dir ${CMAKE_BINARY_DIR}/generated)
file(GLOB known CONFIGURE_DEPENDS elements/*.toml)
file(GLOB generator CONFIGURE_DEPENDS generator/*.py)

set(extra)
foreach(file IN LISTS HOBE_EXTRA_ELEMENTS)
  get_filename_component(file ${file} ABSOLUTE)
  if(NOT EXISTS ${file})
    message(FATAL_ERROR "HOBE_EXTRA_ELEMENTS names ${file}, which does not exist.")
  endif()
  list(APPEND extra ${file})
endforeach()

# The generator reads every declaration, since one may extend another, and writes the wanted ones.
set(declarations ${known} ${extra})
list(TRANSFORM declarations REPLACE ".*/(.*)\\.toml" "\\1" OUTPUT_VARIABLE names)
if(HOBE_ELEMENTS STREQUAL "all")
  set(wanted ${names})
else()
  foreach(name IN LISTS HOBE_ELEMENTS)
    if(NOT name IN_LIST names)
      list(JOIN names ", " names)
      message(FATAL_ERROR "HOBE_ELEMENTS names ${name}, which is none of ${names}.")
    endif()
  endforeach()
  list(TRANSFORM extra REPLACE ".*/(.*)\\.toml" "\\1" OUTPUT_VARIABLE wanted)
  list(APPEND wanted ${HOBE_ELEMENTS})
  list(REMOVE_DUPLICATES wanted)
endif()

set(generated_all FALSE)
if(HOBE_ELEMENTS STREQUAL "all" AND NOT HOBE_EXTRA_ELEMENTS)
  set(generated_all TRUE)
endif()

list(TRANSFORM wanted REPLACE "-" "_" OUTPUT_VARIABLE files)
list(TRANSFORM files PREPEND ${generated_dir}/)
list(TRANSFORM files APPEND .c)
set(generated ${files} ${generated_dir}/registry.c)

# Left-overs of declarations that are gone would be taken for fresh by the test that compares.
file(GLOB stale ${generated_dir}/*.c)
list(REMOVE_ITEM stale ${generated})
if(stale)
  file(REMOVE ${stale})
endif()

# Written anew only when it differs, so that another choice of elements runs the generator again.
set(choice ${CMAKE_BINARY_DIR}/elements.txt)
file(CONFIGURE OUTPUT ${choice} CONTENT "${declarations} ${wanted}")

# Files whose text stays the same keep their time and are not compiled again: the stamp is what
# says that the generator has run.
set(stamp ${CMAKE_BINARY_DIR}/generated.stamp)
add_custom_command(
  OUTPUT ${stamp}
  BYPRODUCTS ${generated}
  COMMAND ${CMAKE_COMMAND} -E env PYTHONPATH=${CMAKE_SOURCE_DIR} PYTHONHASHSEED=0
          ${HOBE_PYTHON} -B -m generator --out ${generated_dir} ${declarations} --only ${wanted}
  COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
  DEPENDS ${declarations} ${generator} ${choice}
  WORKING_DIRECTORY ${CMAKE_SOURCE_DIR}
  COMMENT "Generating elements"
  VERBATIM)
add_custom_target(generate DEPENDS ${stamp})
set_source_files_properties(${generated} PROPERTIES GENERATED TRUE)
