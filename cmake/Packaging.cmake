# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Install rules and the Debian package: cpack --config build-release/CPackConfig.cmake
include(GNUInstallDirs)

# Debian's libraries are found without a search path of our own.
set_target_properties(dyncal PROPERTIES INSTALL_RPATH "")
install(TARGETS dyncal RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
install(FILES packaging/dyncal.desktop DESTINATION "${CMAKE_INSTALL_DATADIR}/applications")
install(FILES packaging/org.dyncal.Dyncal.metainfo.xml
    DESTINATION "${CMAKE_INSTALL_DATADIR}/metainfo")
install(FILES packaging/dyncal-mime.xml
    DESTINATION "${CMAKE_INSTALL_DATADIR}/mime/packages" RENAME dyncal.xml)
install(FILES resources/icons/dyncal.svg
    DESTINATION "${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps")
install(DIRECTORY resources/templates DESTINATION "${CMAKE_INSTALL_DATADIR}/dyncal")
install(FILES packaging/copyright DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/dyncal")

# Debian wants these compressed; -n keeps the time stamp out, so that the package is reproducible.
find_program(DYNCAL_GZIP gzip)
if(DYNCAL_GZIP)
    foreach(pair "dyncal.1|${CMAKE_INSTALL_MANDIR}/man1" "changelog|${CMAKE_INSTALL_DATADIR}/doc/dyncal")
        string(REPLACE "|" ";" pair "${pair}")
        list(GET pair 0 name)
        list(GET pair 1 folder)
        set(packed "${PROJECT_BINARY_DIR}/packaging/${name}.gz")
        add_custom_command(OUTPUT "${packed}"
            COMMAND "${CMAKE_COMMAND}" -E make_directory "${PROJECT_BINARY_DIR}/packaging"
            COMMAND "${DYNCAL_GZIP}" -9nc "${PROJECT_SOURCE_DIR}/packaging/${name}" > "${packed}"
            DEPENDS "${PROJECT_SOURCE_DIR}/packaging/${name}" VERBATIM)
        list(APPEND DYNCAL_PACKED "${packed}")
        install(FILES "${packed}" DESTINATION "${folder}")
    endforeach()
    add_custom_target(dyncal_packed_documents ALL DEPENDS ${DYNCAL_PACKED})
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME dyncal)
set(CPACK_PACKAGE_VENDOR "The Dyncal authors")
set(CPACK_PACKAGE_CONTACT "The Dyncal authors <dyncal@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "dynamic calibration of pressure sensors")
set(CPACK_PACKAGE_DESCRIPTION
"Computes the frequency response, the resonances and a state-space model of a
pressure sensor from recordings of pressure steps, such as those of a shock
tube, in a workbench or on the command line, and writes results, plots and a
certificate.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "fonts-dejavu-core, libqt6sql6-sqlite, libqt6svg6")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libengine-pkcs11-openssl, libqt6sql6-psql, qt6-translations-l10n, qt6-wayland")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(CPack)
