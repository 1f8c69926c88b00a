# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Most of what a test costs to compile are templates that every other test of its room instantiates too;
# so with DYNCAL_UNITY (UnityRooms.cmake) up to DYNCAL_UNITY_MOST are compiled as one piece: 24 in one
# take two thirds of the time of three pieces. In it each stands in a
# namespace of its own, after the headers of all; write_test_pieces.cmake makes the pieces.

# What cannot stand in a namespace, and macros that the next test would see: such a test stays alone.
set(DYNCAL_TESTS_ALONE
    "^namespace (dyncal|QTest|std)|^Q_DECLARE_METATYPE|^extern|^template <>|^ *#define")

# dyncal_pieces_of_tests(pieces program source...): sets `pieces` to what the program is compiled of.
function(dyncal_pieces_of_tests pieces program)
    set(together "")
    set(compiled "")
    foreach(source IN LISTS ARGN)
        file(STRINGS "${source}" alone LIMIT_COUNT 1 REGEX "${DYNCAL_TESTS_ALONE}")
        if(DYNCAL_UNITY AND NOT alone)
            list(APPEND together "${source}")
        else()
            list(APPEND compiled "${source}")
        endif()
    endforeach()
    set(made "")
    if(together)
        dyncal_test_pieces(made ${program} ${together})
    endif()
    set(${pieces} ${compiled} ${made} PARENT_SCOPE)
endfunction()

# Sets `made` to the pieces of these sources, which one command writes.
function(dyncal_test_pieces made program)
    set(prefix "${CMAKE_CURRENT_BINARY_DIR}/pieces/${program}")
    set(script "${PROJECT_SOURCE_DIR}/cmake/write_test_pieces.cmake")
    list(LENGTH ARGN count)
    math(EXPR last "(${count} - 1) / ${DYNCAL_UNITY_MOST}")
    math(EXPR most "(${count} + ${last}) / (${last} + 1)") # pieces of the same size
    math(EXPR last "(${count} - 1) / ${most}")
    set(list "")
    foreach(number RANGE ${last})
        list(APPEND list "${prefix}_${number}.cpp")
    endforeach()
    add_custom_command(OUTPUT ${list} DEPENDS ${ARGN} "${script}" VERBATIM
        COMMAND "${CMAKE_COMMAND}" "-DPREFIX=${prefix}" "-DSOURCES=${ARGN}"
            "-DMOST=${most}" "-DALONE=${DYNCAL_TESTS_ALONE}"
            "-DROOT=${PROJECT_SOURCE_DIR}" -P "${script}")
    # This warning is raised for every class with a member of a file's own type, unless the file is
    # compiled alone.
    set_source_files_properties(${list} PROPERTIES
        COMPILE_OPTIONS "$<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>")
    set(${made} ${list} PARENT_SCOPE)
endfunction()
