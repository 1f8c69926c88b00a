// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/core/base/writing/folder_snapshot.h"

#include <filesystem>
#include <fstream>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace dyncal::testing {

/// A laboratory's folder as it may be: recordings, foreign files under names that the program would
/// write, links of both kinds, all at random places, below and beside the output folder "out".
class RandomLayout
{
public:
    RandomLayout(const std::filesystem::path &root, const std::string &capture, unsigned seed)
        : m_root(root)
        , m_random(seed)
    {
        namespace fs = std::filesystem;
        for (const char *folder : {"rec", "out"})
            fs::create_directories(m_root / folder);
        m_recording = place() / pick({"shot1.h5", "shot 2.h5", "results.json", "model.mat"});
        fs::create_directories(m_recording.parent_path());
        fs::copy_file(capture, m_recording);
        for (int i = 0, files = number(0, 8); i < files; ++i)
            putSomething(place()
                / pick({"results.json", "recipe.json", "certificate.pdf", "written.json", "csv",
                    "plots", "model", "a.csv", "01-raw-dut.csv", "notes.txt", "model.mat",
                    "model.json", "new.h5", "job.dyncal", ".dyncal-x", "results.json.part"}));
    }

    const std::filesystem::path &recording() const { return m_recording; }
    std::filesystem::path out() const { return m_root / "out"; }
    int number(int least, int most)
    {
        return std::uniform_int_distribution<int>(least, most)(m_random);
    }
    std::string pick(const std::vector<std::string> &choices)
    {
        return choices[static_cast<std::size_t>(number(0, static_cast<int>(choices.size()) - 1))];
    }

private:
    std::filesystem::path place()
    {
        return m_root / pick({"rec", "out", "out", "out/csv", "out/plots", "out/model", "."});
    }

    void putSomething(const std::filesystem::path &path)
    {
        namespace fs = std::filesystem;
        std::error_code error;
        fs::create_directories(path.parent_path(), error);
        if (error || fs::exists(fs::symlink_status(path, error)))
            return;
        switch (number(0, 5)) {
        case 0:
            fs::create_symlink(m_recording, path, error);
            return;
        case 1:
            fs::create_hard_link(m_recording, path, error);
            return;
        case 2:
            fs::create_directory_symlink(m_root / "rec", path, error);
            return;
        case 3:
            fs::create_directory(path, error);
            std::ofstream(path / "inside.csv") << "inside";
            return;
        default:
            std::ofstream(path) << "foreign " << path.filename().string();
        }
    }

    std::filesystem::path m_root;
    std::mt19937 m_random;
    std::filesystem::path m_recording;
};

/// The first name of `before`, not counting `own`, that is gone or changed; empty if there is none.
inline std::string firstHarmed(
    const Snapshot &before, const Snapshot &now, const std::set<std::string> &own)
{
    for (const auto &[name, content] : before)
        if (!own.contains(name) && (!now.contains(name) || now.at(name) != content))
            return name;
    return {};
}

} // namespace dyncal::testing
