// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace dyncal {

// What a quantity of a certificate is by its name (English, German, Swedish) and its refTypes. Of a
// name the parts count that say what it is: "Sensitivity (k = 2)" has two, and of "Sensitivity at
// the nominal pressure" that before "at".

/// Whether they say that it is about a value and not the value: an error, deviation, uncertainty,
/// change, limit, coefficient, nominal or reference value, the transverse direction. The refTypes
/// dyncal_... never do, and of those with vib_... the name does not count.
bool isAboutAValue(const std::string &name, const std::vector<std::string> &refTypes);

/// The same of frequencies that a list is over, which may be nominal ones, but no width of a band.
/// basic_tableIndex0 counts as vib_... does.
bool isAboutAFrequency(const std::string &name, const std::vector<std::string> &refTypes);

/// Whether what it is ends with one of the words: "Undamped natural frequency of the sensor", and
/// neither "Uncertainty of the natural frequency" nor "Natural frequency, change".
bool isCalled(const std::string &name, const std::vector<std::string_view> &words);

/// Whether it is of the surroundings: temperature, humidity.
bool isOfSurroundings(const std::string &name, const std::vector<std::string> &refTypes);

} // namespace dyncal
