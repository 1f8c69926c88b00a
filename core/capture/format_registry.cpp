// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/format_registry.h"

#include "core/base/content_hash.h"
#include "core/capture/file_kind.h"
#include "core/capture/formats/delimited_text.h"
#include "core/capture/formats/hdf5_capture.h"
#include "core/capture/formats/lvm.h"
#include "core/capture/formats/scope_bin.h"
#include "core/capture/formats/wav.h"
#include "core/capture/natural_order.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace dyncal {
namespace {

namespace fs = std::filesystem;

/// One file to read; whoever named it himself must get it or hear why not.
struct Candidate
{
    std::string path;
    bool named = true;
};

Result<std::string> headOf(const std::string &path)
{
    constexpr std::size_t kHeadBytes = 64 * 1024;
    std::error_code error;
    if (!fs::exists(path, error))
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core", "%1 does not exist; check the name and the folder."), {path}},
            "CAP-018");
    if (!fs::is_regular_file(path, error))
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "%1 is a folder or a device, not a file; name a file. Readable "
                 "are: %2."),
                {path, readableFormatsText()}},
            "CAP-001");
    std::ifstream file(path, std::ios::binary);
    std::string head(kHeadBytes, '\0');
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    if (file.bad() || !file.is_open())
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "%1 cannot be opened; check that you may read it and that no "
                 "other program holds it."),
                {path}},
            "CAP-018");
    head.resize(static_cast<std::size_t>(file.gcount()));
    return head;
}

Result<const CaptureFormat *> formatNamed(const std::string &id)
{
    std::string known = "auto";
    for (const CaptureFormat &format : captureFormats()) {
        if (format.id == id)
            return &format;
        known += ", " + format.id;
    }
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core", "There is no import format \"%1\"; choose one of %2."), {id, known}});
}

Result<const CaptureFormat *> formatOf(const std::string &path, const ImportSettings &settings)
{
    const Result<std::string> head = headOf(path);
    if (!head)
        return tl::unexpected(head.error());
    if (settings.format != "auto")
        return formatNamed(settings.format);
    const CaptureFormat *best = nullptr;
    int bestScore = 0;
    for (const CaptureFormat &format : captureFormats()) {
        const int score = format.recognise(path, *head);
        if (score > bestScore) {
            bestScore = score;
            best = &format;
        }
    }
    constexpr int kCertain = 100;
    if (best == nullptr || (bestScore < kCertain && isForeignFile(*head)))
        return unknownFile(path, *head, readableFormatsText());
    return best;
}

InputFile inputOf(const std::string &path, const CaptureFormat &format)
{
    return {path, fs::path(path).filename().string(), sha256OfFile(path), format.id};
}

Result<std::vector<Candidate>> filesIn(const std::string &folder)
{
    std::vector<Candidate> files;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const bool hidden = entry->path().filename().string().starts_with('.');
        std::error_code unknown;
        if (!hidden && entry->is_regular_file(unknown))
            files.push_back({entry->path().string(), false});
    }
    if (error)
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core", "The folder %1 cannot be listed; check that you may read it."),
                {folder}},
            "CAP-018");
    std::sort(files.begin(), files.end(),
        [](const Candidate &a, const Candidate &b) { return naturalLess(a.path, b.path); });
    return files;
}

/// A file in a folder that is no recording is normal; one that should be one is not.
Finding skippedFile(const Error &error)
{
    const bool foreign = error.findingId == "CAP-001";
    return {"CAP-024", foreign ? Severity::Info : Severity::Caution, 0, {}, {},
        {DYNCAL_TEXT("core", "A file of the folder was left out. %1"), {english(error.message)}},
        {}, {}};
}

void append(CaptureSet &all, CaptureSet part)
{
    const Index offset = static_cast<Index>(all.inputs.size());
    for (Shot &shot : part.shots)
        shot.input += offset;
    const Index shotOffset = static_cast<Index>(all.shots.size());
    for (Finding &finding : part.findings)
        finding.shot += finding.shot > 0 ? shotOffset : 0;
    std::move(part.inputs.begin(), part.inputs.end(), std::back_inserter(all.inputs));
    std::move(part.shots.begin(), part.shots.end(), std::back_inserter(all.shots));
    std::move(part.findings.begin(), part.findings.end(), std::back_inserter(all.findings));
    if (all.tube.empty())
        all.tube = std::move(part.tube);
    all.sensors.merge(part.sensors); // keeps what is there: the first file that has it counts
    all.instruments.merge(part.instruments);
}

Findings findingsOfEqualInputs(const std::vector<InputFile> &inputs)
{
    Findings findings;
    for (std::size_t i = 1; i < inputs.size(); ++i) {
        const auto end = inputs.begin() + static_cast<std::ptrdiff_t>(i);
        const auto twin = std::find_if(inputs.begin(), end, [&](const InputFile &input) {
            return !input.sha256.empty() && input.sha256 == inputs[i].sha256;
        });
        if (twin != end)
            findings.push_back({"CAP-011", Severity::Caution, 0, {}, {},
                {DYNCAL_TEXT("core",
                     "%1 and %2 hold identical data; a shot counted twice makes the scatter look "
                     "smaller than it is. Take one of them out."),
                    {twin->path, inputs[i].path}},
                {}, {}});
    }
    return findings;
}

/// Joins files as they come and collects what went wrong with any of them.
class CaptureJoiner
{
public:
    void add(const Candidate &file, Result<CaptureSet> part)
    {
        if (part)
            append(m_set, std::move(*part));
        else if (file.named)
            addProblem(part.error());
        else
            m_set.findings.push_back(skippedFile(part.error()));
    }

    void addProblem(const Error &error) { m_problems.push_back(error); }

    Result<CaptureSet> finish()
    {
        if (!m_problems.empty())
            return tl::unexpected(joinedProblem());
        if (m_set.shots.empty())
            return tl::unexpected(nothingRead());
        const Findings equal = findingsOfEqualInputs(m_set.inputs);
        m_set.findings.insert(m_set.findings.end(), equal.begin(), equal.end());
        return std::move(m_set);
    }

private:
    Error joinedProblem() const
    {
        Error joined = m_problems.front();
        if (m_problems.size() == 1)
            return joined;
        std::string sentences;
        for (const Error &problem : m_problems)
            sentences.append("\n").append(english(problem.message));
        joined.message = {DYNCAL_TEXT("core", "%1 of the inputs cannot be read:%2"),
            {std::to_string(m_problems.size()), sentences}};
        return joined;
    }

    Error nothingRead() const
    {
        std::string sentences;
        for (const Finding &finding : m_set.findings)
            sentences.append("\n").append(english(finding.message));
        return {ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core", "No recording was found in the inputs; readable are: %1.%2"),
                {readableFormatsText(), sentences}},
            "CAP-001", 0};
    }

    CaptureSet m_set;
    std::vector<Error> m_problems;
};

JobControl partOf(const JobControl &control, std::size_t index, std::size_t count)
{
    const auto place = [=](double fraction) {
        return (static_cast<double>(index) + fraction) / static_cast<double>(count);
    };
    return {control.stop, [&control, place](double fraction) { control.report(place(fraction)); }};
}

} // namespace

const std::vector<CaptureFormat> &captureFormats()
{
    static const std::vector<CaptureFormat> formats{
        {"dyncal-capture", "HDF5 capture", {"h5", "hdf5"}, &recogniseHdf5Capture, &readHdf5Capture},
        {"lvm", "LabVIEW measurement", {"lvm"}, &recogniseLvm, &readLvm},
        {"keysight-bin", "Keysight/Agilent waveform", {"bin"}, &recogniseKeysightBin,
            &readKeysightBin},
        {"rigol-bin", "Rigol waveform", {"bin"}, &recogniseRigolBin, &readRigolBin},
        {"wav", "WAV", {"wav", "rf64", "bw64"}, &recogniseWav, &readWav},
        {"text", "text table", {"csv", "tsv", "txt", "dat"}, &recogniseDelimitedText,
            &readDelimitedText},
    };
    return formats;
}

std::string readableFormatsText()
{
    std::string text;
    for (const CaptureFormat &format : captureFormats()) {
        text += (text.empty() ? "" : ", ") + format.title + " (";
        for (std::size_t i = 0; i < format.extensions.size(); ++i)
            text += (i == 0 ? "." : ", .") + format.extensions[i];
        text += ")";
    }
    return text;
}

Result<CaptureSet> readCapture(
    const std::string &path, const ImportSettings &settings, const JobControl &control)
{
    const Result<const CaptureFormat *> format = formatOf(path, settings);
    if (!format)
        return tl::unexpected(format.error());
    Result<CaptureSet> set = (*format)->read(path, settings, control);
    if (!set)
        return set;
    set->inputs = {inputOf(path, **format)};
    for (Shot &shot : set->shots)
        shot.input = 0;
    return set;
}

Result<CaptureSet> readCaptures(const std::vector<std::string> &paths,
    const ImportSettings &settings, const JobControl &control)
{
    if (settings.format != "auto") {
        if (const auto format = formatNamed(settings.format); !format)
            return tl::unexpected(format.error());
    }
    CaptureJoiner joiner;
    std::vector<Candidate> files;
    for (const std::string &path : paths) {
        std::error_code error;
        if (!fs::is_directory(path, error)) {
            files.push_back({path, true});
        } else if (Result<std::vector<Candidate>> found = filesIn(path); found) {
            std::move(found->begin(), found->end(), std::back_inserter(files));
        } else {
            joiner.addProblem(found.error());
        }
    }
    for (std::size_t i = 0; i < files.size(); ++i) {
        Result<CaptureSet> part
            = readCapture(files[i].path, settings, partOf(control, i, files.size()));
        if (!part && part.error().kind == ErrorKind::Cancelled)
            return part;
        joiner.add(files[i], std::move(part));
    }
    return joiner.finish();
}

} // namespace dyncal
