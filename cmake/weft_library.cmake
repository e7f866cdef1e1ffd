# The engine as one library, weft::weft, which is static, and weft::weft_shared, and what `cmake --install` puts beside
# them.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)
find_package(Threads REQUIRED)

# All rooms that weft_NAME links, itself among them, in RESULT.
function(weft_rooms_below NAME RESULT)
  set(found weft_${NAME})
  set(open weft_${NAME})
  while(open)
    list(POP_FRONT open room)
    get_target_property(linked ${room} LINK_LIBRARIES)
    foreach(library IN LISTS linked)
      if(library MATCHES "^weft_" AND NOT library STREQUAL weft_leaves AND NOT library IN_LIST found)
        list(APPEND found ${library})
        list(APPEND open ${library})
      endif()
    endforeach()
  endwhile()
  set(${RESULT} ${found} PARENT_SCOPE)
endfunction()

weft_rooms_below(api rooms)
list(TRANSFORM rooms REPLACE "(.+)" "$<TARGET_OBJECTS:\\1>" OUTPUT_VARIABLE objects)
add_library(weft_library STATIC ${objects})
add_library(weft_shared SHARED ${objects})
add_dependencies(weft_library weft_shared)  # what is installed together is built together
set_target_properties(weft_library PROPERTIES EXPORT_NAME weft)
add_library(weft::weft ALIAS weft_library)
add_library(weft::weft_shared ALIAS weft_shared)
foreach(library weft_library weft_shared)
  set_target_properties(${library} PROPERTIES OUTPUT_NAME weft LINKER_LANGUAGE CXX)
  target_compile_features(${library} PUBLIC cxx_std_20)
  target_include_directories(${library} INTERFACE
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(${library} PRIVATE Threads::Threads weft::wgpu_native
    $<BUILD_INTERFACE:z> $<INSTALL_INTERFACE:ZLIB::ZLIB>)
endforeach()
# Its name has the numbers that programs depend on: before 1.0 a minor version may change what it declares.
set(exported ${PROJECT_SOURCE_DIR}/src/api/exported.map)
set_target_properties(weft_shared PROPERTIES VERSION ${PROJECT_VERSION} INSTALL_RPATH "$ORIGIN" LINK_DEPENDS ${exported}
  SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
target_link_options(weft_shared PRIVATE LINKER:--version-script=${exported})

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/weft)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/weft DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(TARGETS weft_library weft_shared EXPORT weft DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(FILES ${PROJECT_BINARY_DIR}/libwgpu_native.so DESTINATION ${CMAKE_INSTALL_LIBDIR})
set(wgpu_headers ${CMAKE_INSTALL_INCLUDEDIR}/weft-wgpu)  # for programs that use the GPU themselves: weft::wgpu_native
install(FILES ${WEFT_WGPU_DIR}/webgpu.h ${WEFT_WGPU_DIR}/wgpu.h DESTINATION ${wgpu_headers})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/NOTICE ${PROJECT_SOURCE_DIR}/THIRD_PARTY.md
        DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(EXPORT weft NAMESPACE weft:: FILE weft-targets.cmake DESTINATION ${package})
set(wgpu_native ${CMAKE_INSTALL_LIBDIR}/libwgpu_native.so)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/weft-config.cmake.in ${PROJECT_BINARY_DIR}/weft-config.cmake
  INSTALL_DESTINATION ${package} PATH_VARS wgpu_native wgpu_headers)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/weft-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/weft-config.cmake ${PROJECT_BINARY_DIR}/weft-config-version.cmake
        DESTINATION ${package})

# For other build systems: pkg-config. The files find the folders from their own place, so a prefix may be moved.
set(pkgconfig ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH up ${CMAKE_INSTALL_PREFIX}/${pkgconfig} ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" up ${up})
foreach(name weft weft-wgpu)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/${name}.pc.in ${PROJECT_BINARY_DIR}/${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${name}.pc DESTINATION ${pkgconfig})
endforeach()
