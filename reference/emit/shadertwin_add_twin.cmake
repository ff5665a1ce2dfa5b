# shadertwin_add_twin(target file.glsl ... [NAMESPACE name] [DEFINES NAME=VALUE ...])
#
# Gives `target` a header NAME.h with the functions of the GLSL files, read one behind the other, as C++ functions in
# namespace NAME (by default the stem of the last file). A target that is compiled with SHADERTWIN_DOUBLE gets them in
# double when the command is called with DOUBLE; a program holds one precision only.
#
#   add_executable(schlick_test schlick_test.cpp)
#   shadertwin_add_twin(schlick_test common.glsl)      ->  #include "common.h"   common::schlick(0.5f, 1.5f)
function(shadertwin_add_twin target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "DOUBLE" "NAMESPACE" "DEFINES")
  set(files)
  foreach(file IN LISTS arg_UNPARSED_ARGUMENTS)
    cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
    list(APPEND files ${file})
  endforeach()
  if(NOT files)
    message(FATAL_ERROR "shadertwin_add_twin(${target}): no GLSL file is given")
  endif()
  if(NOT arg_NAMESPACE)
    list(GET files -1 last)
    cmake_path(GET last STEM arg_NAMESPACE)
  endif()
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${target}_twins)
  set(header ${folder}/${arg_NAMESPACE}.h)
  set(options --namespace ${arg_NAMESPACE} -o ${header})
  foreach(define IN LISTS arg_DEFINES)
    list(APPEND options -D ${define})
  endforeach()
  if(arg_DOUBLE)
    list(APPEND options --double)
    target_compile_definitions(${target} PRIVATE SHADERTWIN_DOUBLE)
  endif()
  file(MAKE_DIRECTORY ${folder})
  add_custom_command(
    OUTPUT ${header}
    COMMAND shadertwin::emit ${files} ${options}
    DEPENDS ${files} shadertwin::emit
    COMMENT "Translating ${arg_NAMESPACE} to C++"
    VERBATIM)
  target_sources(${target} PRIVATE ${header})
  target_include_directories(${target} PRIVATE ${folder})
  target_link_libraries(${target} PRIVATE shadertwin::glsl)
endfunction()
