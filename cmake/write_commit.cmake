# Writes the header FILE with the commit of the checkout SOURCE, where that has changed: run at every build.
find_package(Git QUIET)
set(commit "")
if(GIT_FOUND)
  execute_process(COMMAND ${GIT_EXECUTABLE} -C ${SOURCE} describe --always --dirty=+changes --abbrev=12 --exclude=*
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
if(commit STREQUAL "")
  set(commit "unknown")  # no git, or no checkout
endif()
file(CONFIGURE OUTPUT ${FILE} CONTENT "#define WEFT_COMMIT \"${commit}\"\n")
