# Settings that every target of ours gets, and none of our users'.
#
#   cagewright_target(NAME)   C++20 / C99, warnings, no floating-point contraction, sanitizers
#   cagewright_test(NAME SOURCES... LINK LIBRARIES...)   a GoogleTest executable whose tests ctest knows one by one
#   cagewright_display_test(NAME)   makes the executable NAME one test, under xvfb-run where there is no DISPLAY,
#                                   with the label "display"
#
# Compilers are run through ccache where it is installed and nobody asked for another launcher.

# Program and plug-in lie in one folder of the build tree, so that the program finds the plug-in there as it does where
# both are installed.

if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_RUNTIME_OUTPUT_DIRECTORY AND NOT CMAKE_LIBRARY_OUTPUT_DIRECTORY)
  set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
  set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
endif()

find_program(CAGEWRIGHT_CCACHE ccache DOC "Compiler cache for our own code; empty for none")
mark_as_advanced(CAGEWRIGHT_CCACHE)

function(cagewright_target name)
  target_compile_features(${name} PRIVATE cxx_std_20)
  set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF C_STANDARD 99 C_EXTENSIONS OFF
                        CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON POSITION_INDEPENDENT_CODE ON)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  # One product a*b+c must round the same way on every machine and in every build.
  target_compile_options(${name} PRIVATE -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                         -Wno-sign-conversion $<$<COMPILE_LANGUAGE:CXX>:-Wnon-virtual-dtor -Woverloaded-virtual>)
  if(CAGEWRIGHT_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set_target_properties(${name} PROPERTIES C_COMPILER_LAUNCHER ${CAGEWRIGHT_CCACHE}
                          CXX_COMPILER_LAUNCHER ${CAGEWRIGHT_CCACHE})
  endif()
  if(CAGEWRIGHT_WERROR)
    target_compile_options(${name} PRIVATE -Werror)
  endif()
  if(CAGEWRIGHT_SANITIZE)
    list(JOIN CAGEWRIGHT_SANITIZE "," sanitizers)
    # g++ 12 takes what the sanitizers add for uninitialised input, in the standard library's own code too.
    target_compile_options(${name} PRIVATE -fsanitize=${sanitizers} -fno-omit-frame-pointer
                           $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
    target_link_options(${name} PRIVATE -fsanitize=${sanitizers})
  endif()
endfunction()

function(cagewright_test name)
  cmake_parse_arguments(arg "" "" "LINK" ${ARGN})
  add_executable(${name} ${arg_UNPARSED_ARGUMENTS})
  cagewright_target(${name})
  target_link_libraries(${name} PRIVATE ${arg_LINK} GTest::gtest GTest::gtest_main)
  set(timeout 300)
  if(CAGEWRIGHT_SANITIZE)
    set(timeout 1800)  # they are slow
  endif()
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT ${timeout})
endfunction()

function(cagewright_display_test name)
  add_test(NAME ${name} COMMAND ${PROJECT_SOURCE_DIR}/cmake/with_display $<TARGET_FILE:${name}>)
  set_tests_properties(${name} PROPERTIES TIMEOUT 300 LABELS display)
endfunction()
