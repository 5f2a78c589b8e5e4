# Writes the scene files SCENES (a list) as a C++ source OUTPUT that defines common::builtinScenes().
foreach(scene IN LISTS SCENES)
  cmake_path(GET scene STEM name)
  file(READ "${scene}" text)
  string(APPEND entries "    {\"${name}\", R\"toml(${text})toml\"},\n")
endforeach()
file(WRITE "${OUTPUT}.tmp"
     "#include <common/scene.hpp>\nnamespace common {\nstd::span<const BuiltinScene> builtinScenes() {\n"
     "  static constexpr BuiltinScene scenes[] = {\n${entries}  };\n  return scenes;\n}\n}  // namespace common\n")
file(RENAME "${OUTPUT}.tmp" "${OUTPUT}")
