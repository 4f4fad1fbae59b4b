# Finds the client's packages, each with the least version drt was tested with.
find_package(embree 3.13 REQUIRED)
find_package(OpenEXR 3.1 REQUIRED)
find_package(OpenImageIO 2.4 REQUIRED)
find_package(TBB 2021 REQUIRED)
find_package(yaml-cpp 0.7 REQUIRED)
find_package(fmt 9 REQUIRED)
find_package(GTest 1.12 REQUIRED)


# Debian 12's OpenImageIO exports OpenCV's include folder, which libopenimageio-dev does not install; CMake refuses
# to generate with a folder that does not exist.
get_target_property(oiio_includes OpenImageIO::OpenImageIO INTERFACE_INCLUDE_DIRECTORIES)
list(FILTER oiio_includes EXCLUDE REGEX "opencv")
set_target_properties(OpenImageIO::OpenImageIO PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${oiio_includes}")
