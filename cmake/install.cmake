# cmake --install: bin/millwright with its catalogues, the rooms as libraries with headers, and a CMake package.
include(CMakePackageConfigHelpers)
set(package_directory ${CMAKE_INSTALL_LIBDIR}/cmake/millwright)
set(rooms text scalar solver mechanics catalogue machine evaluation report)

list(TRANSFORM rooms PREPEND millwright_ OUTPUT_VARIABLE room_targets)
install(TARGETS millwright_options ${room_targets} EXPORT millwright ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT millwright FILE millwrightTargets.cmake NAMESPACE millwright:: DESTINATION ${package_directory})
foreach(room IN LISTS rooms)
  install(DIRECTORY src/${room} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/millwright FILES_MATCHING PATTERN "*.h")
endforeach()
if(TARGET millwright)
  install(TARGETS millwright RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
install(DIRECTORY catalogues DESTINATION ${CMAKE_INSTALL_DATADIR}/millwright)
install(DIRECTORY problems DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

configure_package_config_file(cmake/millwrightConfig.cmake.in ${PROJECT_BINARY_DIR}/millwrightConfig.cmake
  INSTALL_DESTINATION ${package_directory})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/millwrightConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/millwrightConfig.cmake ${PROJECT_BINARY_DIR}/millwrightConfigVersion.cmake
  cmake/dependencies.cmake DESTINATION ${package_directory})
