# OpenImageIO without the include path of OpenCV: Debian's package names it, does not depend on it, and CMake refuses
# paths that do not exist.
find_package(OpenImageIO REQUIRED)
get_target_property(pelagic_oiio_includes OpenImageIO::OpenImageIO INTERFACE_INCLUDE_DIRECTORIES)
list(FILTER pelagic_oiio_includes EXCLUDE REGEX "opencv")
set_target_properties(OpenImageIO::OpenImageIO PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${pelagic_oiio_includes}")
