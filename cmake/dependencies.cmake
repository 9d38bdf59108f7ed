# The libraries that the rooms link. This file is also installed and read by millwrightConfig.cmake, because a static
# library needs at its user's link what it needed at its own.
include(CMakeFindDependencyMacro)
find_dependency(PkgConfig)
find_dependency(fmt 9 CONFIG)
find_dependency(Eigen3 3.4 CONFIG)
find_dependency(tomlplusplus 3 CONFIG)
find_dependency(nlohmann_json 3.11 CONFIG)
# Plain NLopt finds the C package on Debian, which lacks the C++ algorithms.
find_dependency(nlopt_cxx CONFIG CONFIGS NLoptConfig.cmake)
find_dependency(Threads)
foreach(module IN ITEMS ipopt udunits xlsxwriter nettle zlib expat)
  if(NOT TARGET PkgConfig::${module})
    pkg_check_modules(${module} REQUIRED IMPORTED_TARGET GLOBAL ${module})
  endif()
endforeach()
