// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/core/capture/capture_test_support.h"

#include <QByteArray>
#include <QList>

#include <algorithm>
#include <string>
#include <vector>

namespace dyncal::testing {

/// What a generated file is to be; channel c holds value(c, k).
struct LvmRecipe
{
    QByteArray xColumns = "One";
    char separator = '\t';
    char decimal = '.';
    bool decimalTag = true;
    bool multiHeadings = true;
    int channels = 2;
    QList<int> rows{8, 8}; ///< per channel
    int segments = 1;
    double delta = 1e-5;
    int declaredMore = 0;
    QByteArray unit = "V";
    QByteArray comment = {};
    QByteArray lineEnd = "\r\n";
};

inline double value(int channel, int row)
{
    return (channel + 1) * 0.125 + row * (channel == 0 ? 1.0 : -2.0);
}

inline QByteArray number(double x, char decimal)
{
    return QByteArray::number(x, 'f', 6).replace('.', decimal);
}

/// One line of the file; tags repeat per channel where the column of that channel is.
inline QByteArray tagLine(
    const LvmRecipe &recipe, const QByteArray &tag, const QList<QByteArray> &cells)
{
    QByteArray line = tag;
    for (const QByteArray &cell : cells) {
        line += recipe.separator + cell;
        if (recipe.xColumns == "Multi")
            line += recipe.separator;
    }
    return line + recipe.lineEnd;
}

inline QByteArray segment(const LvmRecipe &recipe, bool header)
{
    QByteArray text;
    const QByteArray sep(1, recipe.separator);
    const auto each = [&](auto cell) {
        QList<QByteArray> cells;
        for (int c = 0; c < recipe.channels; ++c)
            cells += cell(c);
        return cells;
    };
    if (header) {
        text += tagLine(recipe, "Channels", {QByteArray::number(recipe.channels)});
        text += tagLine(recipe, "Samples",
            each([&](int c) { return QByteArray::number(recipe.rows[c] + recipe.declaredMore); }));
        text += tagLine(recipe, "Unknown_Tag", {"what", "ever"});
        text += tagLine(recipe, "Date", each([](int) { return QByteArray("2024/05/06"); }));
        text += tagLine(recipe, "Time", each([](int) { return QByteArray("01:02:03.5"); }));
        text += tagLine(recipe, "Y_Unit_Label", each([&](int) { return recipe.unit; }));
        text += tagLine(recipe, "X0", each([&](int) { return number(-0.5, recipe.decimal); }));
        text += tagLine(recipe, "Delta_X", each([&](int) {
            return QByteArray::number(recipe.delta, 'E', 6).replace('.', recipe.decimal);
        }));
        text += "***End_of_Header***" + sep + recipe.lineEnd;
        const bool multi = recipe.xColumns == "Multi";
        for (int c = 0; c < recipe.channels; ++c)
            text += (c == 0 || multi ? "X_Value" + sep : QByteArray()) + "ch "
                + QByteArray::number(c) + sep;
        text += "Comment" + recipe.lineEnd;
    }
    const int rows = *std::max_element(recipe.rows.begin(), recipe.rows.end());
    for (int k = 0; k < rows; ++k) {
        QList<QByteArray> cells;
        for (int c = 0; c < recipe.channels; ++c) {
            const QByteArray x
                = QByteArray::number(-0.5 + k * recipe.delta, 'E', 9).replace('.', recipe.decimal);
            const bool there = k < recipe.rows[c];
            if (recipe.xColumns == "Multi" || c == 0)
                cells += recipe.xColumns == "No" || !there ? QByteArray() : x;
            cells += there ? number(value(c, k), recipe.decimal) : QByteArray();
        }
        text += cells.join(sep);
        if (k == 2 && !recipe.comment.isEmpty())
            text += sep + recipe.comment;
        text += recipe.lineEnd;
    }
    return text + recipe.lineEnd;
}

inline QByteArray lvm(const LvmRecipe &recipe)
{
    const QByteArray sep(1, recipe.separator);
    QByteArray text;
    const QList<QList<QByteArray>> tags{{"LabVIEW Measurement", ""}, {"Writer_Version", "2"},
        {"Separator", recipe.separator == ',' ? "Comma" : "Tab"},
        {"Multi_Headings", recipe.multiHeadings ? "Yes" : "No"}, {"X_Columns", recipe.xColumns},
        {"Operator", "J\xF8rgen"}, {"Date", "1903/12/31"}};
    for (const QList<QByteArray> &tag : tags)
        text += tag.join(sep) + recipe.lineEnd;
    if (recipe.decimalTag)
        text += "Decimal_Separator" + sep + recipe.decimal + recipe.lineEnd;
    text += "***Start_Special***" + recipe.lineEnd + "X_Columns" + sep + "Bogus" + recipe.lineEnd
        + "***End_Special***" + recipe.lineEnd;
    text += "***End_of_Header***" + sep + recipe.lineEnd + sep + recipe.lineEnd;
    for (int s = 0; s < recipe.segments; ++s)
        text += segment(recipe, recipe.multiHeadings || s == 0);
    return text;
}

inline std::vector<double> valuesOf(const Channel &channel)
{
    std::vector<double> values;
    for (Index i = 0; i < channel.samples.size(); ++i)
        values.push_back(channel.samples.at(i));
    return values;
}

/// Every value, rate and name that the recipe put in.
inline bool isAsMade(const CaptureSet &set, const LvmRecipe &recipe)
{
    bool good = set.shots.size() == std::size_t(recipe.segments);
    for (const Shot &shot : set.shots) {
        good = good && shot.channels.size() == std::size_t(recipe.channels);
        for (int c = 0; good && c < recipe.channels; ++c) {
            const Channel &channel = shot.channels[std::size_t(c)];
            const std::vector<double> values = valuesOf(channel);
            good = values.size() == std::size_t(recipe.rows[c]) && channel.t0_s == -0.5
                && channel.sampleRate_Hz == 1.0 / recipe.delta && channel.role == ChannelRole::Other
                && channel.name == "ch " + std::to_string(c);
            for (int k = 0; good && k < recipe.rows[c]; ++k)
                good = values[std::size_t(k)] == value(c, k);
        }
    }
    return good;
}

} // namespace dyncal::testing
