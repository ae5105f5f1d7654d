# What `cmake --install` puts where. Everything is found relative to the files that name it, so the tree can be moved.
#
#   bin/cagewright                          the program
#   lib/cagewright/cagewright_plugin.so     the plug-in
#   include/cagewright/cagewright.h         its C ABI
#   lib/cmake/cagewright/                   find_package(cagewright): target cagewright::abi, CAGEWRIGHT_PLUGIN_PATH
#   lib/pkgconfig/cagewright.pc             pkg-config --cflags cagewright, --variable=plugin
#   share/doc/cagewright/                   LICENSE, README and all documents that it links to, in the folders of the source

include(CMakePackageConfigHelpers)

set(CAGEWRIGHT_PLUGIN_DIR "${CMAKE_INSTALL_LIBDIR}/cagewright")
set(CAGEWRIGHT_PLUGIN_FILE "${CAGEWRIGHT_PLUGIN_DIR}/cagewright_plugin.so")
set(CAGEWRIGHT_CONFIG_DIR "${CMAKE_INSTALL_LIBDIR}/cmake/cagewright")
set(CAGEWRIGHT_PKGCONFIG_DIR "${CMAKE_INSTALL_LIBDIR}/pkgconfig")

# plugin/ and host/cli/ install what they build, into these folders; here follow the documents and the packages.
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" "${PROJECT_SOURCE_DIR}/README.md" "${PROJECT_SOURCE_DIR}/CHANGELOG.md"
        "${PROJECT_SOURCE_DIR}/CONTRIBUTING.md" DESTINATION "${CMAKE_INSTALL_DOCDIR}")
install(FILES "${PROJECT_SOURCE_DIR}/testdata/README.md" DESTINATION "${CMAKE_INSTALL_DOCDIR}/testdata")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/docs" DESTINATION "${CMAKE_INSTALL_DOCDIR}"
        FILES_MATCHING PATTERN "*.md" PATTERN "*.png" PATTERN "*.svg")

# find_package(cagewright)
set_target_properties(cagewright_abi PROPERTIES EXPORT_NAME abi)
install(TARGETS cagewright_abi EXPORT cagewrightTargets)
install(EXPORT cagewrightTargets NAMESPACE cagewright:: DESTINATION "${CAGEWRIGHT_CONFIG_DIR}")
configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/cagewrightConfig.cmake.in"
                              "${PROJECT_BINARY_DIR}/cagewrightConfig.cmake"
                              INSTALL_DESTINATION "${CAGEWRIGHT_CONFIG_DIR}" PATH_VARS CAGEWRIGHT_PLUGIN_FILE)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/cagewrightConfigVersion.cmake" COMPATIBILITY SameMajorVersion)
install(FILES "${PROJECT_BINARY_DIR}/cagewrightConfig.cmake" "${PROJECT_BINARY_DIR}/cagewrightConfigVersion.cmake"
        DESTINATION "${CAGEWRIGHT_CONFIG_DIR}")

# pkg-config
cmake_path(RELATIVE_PATH CMAKE_INSTALL_PREFIX BASE_DIRECTORY "${CMAKE_INSTALL_PREFIX}/${CAGEWRIGHT_PKGCONFIG_DIR}"
           OUTPUT_VARIABLE CAGEWRIGHT_PREFIX_FROM_PKGCONFIG)
set(CAGEWRIGHT_PC_INCLUDEDIR "${CMAKE_INSTALL_INCLUDEDIR}")
set(CAGEWRIGHT_PC_PLUGIN_FILE "${CAGEWRIGHT_PLUGIN_FILE}")
foreach(path CAGEWRIGHT_PC_INCLUDEDIR CAGEWRIGHT_PC_PLUGIN_FILE)
  if(NOT IS_ABSOLUTE "${${path}}")
    string(PREPEND ${path} "\${prefix}/")
  endif()
endforeach()
configure_file("${CMAKE_CURRENT_LIST_DIR}/cagewright.pc.in" "${PROJECT_BINARY_DIR}/cagewright.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/cagewright.pc" DESTINATION "${CAGEWRIGHT_PKGCONFIG_DIR}")

if(CAGEWRIGHT_BUILD_TESTS)
  add_subdirectory("${PROJECT_SOURCE_DIR}/cmake/tests" "${PROJECT_BINARY_DIR}/cmake/tests")
endif()
