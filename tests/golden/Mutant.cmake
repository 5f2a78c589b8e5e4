# Wrong shaders: pelagic_mutant(target name SHADER file [FILE included] SEARCH text REPLACE text) compiles shaders/<SHADER>
# with one text changed, in itself or in shaders/<FILE> that it includes. C++ gets pelagic::shaders::mutant_<name>, and
# pelagic::shaders::right_<SHADER> as the library has it.
function(pelagic_mutant target name)
  cmake_parse_arguments(PARSE_ARGV 2 ARG "" "SHADER;FILE;SEARCH;REPLACE" "") # keeps semicolons
  if(NOT ARG_FILE)
    set(ARG_FILE "${ARG_SHADER}")
  endif()
  set(source "${PELAGIC_SHADER_DIR}/${ARG_FILE}")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${source}")
  file(READ "${source}" text)
  string(FIND "${text}" "${ARG_SEARCH}" first)
  string(FIND "${text}" "${ARG_SEARCH}" last REVERSE)
  if(first EQUAL -1 OR NOT first EQUAL last)
    message(FATAL_ERROR "mutant ${name}: '${ARG_SEARCH}' must stand in ${source} exactly once")
  endif()
  string(REPLACE "${ARG_SEARCH}" "${ARG_REPLACE}" text "${text}")
  set(folder "${CMAKE_CURRENT_BINARY_DIR}/mutants/${name}")
  file(CONFIGURE OUTPUT "${folder}/${ARG_FILE}" CONTENT "${text}" @ONLY)

  cmake_path(GET ARG_SHADER PARENT_PATH stage)
  set(input "${ARG_SHADER}")
  if(ARG_FILE STREQUAL ARG_SHADER)
    set(input "${folder}/${ARG_SHADER}")
  endif()
  pelagic_add_shader(${target} "${input}" NAME mutant_${name} INCLUDES "${folder}" "${PELAGIC_SHADER_DIR}/${stage}")

  string(REGEX REPLACE "[/.-]" "_" right "right_${ARG_SHADER}")
  get_property(known TARGET ${target} PROPERTY PELAGIC_RIGHT_SHADERS)
  if(NOT right IN_LIST known)
    set_property(TARGET ${target} APPEND PROPERTY PELAGIC_RIGHT_SHADERS ${right})
    pelagic_add_shader(${target} "${ARG_SHADER}" NAME ${right})
  endif()
endfunction()
