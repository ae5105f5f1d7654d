# What the plug-in shows to the world, read from the file: one exported symbol, no symbol that would keep it loaded
# (STB_GNU_UNIQUE), and none of the libraries that a digital-content-creation program brings in its own version.
#     cmake -DPLUGIN=FILE -DNM=nm -DREADELF=readelf -P check_shared_object.cmake
execute_process(COMMAND ${NM} --dynamic --defined-only --format=posix ${PLUGIN}
                OUTPUT_VARIABLE defined COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[^\n]+" lines "${defined}")
list(TRANSFORM lines REPLACE " .*" "")
list(TRANSFORM lines REPLACE "@.*" "")
list(REMOVE_ITEM lines CAGEWRIGHT_1) # the version itself
if(NOT lines STREQUAL "cgw_get_api_v1")
  message(FATAL_ERROR "exported: ${lines}; cgw_get_api_v1 has to be the only symbol")
endif()

execute_process(COMMAND ${READELF} --wide --dyn-syms ${PLUGIN} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
if(symbols MATCHES "[^\n]* UNIQUE [^\n]*")
  message(FATAL_ERROR "a unique symbol keeps the plug-in loaded after dlclose: ${CMAKE_MATCH_0}")
endif()

execute_process(COMMAND ${READELF} --wide --dynamic ${PLUGIN} OUTPUT_VARIABLE dynamic COMMAND_ERROR_IS_FATAL ANY)
if(dynamic MATCHES "NODELETE")
  message(FATAL_ERROR "the plug-in is linked with -z nodelete")
endif()
string(REGEX MATCHALL "Shared library: \\[[^]]+\\]" needed "${dynamic}")
foreach(library IN LISTS needed)
  if(library MATCHES "libgomp|libomp|libtbb|libQt|libvtk|libceres|libglog|libblas|liblapack")
    message(FATAL_ERROR "the plug-in needs ${library}")
  endif()
endforeach()
if(NOT needed)
  message(FATAL_ERROR "no needed library was found in what ${READELF} prints")
endif()
