// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/capture/capture_set.h"
#include "core/capture/formats/text/text_table.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dyncal {

/// Tag -> the cells after it, as in the file (views into its text).
using LvmTags = std::map<std::string_view, std::vector<std::string_view>>;

enum class LvmXColumns { None, One, Multi };

/// What the head of the file says of all segments.
struct LvmFileHeader
{
    char separator = '\t';
    std::optional<char> decimal; ///< not stated before version 8.6
    LvmXColumns xColumns = LvmXColumns::One;
    bool commaTwice = false; ///< separator and decimal mark: the cells cannot be told apart
    Attributes notes;
};

struct LvmChannel
{
    std::string name;
    std::string unit;
    Index column = 0; ///< of its values
    std::optional<Index> xColumn;
    double xUnit_s = 1.0; ///< seconds per unit of x0, deltaX and the X cells
    double x0 = 0.0;
    double deltaX = 0.0; ///< 0 = not stated
    double deltaResolution = 0.0; ///< one unit of the last digit printed of deltaX
    std::optional<Index> declaredSamples;
};

struct LvmSegment
{
    std::vector<LvmChannel> channels;
    Index namedChannels = 0; ///< in the line of column names; those not declared are not read
    Attributes notes;
};

/// Reads tag lines from `line` on (empty: from the next one) up to the end of the header; false if
/// the text ends before that or the header exceeds 4 MiB. Special blocks are skipped.
bool readLvmTags(LineCursor &lines, std::string_view line, char separator, LvmTags &tags);

/// The separator stands right behind a tag of the first lines.
char lvmSeparator(std::string_view text);

LvmFileHeader lvmFileHeader(const LvmTags &tags, char separator);

/// What a channel of the segment lies along if that is not time ("Frequency", "m"); else empty.
std::string otherThanTime(const LvmTags &tags);

/// Channels from the tags of a segment and its line of column names; empty if that line has fewer
/// columns than the tags claim, or none.
std::optional<LvmSegment> lvmSegment(
    const LvmTags &tags, std::string_view columnLine, const LvmFileHeader &file);

} // namespace dyncal
