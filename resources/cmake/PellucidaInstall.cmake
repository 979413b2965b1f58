# What `cmake --install` puts where, and the Debian package that `cpack` makes of it.
include(GNUInstallDirs)
set(CMAKE_INSTALL_DOCDIR ${CMAKE_INSTALL_DATAROOTDIR}/doc/pellucida)

# The program finds its resources relative to itself, so that an installation can be moved (core/Resources.h).
file(RELATIVE_PATH resources_from_program "${CMAKE_INSTALL_FULL_BINDIR}" "${CMAKE_INSTALL_FULL_DATADIR}/pellucida")
if(NOT resources_from_program STREQUAL "../share/pellucida")
  message(FATAL_ERROR "The resources would be at ${resources_from_program} relative to the program, which expects "
                      "them at ../share/pellucida: change CMAKE_INSTALL_BINDIR or CMAKE_INSTALL_DATADIR")
endif()

# The man page: written by hand, except for the commands, which the program itself lists.
set(desktop ${PROJECT_SOURCE_DIR}/resources/desktop)
set(manual ${PROJECT_BINARY_DIR}/pellucida.1)
add_custom_command(OUTPUT ${manual}
  COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:pellucida> -DFRAME=${desktop}/pellucida.1.in -DMANUAL=${manual}
          -DPROJECT_VERSION=${PROJECT_VERSION} -P ${PROJECT_SOURCE_DIR}/resources/cmake/WriteManual.cmake
  DEPENDS pellucida ${desktop}/pellucida.1.in ${PROJECT_SOURCE_DIR}/resources/cmake/WriteManual.cmake
  VERBATIM)
add_custom_target(pellucida_manual ALL DEPENDS ${manual})

# The day of the build, or the one that SOURCE_DATE_EPOCH fixes.
string(TIMESTAMP PELLUCIDA_RELEASE_DATE "%Y-%m-%d" UTC)
configure_file(${desktop}/pellucida.metainfo.xml.in ${PROJECT_BINARY_DIR}/pellucida.metainfo.xml @ONLY)

install(TARGETS pellucida RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
foreach(folder devices lessons looks networks profiles reference scenarios shapes)
  # The scripts that made a resource are for the developer.
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/resources/${folder} DESTINATION ${CMAKE_INSTALL_DATADIR}/pellucida PATTERN "*.py" EXCLUDE)
endforeach()
# For the user's own scripts and clusters.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/resources/python ${PROJECT_SOURCE_DIR}/resources/workflows
  DESTINATION ${CMAKE_INSTALL_DATADIR}/pellucida USE_SOURCE_PERMISSIONS PATTERN "__pycache__" EXCLUDE)
install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CONTRIBUTING.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md
  ${PROJECT_SOURCE_DIR}/LICENSE
  DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES ${manual} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${desktop}/pellucida.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES ${desktop}/pellucida.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages)
install(FILES ${PROJECT_BINARY_DIR}/pellucida.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
set(icons ${CMAKE_INSTALL_DATADIR}/icons/hicolor)
install(FILES ${desktop}/pellucida.svg DESTINATION ${icons}/scalable/apps)
foreach(size 48 128 256)
  install(FILES ${desktop}/pellucida-${size}.png DESTINATION ${icons}/${size}x${size}/apps RENAME pellucida.png)
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME pellucida)
set(CPACK_PACKAGE_CONTACT "Pellucida developers <maintainers@pellucida.invalid>")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/resources/cmake/DebianFiles.cmake)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Commands that draw start Xvfb where there is no display; the window on a display needs none of these.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "xvfb, libgl1-mesa-dri, fonts-dejavu-core")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "spacenavd, paraview")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "force of a micropipette on a living cell, from the image
Pellucida shows a living cell's zona pellucida in 3-D, and the force on it,
while a micropipette enters the cell. Both are measured from the microscope
image alone, without a force sensor: live in a window, or from recordings, into
sessions that open in ParaView and tables as CSV.
.
A virtual microscope with a virtual oocyte is built in. The pipette can be
moved with a mouse, a gamepad, a SpaceMouse or a force-feedback device.")
include(CPack)
