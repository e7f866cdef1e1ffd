# One set of flags for everything that weft compiles.
find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

option(WEFT_WERROR "Warnings end the build" ${PROJECT_IS_TOP_LEVEL})
if(WEFT_WERROR)
  add_compile_options(-Werror)
endif()
add_compile_options(-Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
  -Wno-missing-field-initializers)  # designated initializers name what differs from the default
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  add_compile_options(-Wno-restrict)  # GCC 12 warns about std::string's own operator+ (its bug 105651)
endif()
# The reference must give the same bits on every machine: no fused multiply-add unless written.
add_compile_options(-ffp-contract=off)

option(WEFT_SANITIZE "Build with the address and undefined-behaviour sanitizers" OFF)
if(WEFT_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O1 -g")  # asserts stay on: this is what the sanitizers run
