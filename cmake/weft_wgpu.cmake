# wgpu-native, from the pinned wheel that ./dev unpacks into .setup/wgpu.
set(WEFT_WGPU_DIR ${PROJECT_SOURCE_DIR}/.setup/wgpu CACHE PATH "Folder with webgpu.h, wgpu.h and the shared library")
if(NOT EXISTS ${WEFT_WGPU_DIR}/webgpu.h)
  message(FATAL_ERROR "${WEFT_WGPU_DIR}/webgpu.h is missing: run ./dev build, which sets it up.")
endif()
# Beside the binary, so that build/ can be copied to another machine as it is.
configure_file(${WEFT_WGPU_DIR}/libwgpu_native-release.so ${PROJECT_BINARY_DIR}/libwgpu_native.so COPYONLY)
add_library(weft::wgpu_native SHARED IMPORTED GLOBAL)
set_target_properties(weft::wgpu_native PROPERTIES IMPORTED_LOCATION ${PROJECT_BINARY_DIR}/libwgpu_native.so
  IMPORTED_NO_SONAME ON)
target_include_directories(weft::wgpu_native SYSTEM INTERFACE ${WEFT_WGPU_DIR})
