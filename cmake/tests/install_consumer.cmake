# SPDX-License-Identifier: BSD-3-Clause
# Installs the build, moves the tree elsewhere, and builds and runs the consumer against it, as found by find_package
# and as found by pkg-config. Needs -D: BUILD_DIR, SOURCE_DIR (of the consumer), WORK_DIR, VERSION, C_COMPILER, C_FLAGS,
# LIBDIR, BINDIR, DOCDIR, PROGRAM (TRUE where the program was built).
cmake_minimum_required(VERSION 3.25)

function(run output)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE text ERROR_VARIABLE errors RESULT_VARIABLE status
                  OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\nended with ${status}\n${text}\n${errors}")
  endif()
  set(${output} "${text}" PARENT_SCOPE)
endfunction()

function(expect_equal what found expected)
  if(NOT found STREQUAL expected)
    message(FATAL_ERROR "${what}: found '${found}', expected '${expected}'")
  endif()
  message("${what}: ${found}")
endfunction()

file(REMOVE_RECURSE "${WORK_DIR}")
file(MAKE_DIRECTORY "${WORK_DIR}/pkgconfig")
run(ignored "${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${WORK_DIR}/first")
file(RENAME "${WORK_DIR}/first" "${WORK_DIR}/moved")
set(prefix "${WORK_DIR}/moved")
set(plugin "${prefix}/${LIBDIR}/cagewright/cagewright_plugin.so")
set(greeting "cagewright ${VERSION}, ABI 1")

# By find_package.
run(ignored "${CMAKE_COMMAND}" -S "${SOURCE_DIR}" -B "${WORK_DIR}/cmake" "-DCMAKE_PREFIX_PATH=${prefix}"
    "-DCMAKE_C_COMPILER=${C_COMPILER}" "-DCMAKE_C_FLAGS=${C_FLAGS}" -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)
run(ignored "${CMAKE_COMMAND}" --build "${WORK_DIR}/cmake")
file(READ "${WORK_DIR}/cmake/plugin_path" found)
expect_equal("plug-in by find_package" "${found}" "${plugin}")
run(found "${WORK_DIR}/cmake/consumer" "${found}")
expect_equal("consumer by find_package" "${found}" "${greeting}")

# By pkg-config.
set(pkg_config "${CMAKE_COMMAND}" -E env "PKG_CONFIG_PATH=${prefix}/${LIBDIR}/pkgconfig" pkg-config)
run(found ${pkg_config} --modversion cagewright)
expect_equal("version by pkg-config" "${found}" "${VERSION}")
run(found ${pkg_config} --variable=plugin cagewright)
file(REAL_PATH "${found}" plugin_found)
file(REAL_PATH "${plugin}" plugin_real)
expect_equal("plug-in by pkg-config" "${plugin_found}" "${plugin_real}")
run(flags ${pkg_config} --cflags cagewright)
separate_arguments(flags UNIX_COMMAND "${flags}")
separate_arguments(c_flags UNIX_COMMAND "${C_FLAGS}")
run(ignored "${C_COMPILER}" -std=c99 -pedantic-errors -Wall -Wextra -Werror ${c_flags} ${flags} "${SOURCE_DIR}/main.c"
    -o "${WORK_DIR}/pkgconfig/consumer" -ldl)
run(found "${WORK_DIR}/pkgconfig/consumer" "${plugin_found}")
expect_equal("consumer by pkg-config" "${found}" "${greeting}")

# The installed program finds the installed plug-in.
if(PROGRAM)
  run(found "${CMAKE_COMMAND}" -E env --unset=CAGEWRIGHT_PLUGIN "${prefix}/${BINDIR}/cagewright" params)
  if(NOT found MATCHES "refine\\.iterations")
    message(FATAL_ERROR "the installed program's parameters lack refine.iterations:\n${found}")
  endif()
endif()

# The installed documents' links lead to installed files.
run(found "${CMAKE_COMMAND}" "-DROOT=${prefix}/${DOCDIR}" -P "${CMAKE_CURRENT_LIST_DIR}/check_links.cmake")
