# All from Debian packages; see packages.txt. PRIVATE ones never show in a public header.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt 9 REQUIRED)
find_package(GDAL 3.6 REQUIRED)
find_package(PROJ 9 REQUIRED)
find_package(yaml-cpp 0.7 REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(PNG 1.6 REQUIRED)
find_package(Boost 1.74 REQUIRED)
find_package(Threads REQUIRED)
# Debian's GeographicLib package has no config file that CMake finds by itself; it sits in the default library folder.
find_library(GEOGRAPHICLIB_LIBRARY GeographicLib REQUIRED)
