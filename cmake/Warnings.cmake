# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later

# dyncal_options: the compile options of every target of this project.
add_library(dyncal_options INTERFACE)
target_compile_options(dyncal_options INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor -Wold-style-cast
    # g++ 12 raises these falsely on joined strings (GCC bugs 105329, 105651).
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-stringop-overflow -Wno-array-bounds>
    # Results must be the same on every amd64 machine: no contraction into fused operations.
    -ffp-contract=off
    # Needed for precompiled headers to be cached.
    $<$<COMPILE_LANGUAGE:CXX>:-fpch-preprocess>)
if(DYNCAL_WERROR)
    target_compile_options(dyncal_options INTERFACE -Werror)
endif()
if(DYNCAL_SANITIZE)
    # As g++ says it of itself; clang does not.
    target_compile_options(dyncal_options INTERFACE -fsanitize=address,undefined -fno-omit-frame-pointer
        $<$<CXX_COMPILER_ID:Clang>:-D__SANITIZE_ADDRESS__=1>)
    target_link_options(dyncal_options INTERFACE -fsanitize=address,undefined)
endif()
