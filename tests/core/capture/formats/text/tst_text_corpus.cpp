// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Every text of the folder of recordings is in one of three lists: read, refused, no capture.

#include "core/capture/opening/capture_open.h"
#include "tests/support/test_program.h"

#include "tests/core/capture/capture_test_support.h"

#include <QDirIterator>
#include <QRegularExpression>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

/// Printed times give the rate to their last digit over the record: 1e-7 of 1.2 ms at worst.
constexpr double kRateTolerance = 2e-4;

/// What the files whose path matches are read as. `first` is the first number of the first channel
/// as printed in the file (of the first one of them), NaN where files differ.
struct Readable
{
    const char *path;
    std::size_t shots, channels;
    Index samples;
    double rate_Hz;
    double first;
    Severity worst;
};

const QList<Readable> kReadable{
    {"derived/csv_comma_header\\.csv$", 1, 3, 4000, 1e6, 1.04085845, Severity::Info},
    {"derived/csv_noheader\\.csv$", 1, 3, 4000, 1e6, 1.04085845, Severity::Info},
    {"derived/csv_semicolon_decimalcomma\\.csv$", 1, 3, 4000, 1e6, 1.04085845, Severity::Info},
    {"derived/csv_tab_latin1_comment\\.txt$", 1, 3, 4000, 1e6, 1.04085845, Severity::Info},
    {"derived/lvm_3seg_tab_xone\\.lvm$", 3, 2, 4000, 1e6, 1.040858, Severity::Info},
    {"highrate_ds5_impact/.*/acc_base_a\\d+\\.txt$", 1, 1, -1, 0.0, kNan, Severity::Info},
    {"highrate_ds5_impact/.*/acc_pcb_a(5|35)\\.txt$", 1, 1, 5499, 5e4, kNan, Severity::Info},
    {"highrate_ds5_impact/.*/acc_pcb_a\\d+\\.txt$", 1, 1, 5500, 5e4, kNan, Severity::Info},
    {"highrate_ds5_impact/.*/Test_\\d+\\.lvm$", 1, 6, 51200, 51200.0, kNan, Severity::Info},
    {"lvm_read/data/multi_time_column\\.lvm$", 1, 2, 3, 51200.0, -0.035229, Severity::Caution},
    {"lvm_read/data/no_decimal_separator\\.lvm$", 1, 3, 4, 4000.0, -0.008807, Severity::Caution},
    {"lvm_read/data/short\\.lvm$", 1, 2, 10, 25600.0, 0.914018, Severity::Info},
    {"lvm_read/data/with_comments\\.lvm$", 1, 3, 9, 0.0, 1.833787, Severity::Caution},
    {"ptb_hydrophone/MeasuredSignals/M-Mode_3_MHz/M3_MH44\\.DAT$", 1, 1, 2500, 5e8, .000507813,
        Severity::Info},
    {"ptb_hydrophone/MeasuredSignals/pD-Mode_3_MHz/.*\\.DAT$", 1, 1, 5000, 5e8, kNan,
        Severity::Info},
    {"ptb_hydrophone/MeasuredSignals/.*\\.DAT$", 1, 1, 2500, 5e8, kNan, Severity::Info},
    {"ptb_hydrophone/Results/.*MH44.*\\.dat$", 1, 4, 2500, 5e8, 9.166402316020510625e+03,
        Severity::Info},
    {"ptb_hydrophone/Results/.*\\.dat$", 1, 4, 2500, 5e8, kNan, Severity::Info},
    {"rigolwfm/files/rs/rs_rtp_01\\.Wfm\\.csv$", 1, 1, 4000, 0.0, -0.031620555, Severity::Info},
    {"rigolwfm/files/rs/rs_rtp_05\\.Wfm\\.csv$", 1, 2, 4000, 4e10, -0.000286438, Severity::Info},
    {"rigolwfm/files/wfm/DS1102E-D\\.csv$", 1, 2, 600, 5e5, -1.28, Severity::Info},
    {"rigolwfm/files/wfm/DS1204B-A-original\\.csv$", 1, 4, 8192, 125e3, 3.04, Severity::Info},
    {"rigolwfm/files/wfm/DS1204B-F\\.csv$", 1, 2, 8192, 250e3, 14.8, Severity::Info},
    {"synthetic/syn_imp2\\.csv$", 1, 1, 400, 0.0, 0.034989740389513087, Severity::Info},
    {"synthetic/.*\\.csv$", 1, 1, 400, 0.0, kNan, Severity::Info},
};

/// Recordings by their kind, but with something that must be said instead of a number: the id.
struct Refused
{
    const char *path;
    const char *finding;
    const char *words;
};

const QList<Refused> kRefused{
    {"ptb_hydrophone/HydrophoneCalibrationData/.*\\.csv$", "CAP-001", "holds frequencies"},
};

/// Notes, settings and tables of single values: whoever names one hears that it is no recording.
const QList<const char *> kNoCapture{"md3387_shocktube/.*\\.(csv|txt)$",
    "omoriaux_bk/.*\\.(txt|csv)$", "rigolwfm/files/wfm/.*\\.txt$",
    "rigolwfm/expected_info/.*\\.txt$", "(^|/)(README|readme|LICENSE|license|headers)[^/]*\\.txt$"};

bool matches(const QString &path, const char *pattern)
{
    return QRegularExpression(pattern).match(path).hasMatch();
}

QStringList textsIn(const QString &folder)
{
    QStringList paths;
    QDirIterator entry(folder, {"*.lvm", "*.csv", "*.txt", "*.dat", "*.tsv", "*.asc"}, QDir::Files,
        QDirIterator::Subdirectories);
    while (entry.hasNext())
        paths += QDir(folder).relativeFilePath(entry.next());
    paths.sort();
    return paths;
}

/// Empty if the file was read as expected.
QString faultOf(const CaptureSet &set, const Readable &expected)
{
    if (set.shots.size() != expected.shots)
        return QString("%1 shots").arg(set.shots.size());
    for (const Shot &shot : set.shots) {
        if (shot.channels.size() != expected.channels)
            return QString("%1 channels").arg(shot.channels.size());
    }
    const Channel &channel = set.shots[0].channels[0];
    if (expected.samples >= 0 && channel.samples.size() != expected.samples)
        return QString("%1 samples").arg(channel.samples.size());
    if (!std::isnan(expected.first) && channel.samples.at(0) != expected.first)
        return QString("begins with %1").arg(channel.samples.at(0), 0, 'g', 17);
    const double rate_Hz = channel.sampleRate_Hz;
    const bool base = QString(expected.path).contains("acc_base"); // 2.0003e-5 s, not all alike
    const bool right = base
        ? std::abs(rate_Hz - 49.96e3) < 50.0
        : std::abs(rate_Hz - expected.rate_Hz) <= kRateTolerance * expected.rate_Hz;
    if (!right)
        return QString("%1 Hz").arg(rate_Hz, 0, 'g', 10);
    if (worstSeverity(set.findings) != expected.worst)
        return "other findings";
    return {};
}

} // namespace

class TestTextCorpus : public QObject
{
    Q_OBJECT

private slots:
    void read_everyText_isInOneOfThreeLists()
    {
        const QString folder = recordingsFolder();
        if (folder.isEmpty())
            DYNCAL_SKIP_WITHOUT_DATA("the folder of recordings is missing (DYNCAL_DATA)");
        int readable = 0, refused = 0, others = 0;
        QStringList faults;
        for (const QString &path : textsIn(folder)) {
            const Result<CaptureSet> set = readCapture((folder + "/" + path).toStdString(), {});
            const auto is = [&](const auto &entry) { return matches(path, entry.path); };
            const auto good = std::find_if(kReadable.begin(), kReadable.end(), is);
            const auto bad = std::find_if(kRefused.begin(), kRefused.end(), is);
            const bool none = std::any_of(kNoCapture.begin(), kNoCapture.end(),
                [&](const char *pattern) { return matches(path, pattern); });
            QString fault;
            if (good != kReadable.end()) {
                fault = set ? faultOf(*set, *good) : QString::fromStdString(sentence(set));
                ++readable;
            } else if (bad != kRefused.end()) {
                const bool right
                    = findingId(set) == bad->finding && contains(sentence(set), bad->words);
                fault = right ? "" : "not refused so: " + QString::fromStdString(sentence(set));
                ++refused;
            } else if (none) {
                fault = findingId(set) == "CAP-001" ? "" : "taken for a capture";
                ++others;
            } else {
                fault = "is in no list";
            }
            if (!fault.isEmpty())
                faults += path + ": " + fault;
        }
        qInfo("%d files read, %d refused, %d no captures", readable, refused, others);
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join("\n")));
        if (readable == 0)
            DYNCAL_SKIP_WITHOUT_DATA("the folder of recordings holds no texts");
    }
};

DYNCAL_TEST(TestTextCorpus)
#include "tst_text_corpus.moc"
