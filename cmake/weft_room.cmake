# weft_room(NAME SOURCES ... IMPORTS rooms... LIBRARIES others... [EXCEPTIONS])
#
# A room is a static library whose headers are included as "NAME/header.hpp". Each room has an include folder of
# its own (a link in the build tree to its sources) and passes on only those of the rooms it imports: including a
# room that is not listed does not compile.
function(weft_room NAME)
  cmake_parse_arguments(ROOM "EXCEPTIONS" "" "SOURCES;IMPORTS;LIBRARIES" ${ARGN})
  set(include ${CMAKE_BINARY_DIR}/rooms/${NAME})
  file(MAKE_DIRECTORY ${include})
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${include}/${NAME} SYMBOLIC)
  add_library(weft_${NAME} STATIC ${ROOM_SOURCES})
  target_include_directories(weft_${NAME} PUBLIC ${include})
  list(TRANSFORM ROOM_IMPORTS PREPEND weft_)
  target_link_libraries(weft_${NAME} PUBLIC ${ROOM_IMPORTS} PRIVATE ${ROOM_LIBRARIES})
  if(NOT ROOM_EXCEPTIONS)
    target_compile_options(weft_${NAME} PRIVATE -fno-exceptions)  # browser builds go without them
  endif()
endfunction()
