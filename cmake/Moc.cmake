# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later

# In place of AUTOMOC, which lets Qt's moc read all that a file includes, Eigen and Qt too, in search of
# macros that no class here uses: a second a file, a third of a first build. Told of no folder, it takes
# 10 ms. One command for all files of a target; what comes out the same keeps its time.

# dyncal_moc(target source...): of each header with Q_OBJECT what the target compiles in one piece, of each
# source NAME.cpp with Q_OBJECT the NAME.moc that it includes.
function(dyncal_moc target)
    set(folder "${CMAKE_CURRENT_BINARY_DIR}/moc/${target}")
    set(files "")
    set(made "")
    foreach(file IN LISTS ARGN)
        file(STRINGS "${file}" found LIMIT_COUNT 1 REGEX "^ *Q_OBJECT")
        if(found)
            list(APPEND files "${file}")
            get_filename_component(name "${file}" NAME_WE)
            if(file MATCHES "\\.cpp$")
                list(APPEND made "${folder}/${name}.moc")
            else()
                list(APPEND made "${folder}/mocs.cpp")
            endif()
        endif()
    endforeach()
    if(NOT files)
        return()
    endif()
    list(REMOVE_DUPLICATES made)
    set(script "${PROJECT_SOURCE_DIR}/cmake/run_moc.cmake")
    add_custom_command(OUTPUT ${made} DEPENDS ${files} "${script}" VERBATIM
        COMMENT "What moc makes of ${target}"
        COMMAND "${CMAKE_COMMAND}" "-DMOC=$<TARGET_FILE:Qt6::moc>" "-DFOLDER=${folder}"
            "-DFILES=${files}" "-DROOT=${PROJECT_SOURCE_DIR}" -P "${script}")
    set_source_files_properties("${folder}/mocs.cpp" PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    target_sources(${target} PRIVATE ${made})
    target_include_directories(${target} PRIVATE "${folder}")
endfunction()
