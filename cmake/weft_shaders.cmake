# Embeds every file of shaders/ into generated C++: weft_embed_shaders(OUTPUT file.cpp).
function(weft_embed_shaders OUTPUT)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/shaders/*.wgsl)
  add_custom_command(OUTPUT ${OUTPUT}
    COMMAND ${CMAKE_COMMAND} -DSHADERS=${CMAKE_SOURCE_DIR}/shaders -DOUTPUT=${OUTPUT}
            -P ${CMAKE_SOURCE_DIR}/cmake/embed_shaders.cmake
    DEPENDS ${files} ${CMAKE_SOURCE_DIR}/cmake/embed_shaders.cmake
    COMMENT "Embedding shaders" VERBATIM)
endfunction()
