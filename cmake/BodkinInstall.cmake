# install() rules. The package for find_package(Bodkin) contains the haptic core: patients in memory, force models,
# devices and the tick, and the conversion of a mesh into a deformable body. The bodkin command and its data are
# installed with it.
include(CMakePackageConfigHelpers)

set(haptic_core core anatomy forces fem haptics simulation)
foreach(module IN LISTS haptic_core)
  install(TARGETS bodkin_${module} EXPORT BodkinTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(DIRECTORY src/${module}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/bodkin/${module} FILES_MATCHING PATTERN "*.h")
endforeach()
# Their headers are among those of fem.
install(TARGETS bodkin_fem_solid bodkin_fem_moving EXPORT BodkinTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT BodkinTargets NAMESPACE bodkin:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Bodkin)
configure_package_config_file(cmake/BodkinConfig.cmake.in "${CMAKE_CURRENT_BINARY_DIR}/BodkinConfig.cmake"
                              INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Bodkin)
write_basic_package_version_file("${CMAKE_CURRENT_BINARY_DIR}/BodkinConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/BodkinConfig.cmake" "${CMAKE_CURRENT_BINARY_DIR}/BodkinConfigVersion.cmake"
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Bodkin)

if(TARGET bodkin)
  install(TARGETS bodkin RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
if(TARGET bodkin-app)
  install(TARGETS bodkin-app RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
if(TARGET bodkin-images)
  install(TARGETS bodkin-images RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/bodkin)
endif()
if(TARGET bodkin-mesher)
  install(TARGETS bodkin-mesher RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/bodkin)
endif()
install(DIRECTORY share/bodkin/ DESTINATION ${CMAKE_INSTALL_DATADIR}/bodkin)
install(FILES LICENSE README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
