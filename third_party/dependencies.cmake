# Finds the client's packages, each with the least version drt was tested with.
find_package(embree 3.13 REQUIRED)
find_package(OpenEXR 3.1 REQUIRED)
find_package(OpenImageIO 2.4 REQUIRED)
find_package(TBB 2021 REQUIRED)
find_package(yaml-cpp 0.7 REQUIRED)
find_package(fmt 9 REQUIRED)
find_package(GTest 1.12 REQUIRED)

