// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/writing/folder_write.h"
#include "tests/core/base/writing/opened_folder.h"

#include <QtGlobal>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace dyncal::testing {

inline bool isOwn(const std::string &name)
{
    return name == "results.json" || name == "certificate.pdf" || name.starts_with("csv/");
}

inline FolderRequest requestFor(const std::string &folder)
{
    return {folder, "run", isOwn, {"results.json", "certificate.pdf", "csv/"}, {}, {}};
}

inline const std::vector<FolderFile> kOld{
    {"results.json", "old"}, {"certificate.pdf", "old pdf"}, {"csv/a.csv", "1"}};
inline const std::vector<FolderFile> kNew{
    {"results.json", "new"}, {"csv/a.csv", "2"}, {"csv/b.csv", "3"}};

inline Result<void> write(const FolderRequest &request, const std::vector<FolderFile> &files)
{
    Result<FolderWrite> folder = FolderWrite::begin(request);
    return folder ? folder->commit(files) : Result<void>(tl::unexpected(folder.error()));
}

inline std::string sentenceOf(const Result<void> &done)
{
    return done ? std::string() : english(done.error().message);
}

/// A folder "out" in a place of its own, as a case needs it.
struct Case
{
    const char *name;
    bool exists;
    std::function<void(const std::filesystem::path &out)> prepare; ///< what else lies there
    bool isExchanged; ///< in one step
};

inline void nothing(const std::filesystem::path &) { }

inline const std::vector<Case> &cases()
{
    static const std::vector<Case> all{
        {"no folder yet", false, nothing, true},
        {"an earlier run", true, nothing, true},
        {"files of somebody else", true,
            [](const std::filesystem::path &out) {
                put(out / "notes.txt", "mine");
                put(out / "csv/mine.csv", "mine");
                std::filesystem::create_symlink("/etc/hostname", out / "link");
            },
            true},
        {"a folder of somebody else", true,
            [](const std::filesystem::path &out) { put(out / "photos/1.jpg", "mine"); }, false},
        {"an access list", true,
            [](const std::filesystem::path &out) {
                put(out / "photos/1.jpg", "mine");
                put(out / "csv/mine.csv", "mine");
            },
            false},
    };
    return all;
}

struct Laid
{
    ScratchFolder place;
    std::filesystem::path out = place.file("out");
    Snapshot before;
    Snapshot after;
};

/// The case with an earlier run in it, and what a whole write makes of it.
inline void lay(Laid &laid, const Case &wanted)
{
    const auto make = [&](const std::filesystem::path &out) {
        if (wanted.exists && !write(requestFor(out.string()), kOld))
            qFatal("the earlier run cannot be written");
        if (wanted.exists)
            wanted.prepare(out);
    };
    make(laid.out);
    laid.before = snapshotOf(laid.out);
    const ScratchFolder other;
    make(other.file("out"));
    if (!write(requestFor(other.file("out")), kNew))
        qFatal("the new run cannot be written");
    laid.after = snapshotOf(other.file("out"));
}

} // namespace dyncal::testing
