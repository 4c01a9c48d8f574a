include(CMakePackageConfigHelpers)

install(TARGETS alate alate_cli EXPORT alateTargets
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR}
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/alate DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT alateTargets NAMESPACE alate:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/alate)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/alateConfig.cmake.in ${CMAKE_BINARY_DIR}/alateConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/alate)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/alateConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/alateConfig.cmake ${CMAKE_BINARY_DIR}/alateConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/alate)
