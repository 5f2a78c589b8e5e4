# GLSL -> SPIR-V (glslangValidator) -> spirv-val -> a C++ header that holds the words.
# The depfile makes an edit rebuild only the shaders that include the edited file.
find_program(PELAGIC_GLSLANG glslangValidator REQUIRED)
find_program(PELAGIC_SPIRV_VAL spirv-val REQUIRED)

set(PELAGIC_SHADER_DIR "${CMAKE_CURRENT_LIST_DIR}/../shaders")
set(PELAGIC_EMBED_SCRIPT "${CMAKE_CURRENT_LIST_DIR}/EmbedSpirv.cmake")

# pelagic_add_shader(target source [NAME name] [DEFINES a=b ...] [INCLUDES dir ...])
# `source` is relative to shaders/ or absolute. C++ sees `pelagic::shaders::NAME` (a std::span of words) after
# #include "NAME.spv.hpp"; NAME defaults to the path below shaders/ with every separator and dot as '_'.
function(pelagic_add_shader target source)
  cmake_parse_arguments(ARG "" "NAME" "DEFINES;INCLUDES" ${ARGN})
  if(NOT ARG_NAME)
    string(REGEX REPLACE "[/.-]" "_" ARG_NAME "${source}")
  endif()
  cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY "${PELAGIC_SHADER_DIR}" NORMALIZE OUTPUT_VARIABLE input)
  set(dir "${CMAKE_CURRENT_BINARY_DIR}/shaders_${target}")
  file(MAKE_DIRECTORY "${dir}")
  set(spv "${dir}/${ARG_NAME}.spv")
  set(header "${dir}/${ARG_NAME}.spv.hpp")
  list(TRANSFORM ARG_DEFINES PREPEND "-D")
  list(TRANSFORM ARG_INCLUDES PREPEND "-I") # searched before shaders/
  add_custom_command(
    OUTPUT "${spv}"
    COMMAND ${PELAGIC_GLSLANG} -V --target-env vulkan1.2 --quiet ${ARG_INCLUDES} "-I${PELAGIC_SHADER_DIR}" "-I${PELAGIC_SHADER_DIR}/../include" ${ARG_DEFINES}
            --depfile "${spv}.d" -o "${spv}" "${input}"
    COMMAND ${PELAGIC_SPIRV_VAL} --target-env vulkan1.2 "${spv}"
    DEPENDS "${input}"
    DEPFILE "${spv}.d"
    COMMENT "Shader ${ARG_NAME}"
    VERBATIM)
  add_custom_command(
    OUTPUT "${header}"
    COMMAND "${CMAKE_COMMAND}" "-DINPUT=${spv}" "-DOUTPUT=${header}" "-DNAME=${ARG_NAME}" -P "${PELAGIC_EMBED_SCRIPT}"
    DEPENDS "${spv}" "${PELAGIC_EMBED_SCRIPT}"
    VERBATIM)
  target_sources(${target} PRIVATE "${header}")
  target_include_directories(${target} PRIVATE "${dir}")
endfunction()
