// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

// Included before anything else of a source that uses qpdf (core/CMakeLists.txt), for clang
// (sanitizers, clang-tidy): with libstdc++ 12 it asks whether the destructor of a vector of JSON,
// in a class nested in JSON, is constexpr before JSON is complete, and fails. A list it need not
// ask. The nested class is private, and only the library itself makes one.
#ifdef __clang__
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <qpdf/PointerHolder.hh>

#define vector list
#include <qpdf/JSON.hh>
#undef vector
#endif
