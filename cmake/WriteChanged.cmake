# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later

# write_changed(file text): a file that holds the text already keeps its time, and is not compiled again.
function(write_changed file text)
    if(EXISTS "${file}")
        file(READ "${file}" before)
        if(text STREQUAL before)
            return()
        endif()
    endif()
    file(WRITE "${file}" "${text}")
endfunction()
