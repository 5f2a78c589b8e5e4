# Writes the words of the SPIR-V file INPUT as a C++ header OUTPUT that defines pelagic::shaders::NAME.
file(READ "${INPUT}" hex HEX)
string(REGEX REPLACE "(..)(..)(..)(..)" "0x\\4\\3\\2\\1u," words "${hex}")
file(WRITE "${OUTPUT}.tmp"
     "#pragma once\n#include <cstdint>\n#include <span>\nnamespace pelagic::shaders {\n"
     "inline constexpr std::uint32_t ${NAME}_words[] = {${words}};\n"
     "inline constexpr std::span<const std::uint32_t> ${NAME}{${NAME}_words};\n}\n")
file(RENAME "${OUTPUT}.tmp" "${OUTPUT}")
