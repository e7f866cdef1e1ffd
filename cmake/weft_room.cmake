# weft_room(NAME [FOLDER path] SOURCES ... IMPORTS rooms... LIBRARIES others... [EXCEPTIONS])
#
# A room is a static library of the sources in src/FOLDER (default: src/NAME). Its headers are included by their path
# below src/. Each room has an include folder of its own (a link in the build tree to its sources) and passes on only
# those of the rooms it imports: including a room that is not listed does not compile. Rooms that share a folder see
# each other's headers, but not what those include: a host room that includes a GPU header does not compile either.
#
# Sources of a room are compiled eight at a time: most of the time went into the headers that they share. So file-local
# names are unique in a room. With the sanitizers they are compiled file by file, which finds a missing include.
function(weft_room NAME)
  cmake_parse_arguments(ROOM "EXCEPTIONS" "FOLDER" "SOURCES;IMPORTS;LIBRARIES" ${ARGN})
  if(NOT ROOM_FOLDER)
    set(ROOM_FOLDER ${NAME})
  endif()
  set(include ${PROJECT_BINARY_DIR}/rooms/${NAME})
  cmake_path(GET ROOM_FOLDER PARENT_PATH parent)
  file(MAKE_DIRECTORY ${include}/${parent})
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/src/${ROOM_FOLDER} ${include}/${ROOM_FOLDER} SYMBOLIC)
  list(TRANSFORM ROOM_SOURCES PREPEND ${PROJECT_SOURCE_DIR}/src/${ROOM_FOLDER}/ REGEX "^[^/]")
  add_library(weft_${NAME} STATIC ${ROOM_SOURCES})
  target_include_directories(weft_${NAME} PUBLIC ${include})
  if(NOT WEFT_SANITIZE)
    set_target_properties(weft_${NAME} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
  endif()
  if(NOT EMSCRIPTEN)
    # The library goes into shared ones too, as Python's modules are.
    set_target_properties(weft_${NAME} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_compile_options(weft_${NAME} PRIVATE -fno-semantic-interposition)  # inlined as without
  elseif(NOT NAME MATCHES "reference|^base$|^element$")
    target_compile_options(weft_${NAME} PRIVATE -Os)  # a page loads it: only what steps on the CPU is worth its bytes
  endif()
  list(TRANSFORM ROOM_IMPORTS PREPEND weft_)
  target_link_libraries(weft_${NAME} PUBLIC ${ROOM_IMPORTS} PRIVATE ${ROOM_LIBRARIES})
  if(NOT ROOM_EXCEPTIONS)
    target_compile_options(weft_${NAME} PRIVATE -fno-exceptions)  # browser builds go without them
  endif()
endfunction()
