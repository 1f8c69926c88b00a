# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Writes PIECE, which compiles the tests SOURCES as one (TestsTogether.cmake). Their headers come first,
# outside of the namespaces; inside, their include guards make them empty. Places are seen from ROOT, so
# that the compiler cache knows the piece in another clone.
set(headers "")
set(tests "")
foreach(source IN LISTS SOURCES)
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
file(WRITE "${PIECE}" "${headers}\n${tests}")
