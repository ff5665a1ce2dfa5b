# Installs the twin's part of BUILD into WORK, then configures, builds and runs the project beside this file, and
# compiles what an installed program compiles twins against.
file(REMOVE_RECURSE ${WORK})
foreach(
  step IN
  ITEMS "${CMAKE_COMMAND};--install;${BUILD};--component;twin;--prefix;${WORK}/prefix"
        "${COMPILER};-std=c++20;-fsyntax-only;-w;-x;c++;-I${WORK}/prefix/share/shadertwin/include;${WORK}/prefix/share/shadertwin/include/reference/twin/invocation.h"
        "${COMPILER};-std=c++20;-fsyntax-only;-w;-x;c++;-I${WORK}/prefix/share/shadertwin/include;${WORK}/prefix/share/shadertwin/include/reference/twin/packet_invocation.h"
        "${CMAKE_COMMAND};-S;${CMAKE_CURRENT_LIST_DIR};-B;${WORK}/build;-G;${GENERATOR};-D;CMAKE_PREFIX_PATH=${WORK}/prefix;-D;CMAKE_CXX_COMPILER=${COMPILER}"
        "${CMAKE_COMMAND};--build;${WORK}/build"
        "${CMAKE_CTEST_COMMAND};--test-dir;${WORK}/build;--output-on-failure")
  execute_process(COMMAND ${step} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${step}\n${output}")
  endif()
endforeach()
