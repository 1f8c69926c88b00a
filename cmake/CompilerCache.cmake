# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later

# ccache where present: a rebuild after a clone costs seconds. Precompiled headers need the two
# sloppiness flags, otherwise every compilation that uses one misses the cache.
find_program(DYNCAL_CCACHE ccache)
if(DYNCAL_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_COMMAND}" -E env
        CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
        CCACHE_NOHASHDIR=1 "CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}" "${DYNCAL_CCACHE}")
endif()
