# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Writes into FOLDER what MOC makes of FILES below ROOT (Moc.cmake): NAME.moc of NAME.cpp, and mocs.cpp of
# all headers. A file that is the same stays.
include("${CMAKE_CURRENT_LIST_DIR}/WriteChanged.cmake")

set(headers "")
foreach(file IN LISTS FILES)
    file(RELATIVE_PATH place "${ROOT}" "${file}")
    set(include -i)
    if(file MATCHES "\\.h$")
        set(include -f "${place}")
    endif()
    execute_process(COMMAND "${MOC}" ${include} "${place}" WORKING_DIRECTORY "${ROOT}"
        OUTPUT_VARIABLE made RESULT_VARIABLE failed)
    if(failed)
        message(FATAL_ERROR "moc failed for ${file}")
    endif()
    get_filename_component(name "${file}" NAME_WE)
    if(file MATCHES "\\.h$")
        string(APPEND headers "${made}")
    else()
        write_changed("${FOLDER}/${name}.moc" "${made}")
    endif()
endforeach()
if(headers)
    write_changed("${FOLDER}/mocs.cpp" "${headers}")
endif()
