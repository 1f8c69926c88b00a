// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/core/capture/formats/bytes/binary_test_support.h"

namespace dyncal::testing::rohde {

/// What a generated pair of files is to be.
struct Recipe
{
    QByteArray format = "FLOAT";
    int channels = 1;
    std::uint32_t code = 4;
    int rows = 12, leading = 2, length = 8;
    double start_s = -1e-3, step_s = 1.25e-6;
    QByteArray acquisitions = "1", trace = "NORMAL", timeUnit = "s", rowsText;
    QByteArray source = "CH3_TR1", unit = "V";
    QByteArray more; ///< properties
    double stopFactor = 1.0, timeShift_s = 0.0;
};

inline double valueOf(int row, int channel)
{
    return 0.25 * row - 1.5 * channel;
}

inline QByteArray property(
    const QByteArray &name, const QByteArray &value, const QByteArray &more = {})
{
    return "\t<Prop Avail=\"0\" ValueKey=\"\" Name=\"" + name + "\" Value=\"" + value + "\" " + more
        + "/>\r\n";
}

inline QByteArray description(const Recipe &recipe)
{
    const auto number = [](double value) { return QByteArray::number(value, 'g', 15); };
    const double stop_s = recipe.start_s + recipe.length * recipe.step_s * recipe.stopFactor;
    QByteArray xml = "<?xml version=\"1.0\" standalone=\"no\"?>\r\n<Database FWVersion=\"\">\r\n";
    xml += property("SignalFormat", "eRS_SIGNAL_FORMAT_" + recipe.format);
    xml += property("NumberOfAcquisitions", recipe.acquisitions);
    xml += property("TraceType", "eRS_TRACE_TYPE_" + recipe.trace);
    xml += property("XStart", number(recipe.start_s), "UnitName=\"" + recipe.timeUnit + "\"");
    xml += property("XStop", number(stop_s), "UnitName=\"s\"");
    xml += property("Resolution", number(recipe.step_s), "UnitName=\"s\"");
    xml += property("SignalHardwareRecordLength",
        recipe.rowsText.isEmpty() ? QByteArray::number(recipe.rows) : recipe.rowsText);
    xml += property("RecordLength", QByteArray::number(recipe.length));
    xml += property("LeadingSettlingSamples", QByteArray::number(recipe.leading));
    xml += property("Source", "eRS_SIGNAL_SOURCE_" + recipe.source);
    const bool several = recipe.channels > 1;
    xml += property("MultiChannelExport", several ? "eRS_ONOFF_ON" : "eRS_ONOFF_OFF");
    QByteArray states = "\t<Prop Name=\"MultiChannelExportState\" Size=\"4\"";
    QByteArray sources = "\t<Prop Name=\"MultiChannelSource\" Size=\"4\"";
    for (int k = 0; k < 4; ++k) { // the first is off, so that its place must be passed over
        const QByteArray place = " I_" + QByteArray::number(k) + "=\"";
        const bool on = several && k >= 1 && k <= recipe.channels;
        states += place + (on ? "eRS_ONOFF_ON" : "eRS_ONOFF_OFF") + "\"";
        sources += place + "eRS_SIGNAL_SOURCE_C" + QByteArray::number(k + 1) + "W1\"";
    }
    xml += states + "/>\r\n" + sources + "/>\r\n";
    xml += property("VerticalScale", "0.4", "StepFactor=\"10\" UnitName=\"V/div\"");
    xml += property("VerticalOffset", "0.5", "UnitName=\"" + recipe.unit + "\"");
    xml += property("VerticalPosition", "-2", "UnitName=\"div\"");
    xml += property("VerticalDivisionCount", "10");
    xml += property("NofQuantisationLevels", "250");
    return xml + recipe.more + "</Database>";
}

inline QByteArray payload(const Recipe &recipe)
{
    ByteWriter out;
    out.put(recipe.code).put(static_cast<std::uint32_t>(recipe.rows));
    for (int row = 0; row < recipe.rows; ++row) {
        if (recipe.code == 6)
            out.put(recipe.start_s + (row - recipe.leading) * recipe.step_s + recipe.timeShift_s);
        for (int c = 0; c < recipe.channels; ++c) {
            if (recipe.code == 0)
                out.put(static_cast<std::int8_t>(row - 5));
            else
                out.put(static_cast<float>(valueOf(row, c)));
        }
    }
    return out.bytes();
}

inline Recipe withTimes()
{
    Recipe recipe;
    recipe.format = "XYDOUBLEFLOAT";
    recipe.code = 6;
    recipe.channels = 2;
    return recipe;
}

inline Recipe counts()
{
    Recipe recipe;
    recipe.format = "INT8BIT";
    recipe.code = 0;
    return recipe;
}

} // namespace dyncal::testing::rohde
