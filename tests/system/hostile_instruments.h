// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/core/capture/formats/foreign/mat73_test_file.h"
#include "tests/core/capture/formats/instruments/lecroy_test_file.h"
#include "tests/core/capture/formats/instruments/rigol_test_file.h"
#include "tests/core/capture/formats/instruments/rohde_test_file.h"
#include "tests/core/capture/formats/instruments/scope_bin_test_file.h"
#include "tests/core/capture/formats/instruments/wav_test_file.h"
#include "tests/core/capture/formats/matlab/mat_test_file.h"
#include "tests/system/hostile_files.h"

#include <fstream>
#include <map>

/// The text fields of oscilloscopes, recorders and MATLAB, each filled as far as it reaches.
namespace dyncal::test {

/// Names are bytes, as the system takes them. Those that begin with "refused" are files of kinds
/// that are not read: their text is to be in the refusal.
using FilesByName = std::map<std::string, QByteArray>;

inline testing::lecroy::Recipe lecroyRecipe(const QByteArray &text)
{
    testing::lecroy::Recipe recipe;
    recipe.interval = 1e-6F;
    recipe.instrument = recipe.label = text.left(16);
    recipe.unit = text.left(48);
    recipe.textBytes = 160;
    recipe.counts.clear();
    for (const double value : signalValues())
        recipe.counts.push_back(static_cast<std::int16_t>(1000.0 * value));
    return recipe;
}

inline void addLecroy(FilesByName &files, const QByteArray &text)
{
    constexpr qsizetype kDescriptorBytes = 346;
    testing::lecroy::Recipe recipe = lecroyRecipe(text);
    const QByteArray note = text.left(recipe.textBytes);
    files["lecroy.trc"] = testing::lecroy::trc(recipe).replace(kDescriptorBytes, note.size(), note);
    files["refused_cut.trc"] = testing::lecroy::trc(recipe).chopped(7);
    recipe.horizontalUnit = text.left(48);
    files["refused_axis.trc"] = testing::lecroy::trc(recipe);
    recipe.layout = "LECROY_" + text.left(9);
    files["refused_template.trc"] = testing::lecroy::trc(recipe);
}

inline void addKeysightAndRigol(FilesByName &files, const QByteArray &text)
{
    testing::scope_bin::Waveform wave;
    wave.interval_s = 1e-6;
    wave.date = wave.time = wave.frame = wave.label = text; // cut by their widths
    const std::vector<double> values = signalValues();
    wave.buffers[0].values.assign(values.begin(), values.end());
    testing::scope_bin::Waveform digital = wave; // is left out by its name
    digital.type = 6;
    // The first part of the frame is the model, what is behind a colon the serial number.
    testing::scope_bin::Waveform serial = wave;
    serial.frame = "m:" + text;
    files["keysight.bin"] = testing::scope_bin::file("AG10", {wave, digital, wave});
    files["keysight_serial.bin"] = testing::scope_bin::file("AG03", {serial});
    files["rigol.bin"] = testing::scope_bin::file("RG03", {wave, digital});
    files["refused_cut.bin"] = testing::scope_bin::file("AG10", {wave}).chopped(5);

    testing::rigol::Recipe memory = testing::rigol::familyB();
    memory.model = "DS1" + text.left(5); // without these letters it would be no model
    files["rigol.wfm"] = testing::rigol::wfm(memory);
    memory.points = 16384;
    files["refused_memory.wfm"] = testing::rigol::wfm(memory);
}

/// The value of an attribute as a writer of XML puts it; the program shows it without a change.
inline QByteArray attribute(QByteArray text)
{
    return text.replace('"', "&quot;").replace('>', "&gt;");
}

inline void addRohde(FilesByName &files, const QByteArray &text)
{
    using testing::rohde::Recipe;
    const QByteArray value = attribute(text);
    Recipe sound;
    sound.rows = kRows + sound.leading;
    sound.length = kRows;
    sound.source = sound.unit = value;
    sound.more = testing::rohde::property(value, value, "UnitName=\"" + value + "\"")
        + testing::rohde::property(text, text); // may end the property, or the list
    const auto add = [&](const std::string &name, auto change) {
        Recipe recipe = sound;
        change(recipe);
        files[name + ".bin"] = testing::rohde::description(recipe);
        return testing::rohde::payload(recipe);
    };
    files["rohde.Wfm.bin"] = add("rohde", [](Recipe &) {});
    files["mixed.Wfm.bin"] = add("mixed", [](Recipe &recipe) { recipe.code = 6; });
    add("refused_format", [&](Recipe &recipe) { recipe.format = value; });
    add("refused_history", [&](Recipe &recipe) { recipe.acquisitions = value; });
    add("refused_trace", [&](Recipe &recipe) { recipe.trace = value; });
    add("refused_time", [&](Recipe &recipe) { recipe.timeUnit = value; });
    add("refused_rows", [&](Recipe &recipe) { recipe.rowsText = value; });
}

/// Chunks of text are passed over, so it is the name of the file that is shown.
inline void addWav(FilesByName &files, const QByteArray &text)
{
    testing::riff::Recipe recipe;
    recipe.frames = kRows;
    const QByteArray even = text.left(1000) + QByteArray(text.left(1000).size() % 2, '\0');
    testing::ByteWriter info;
    for (const char *id : {"INAM", "ICMT"})
        info.text(id).put(static_cast<std::uint32_t>(even.size())).raw(even);
    testing::ByteWriter list;
    list.text("LIST").put(static_cast<std::uint32_t>(4 + info.size())).text("INFO");
    testing::ByteWriter odd; // a chunk that has the text as its name
    odd.text(text, 4).put<std::uint32_t>(0);
    recipe.before = list.raw(info.bytes()).bytes() + odd.bytes();
    files[asName(text.toStdString()) + ".wav"] = testing::riff::wav(recipe);
}

/// A structure of one field: flags, sizes, name, the length of a field's name, the names, numbers.
inline QByteArray structOf(const QByteArray &name)
{
    using namespace testing::level5;
    const auto element = [](std::uint32_t type, const QByteArray &raw) {
        testing::ByteWriter out;
        out.put(type).put(static_cast<std::uint32_t>(raw.size())).raw(raw);
        return out.zeros((8 - raw.size() % 8) % 8).bytes();
    };
    const auto head = [&](int flags, const QByteArray &called) {
        const QByteArray sizes
            = testing::ByteWriter().put<std::int32_t>(1).put<std::int32_t>(1).bytes();
        return element(kMiUInt32, testing::ByteWriter().put(flags).zeros(4).bytes())
            + element(kMiInt32, sizes) + element(kMiInt8, called);
    };
    constexpr std::uint32_t kSmall4 = 4 << 16, kMatrix = 14;
    constexpr std::int32_t kFieldBytes = 64;
    const QByteArray number = testing::ByteWriter().put(1.5).bytes();
    return head(kStruct, name)
        + testing::ByteWriter().put(kSmall4 | kMiInt32).put(kFieldBytes).bytes()
        + element(kMiInt8, name.leftJustified(kFieldBytes, '\0', true))
        + element(kMatrix, head(kDouble, {}) + element(kMiDouble, number));
}

inline void addMatlab5(FilesByName &files, const QByteArray &text)
{
    using namespace testing::level5;
    constexpr qsizetype kLongestName = 63;
    const QByteArray name = text.left(kLongestName);
    const std::vector<double> values = signalValues();
    // The first column looks like times, with another rate than the stated one, if one is stated.
    std::vector<double> table = values;
    for (int row = kRows - 1; row >= 0; --row)
        table.insert(table.begin(), 3e-6 * row);
    const std::vector<std::uint16_t> letters(name.begin(), name.end());
    const auto made = [&](bool compressed) {
        Mat5 file;
        file.add(name, kMiDouble, values, {}, kDouble, compressed)
            .add(name + "2", kMiDouble, table, {kRows, 2}, kDouble, compressed)
            .add<double>(name, kMiDouble, {2.0})
            .add("fs_" + name, kMiDouble, values, {}, kDouble | kComplexFlag)
            .add(name, kMiUInt16, letters, {1, static_cast<std::int32_t>(letters.size())}, kChar)
            .addMatrix(structOf(name), compressed);
        return compressed ? file.bytes() : file.add<double>("fs", kMiDouble, {1e6}).bytes();
    };
    const QByteArray writer = text.left(90); // who wrote it, behind the first words
    files["level5.mat"] = made(false).replace(20, writer.size(), writer);
    files["level5_packed.mat"] = made(true);
    files["refused_integers.mat"]
        = Mat5().add<std::int64_t>(name, kMiInt64, {1, (1LL << 53) + 2, 3}).bytes();
}

inline void writeMatlab73(const std::string &path, const std::string &text)
{
    const std::string name = asName(text);
    std::vector<double> pair = signalValues();
    std::ranges::copy(signalValues(), std::back_inserter(pair));
    {
        const testing::mat73::MatFile file(path);
        file.matrix(name, kRows, 1, signalValues());
        file.matrix(name + "2", kRows, 2, pair);
        file.matrix(name + "3", kRows, 1, signalValues(), text);
        file.matrix("fs", 1, 1, {1e6});
        file.hdf5().group("/" + name + " struct");
        file.hdf5().text("/" + name + " struct", "MATLAB_class", "struct");
        file.hdf5().text("/" + name + " struct", "MATLAB_fields", text);
        file.matrix(name + " struct/" + name, kRows, 1, signalValues());
        file.hdf5().text("/" + name, "units", text);
        file.hdf5().text("/" + name, name, text);
    }
    testing::mat73::writeHead(path);
}

/// Writes all of them into an existing folder.
inline void writeInstrumentFiles(const std::string &folder, const std::string &text)
{
    FilesByName files;
    const QByteArray bytes = QByteArray::fromStdString(text);
    addLecroy(files, bytes);
    addKeysightAndRigol(files, bytes);
    addRohde(files, bytes);
    addWav(files, bytes);
    addMatlab5(files, bytes);
    for (const auto &[name, content] : files)
        std::ofstream(folder + "/" + name, std::ios::binary) << content.toStdString();
    writeMatlab73(folder + "/level73.mat", text);
}

} // namespace dyncal::test
