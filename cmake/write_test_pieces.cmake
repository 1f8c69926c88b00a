# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Writes PREFIX_0.cpp and so on, each of which compiles MOST of the tests SOURCES as one
# (TestsTogether.cmake). Their headers come first, outside of the namespaces; inside, their include
# guards make them empty. Places are seen from ROOT, so that the compiler cache knows the piece in
# another clone. A piece that is the same stays, and is not compiled again.
include("${CMAKE_CURRENT_LIST_DIR}/WriteChanged.cmake")
function(write_piece file)
    set(headers "")
    set(tests "")
    foreach(source IN LISTS ARGN)
        file(STRINGS "${source}" alone LIMIT_COUNT 1 REGEX "${ALONE}")
        if(alone)
            message(FATAL_ERROR "${source} cannot be compiled with others any more, because of "
                "\"${alone}\": configure again (cmake --preset release).")
        endif()
        file(STRINGS "${source}" included REGEX "^#include .*[^c][\">]$")
        list(APPEND headers ${included})
        get_filename_component(name "${source}" NAME_WE)
        file(RELATIVE_PATH place "${ROOT}" "${source}")
        string(APPEND tests "namespace in_${name} {\n#include \"${place}\"\n}\n")
    endforeach()
    list(REMOVE_DUPLICATES headers)
    list(JOIN headers "\n" headers)
    write_changed("${file}" "${headers}\n${tests}")
endfunction()

list(LENGTH SOURCES count)
math(EXPR last "(${count} - 1) / ${MOST}")
foreach(number RANGE ${last})
    math(EXPR begin "${number} * ${MOST}")
    list(SUBLIST SOURCES ${begin} ${MOST} sources)
    write_piece("${PREFIX}_${number}.cpp" ${sources})
endforeach()
