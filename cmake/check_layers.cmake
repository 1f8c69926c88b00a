# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Checks the dependency rule of docs/architecture.md: cmake -DROOT=... -P check_layers.cmake
# core knows no Qt; inside core and ui a folder includes only folders before it in its list; plots
# only in ui/plot; nothing includes upward.
set(errors "")

# A file includes only files of its own room and of rooms before it in its layer's list.
set(rooms_of_core base base/writing xml signing pdf capture
    capture/formats/bytes capture/formats/text capture/formats/lvm capture/formats/tdms
    capture/formats/hdf5 capture/formats/foreign capture/formats/matlab
    capture/formats/instruments capture/formats/preview capture/opening
    signal shock dcc_reading reference decomposition
    realization/exponentials realization/input realization/hankel realization/refinement
    realization/nuisance realization/second_order realization/model realization/order
    model_analysis consistency uncertainty monte_carlo project pipeline certificate results dcc issue batch correction
    recheck history synthesis selftest)
set(rooms_of_registry trail store cards certificates issued)
set(rooms_of_ui text session plot/values plot/curves plot/qcp plot/widget report
    stages/frame stages/candidates stages/shock stages/window stages/spectrum stages/model
    stages/order stages/uncertainty stages/comparison stages/certificate stages
    shell/banner shell/preferences shell/import shell/findings shell/files shell/program
    shell/batch shell/registry shell/recovery shell/tips shell/correction shell)

function(check_room layer file line)
    string(REGEX REPLACE "^${layer}/(.*)/[^/]*$" "\\1" room "${file}")
    list(FIND rooms_of_${layer} "${room}" rank)
    if(rank LESS 0)
        list(APPEND errors "${file}: '${room}' is not in the list of the rooms of ${layer}")
    elseif(line MATCHES "[\"<]${layer}/(.*)/[^/]*$")
        list(FIND rooms_of_${layer} "${CMAKE_MATCH_1}" used)
        if(used LESS 0 OR used GREATER rank)
            list(APPEND errors "${file}: ${line}: '${room}' may include only rooms before it")
        endif()
    elseif(line MATCHES "\"[^/\"]*\"")
        list(APPEND errors "${file}: ${line}: the path begins at the top of the project")
    endif()
    set(errors "${errors}" PARENT_SCOPE)
endfunction()

file(GLOB_RECURSE core_files RELATIVE "${ROOT}" "${ROOT}/core/*.h" "${ROOT}/core/*.cpp")
foreach(file IN LISTS core_files)
    file(STRINGS "${ROOT}/${file}" includes REGEX "^#include")
    foreach(line IN LISTS includes)
        check_room(core "${file}" "${line}")
        if(line MATCHES "<Q|[\"<](registry|ui|app|tests)/|qcustomplot")
            list(APPEND errors "${file}: ${line}: core must know nothing of Qt, ui and app")
        endif()
        if(line MATCHES "\"core/capture/formats/"
            AND NOT file MATCHES "^core/(capture/formats|capture/opening|synthesis|selftest)/")
            list(APPEND errors "${file}: ${line}: only core/capture/opening knows the readers")
        endif()
        if(line MATCHES "Eigen/SVD" AND NOT file STREQUAL "core/base/svd.cpp")
            list(APPEND errors "${file}: ${line}: SVD code belongs to core/base/svd.cpp (compile time)")
        endif()
    endforeach()
endforeach()

file(GLOB_RECURSE registry_files RELATIVE "${ROOT}" "${ROOT}/registry/*.h"
    "${ROOT}/registry/*.cpp")
foreach(file IN LISTS registry_files)
    file(STRINGS "${ROOT}/${file}" includes REGEX "^#include")
    foreach(line IN LISTS includes)
        check_room(registry "${file}" "${line}")
        if(line MATCHES "[\"<](ui|app|tests)/|<(QApplication|QWidget|QtGui|QtWidgets)")
            list(APPEND errors "${file}: ${line}: the registry knows core, Qt Core and Qt Sql only")
        endif()
    endforeach()
endforeach()

file(GLOB_RECURSE ui_files RELATIVE "${ROOT}" "${ROOT}/ui/*.h" "${ROOT}/ui/*.cpp")
foreach(file IN LISTS ui_files)
    file(STRINGS "${ROOT}/${file}" includes REGEX "^#include")
    foreach(line IN LISTS includes)
        if(line MATCHES "[\"<](app|tests)/")
            list(APPEND errors "${file}: ${line}: ui must not include app")
        endif()
        check_room(ui "${file}" "${line}")
        if(line MATCHES "qcustomplot" AND NOT file MATCHES "^ui/plot/(qcp/|widget/[a-z_]+\\.cpp$)")
            list(APPEND errors "${file}: ${line}: only sources in ui/plot know QCustomPlot")
        endif()
        if(line MATCHES "\"ui/plot/qcp/" AND NOT file MATCHES "^ui/plot/")
            list(APPEND errors "${file}: ${line}: QCustomPlot stays inside ui/plot")
        endif()
        # The order of the rooms would allow it, but they get everything as values.
        if(line MATCHES "\"ui/session/" AND file MATCHES "^ui/(plot|report)/")
            list(APPEND errors "${file}: ${line}: plots and reports know values only")
        endif()
    endforeach()
endforeach()

# ui and app open files through core/capture/opening. What an import dialog shows before a file is
# read is theirs too, and the program writes captures.
file(GLOB_RECURSE front_files RELATIVE "${ROOT}" "${ROOT}/ui/*.h" "${ROOT}/ui/*.cpp"
    "${ROOT}/app/*.h" "${ROOT}/app/*.cpp")
foreach(file IN LISTS front_files)
    file(STRINGS "${ROOT}/${file}" includes REGEX "^#include \"core/capture/formats/")
    foreach(line IN LISTS includes)
        if(NOT line MATCHES "\"core/capture/formats/preview/"
            AND NOT (file MATCHES "^app/" AND line MATCHES "/hdf5_capture_writer\\.h\""))
            list(APPEND errors "${file}: ${line}: only core/capture/opening knows the readers")
        endif()
    endforeach()
endforeach()

if(errors)
    list(JOIN errors "\n" text)
    message(FATAL_ERROR "Dependency rule broken:\n${text}")
endif()
list(LENGTH core_files core_count)
list(LENGTH ui_files ui_count)
message(STATUS "Dependency rule holds in ${core_count} core and ${ui_count} ui files")
