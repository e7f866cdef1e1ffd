# Writes OUTPUT: a sorted table of the paths below SHADERS and their texts. With STRIP without comments, which a page
# would load, but for those that src/gpu/shader_source.cpp reads; lines keep their numbers.
file(GLOB_RECURSE files RELATIVE ${SHADERS} ${SHADERS}/*.wgsl)
list(SORT files)
set(rows "")
foreach(file ${files})
  file(READ ${SHADERS}/${file} text)
  if(STRIP)
    string(REPLACE "\n// one a step: " "\n@one a step: " text "${text}")
    string(REGEX REPLACE " *//[^\n]*" "" text "${text}")
    string(REPLACE "\n@one a step: " "\n// one a step: " text "${text}")
  endif()
  string(APPEND rows "    {\"${file}\", R\"wgsl~(${text})wgsl~\"},\n")
endforeach()
file(WRITE ${OUTPUT} "// Generated from the shaders of src/ by cmake/embed_shaders.cmake.
#include \"gpu/shader_source.hpp\"

namespace weft::gpu {

std::span<const EmbeddedShader> embedded_shaders() {
  static constexpr EmbeddedShader kShaders[] = {
${rows}  };
  return kShaders;
}

}  // namespace weft::gpu
")
