# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Most of what a test costs to compile are templates that every other test of its room instantiates too;
# so with DYNCAL_UNITY (UnityRooms.cmake) several are compiled as one piece. In it each stands in a
# namespace of its own, after the headers of all; write_test_piece.cmake makes the piece.
set(DYNCAL_TESTS_MOST 8 CACHE STRING "Tests in a piece at most")

# What cannot stand in a namespace, and macros that the next test would see: such a test stays alone.
set(DYNCAL_TESTS_ALONE
    "^namespace (dyncal|QTest|std)|^Q_DECLARE_METATYPE|^extern|^template <>|^ *#(if|define)")

# dyncal_pieces_of_tests(pieces program source...): sets `pieces` to the sources of the program.
# Qt's moc reads those in a piece, too, so they stay in the list, marked as not to be compiled.
function(dyncal_pieces_of_tests pieces program)
    if(NOT DYNCAL_UNITY)
        set(${pieces} ${ARGN} PARENT_SCOPE)
        return()
    endif()
    set(made "")
    set(waiting "")
    set(number 0)
    foreach(source IN LISTS ARGN)
        file(STRINGS "${source}" alone LIMIT_COUNT 1 REGEX "${DYNCAL_TESTS_ALONE}")
        if(NOT alone)
            set_source_files_properties("${source}" PROPERTIES HEADER_FILE_ONLY ON)
            list(APPEND waiting "${source}")
        endif()
        list(LENGTH waiting count)
        if(count EQUAL DYNCAL_TESTS_MOST)
            dyncal_test_piece(made ${program} ${number} ${waiting})
            math(EXPR number "${number} + 1")
            set(waiting "")
        endif()
    endforeach()
    if(waiting)
        dyncal_test_piece(made ${program} ${number} ${waiting})
    endif()
    set(${pieces} ${ARGN} ${made} PARENT_SCOPE)
endfunction()

function(dyncal_test_piece list program number)
    set(piece "${CMAKE_CURRENT_BINARY_DIR}/pieces/${program}_${number}.cpp")
    set(script "${PROJECT_SOURCE_DIR}/cmake/write_test_piece.cmake")
    add_custom_command(OUTPUT "${piece}" DEPENDS ${ARGN} "${script}" VERBATIM
        COMMAND "${CMAKE_COMMAND}" "-DPIECE=${piece}" "-DSOURCES=${ARGN}"
            "-DALONE=${DYNCAL_TESTS_ALONE}" "-DROOT=${PROJECT_SOURCE_DIR}" -P "${script}")
    # This warning is raised for every class with a member of a file's own type, unless the file is
    # compiled alone.
    set_source_files_properties("${piece}" PROPERTIES SKIP_AUTOMOC ON
        COMPILE_OPTIONS "$<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>")
    set(${list} ${${list}} "${piece}" PARENT_SCOPE)
endfunction()
