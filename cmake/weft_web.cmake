# The WebAssembly build, with Debian's Emscripten. Header-only libraries of the system are linked one by one into a
# folder of their own: /usr/include as a whole would bring glibc's headers.
set(headers ${PROJECT_BINARY_DIR}/system)
file(MAKE_DIRECTORY ${headers})
foreach(library nlohmann xxhash.h)
  if(NOT EXISTS /usr/include/${library})
    message(FATAL_ERROR "/usr/include/${library} is missing: run ./dev build, which sets it up.")
  endif()
  file(CREATE_LINK /usr/include/${library} ${headers}/${library} SYMBOLIC)
endforeach()
include_directories(SYSTEM ${headers})
