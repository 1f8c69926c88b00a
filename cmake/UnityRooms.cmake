# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later

# A room (folder) is compiled in few pieces, so that the headers that its sources share are parsed
# once: a first build takes far less time. Off in the preset dev, where one changed source should be
# compiled alone, and where a missing include is noticed.
option(DYNCAL_UNITY "Compile the sources of a room together" OFF)
set(DYNCAL_UNITY_MOST 24 CACHE STRING "Sources in a piece at most")

# dyncal_unite_rooms(target layer [ALONE source...]): a room is one piece as far as it has no more than
# DYNCAL_UNITY_MOST sources, which takes half the compile time of pieces of six; those after ALONE, which
# take longest, are compiled beside them.
function(dyncal_unite_rooms target layer)
    cmake_parse_arguments(PARSE_ARGV 2 arg "" "" "ALONE")
    if(NOT DYNCAL_UNITY)
        return()
    endif()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    # This warning is raised for every class with a member of a file's own type, unless the file is
    # compiled alone.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
    get_target_property(sources ${target} SOURCES)
    list(FILTER sources INCLUDE REGEX "/${layer}/.*\\.cpp$")
    foreach(source IN LISTS sources)
        string(REGEX MATCH "/${layer}/([a-z0-9_/]+)/[^/]*$" in_room "${source}")
        set(room "${CMAKE_MATCH_1}")
        get_filename_component(name "${source}" NAME)
        if(NOT in_room OR name IN_LIST arg_ALONE)
            continue()
        endif()
        string(MAKE_C_IDENTIFIER "${room}" group)
        math(EXPR count_${group} "${count_${group}} + 1")
        math(EXPR piece "(${count_${group}} - 1) / ${DYNCAL_UNITY_MOST}")
        set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${group}_${piece}")
    endforeach()
endfunction()
