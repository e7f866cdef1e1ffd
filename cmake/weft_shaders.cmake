# Embeds every shader of src/ into generated C++: weft_embed_shaders(OUTPUT file.cpp).
function(weft_embed_shaders OUTPUT)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/*.wgsl)
  add_custom_command(OUTPUT ${OUTPUT}
    COMMAND ${CMAKE_COMMAND} -DSHADERS=${PROJECT_SOURCE_DIR}/src -DOUTPUT=${OUTPUT} -DSTRIP=${EMSCRIPTEN}
            -P ${PROJECT_SOURCE_DIR}/cmake/embed_shaders.cmake
    DEPENDS ${files} ${PROJECT_SOURCE_DIR}/cmake/embed_shaders.cmake
    COMMENT "Embedding shaders" VERBATIM)
endfunction()
