// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/capture_check.h"
#include "core/capture/opening/capture_open.h"
#include "tests/core/capture/capture_test_support.h"
#include "tests/support/test_program.h"

#include <QDirIterator>
#include <QSet>

#include <map>

using namespace dyncal;
using namespace dyncal::testing;

/// Walks the whole folder of recordings from elsewhere: whatever lies there is read, refused with a
/// reason or no capture at all, and never anything else.
class TestEveryDataFile : public QObject
{
    Q_OBJECT

private:
    static QStringList everyFile(const QString &folder)
    {
        QStringList files;
        QDirIterator entry(folder, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
        while (entry.hasNext())
            files << entry.next();
        files.sort();
        return files;
    }

    /// What a file that was read must be like, whatever it holds; empty if it is.
    static std::string faultOf(const CaptureSet &set)
    {
        if (set.inputs.size() != 1 || set.inputs[0].sha256.size() != 64)
            return "the input is not sealed";
        if (set.shots.empty())
            return "there are no shots";
        for (const Shot &shot : set.shots) {
            if (shot.channels.empty() || shot.input != 0)
                return "a shot has no channels or no input";
            for (const Channel &channel : shot.channels) {
                if (channel.name.empty() || channel.sha256.size() != 64
                    || !(channel.sampleRate_Hz >= 0.0) || !std::isfinite(channel.t0_s))
                    return "channel '" + channel.name + "' makes no sense";
            }
        }
        return {};
    }

    /// A refusal is one sentence or two that name the file and an entry of the catalogue.
    static std::string faultOf(const Error &error, const std::string &path)
    {
        const std::string text = english(error.message);
        if (error.kind != ErrorKind::FileUnreadable && error.kind != ErrorKind::DataBlocked)
            return "is refused for a reason that is not the file's: " + text;
        if (!error.findingId.starts_with("CAP-0"))
            return "is refused without an id: " + text;
        if (!contains(text, path) || !text.ends_with('.'))
            return "is refused with half a sentence: " + text;
        return {};
    }

private slots:
    void everyFile_isReadRefusedOrNoCapture()
    {
        const QString folder = recordingsFolder();
        if (folder.isEmpty() || !QDir(folder).exists())
            DYNCAL_SKIP_WITHOUT_DATA(
                "NOT TESTED: the folder of recordings is missing (DYNCAL_DATA); 0 files covered");
        const QStringList files = everyFile(folder);
        int read = 0;
        int notCaptures = 0;
        std::map<std::string, int> refused; ///< by id
        QMap<QString, QStringList> byEnding;
        for (const QString &file : files) {
            const std::string path = file.toStdString();
            const Result<CaptureSet> set = readCapture(path, {});
            const std::string fault = set ? faultOf(*set) : faultOf(set.error(), path);
            QVERIFY2(fault.empty(), (path + " " + fault).c_str());
            const QString ending = QFileInfo(file).suffix().toLower();
            if (set) {
                ++read;
                byEnding[ending] << "read";
                checkCaptures(*set); // ends, whatever the samples are
            } else if (set.error().findingId == "CAP-001") {
                ++notCaptures;
                byEnding[ending] << "no capture";
            } else {
                ++refused[set.error().findingId];
                byEnding[ending] << QString::fromStdString(set.error().findingId);
            }
        }
        int refusals = 0;
        for (const auto &[id, count] : refused) {
            refusals += count;
            qInfo("refused with %s: %d", id.c_str(), count);
        }
        for (auto each = byEnding.cbegin(); each != byEnding.cend(); ++each) {
            const QSet<QString> kinds(each->begin(), each->end());
            QStringList counts;
            for (const QString &kind : kinds)
                counts << QString("%1 %2").arg(each->count(kind)).arg(kind);
            counts.sort();
            qInfo(".%s: %s", qPrintable(each.key()), qPrintable(counts.join(", ")));
        }
        qInfo("%lld files: %d read, %d refused, %d no captures",
            static_cast<long long>(files.size()), read, refusals, notCaptures);
        QCOMPARE(read + refusals + notCaptures, static_cast<int>(files.size()));
        QVERIFY(read > 0);
    }

    void noJsonOrXml_isTakenForARecording()
    {
        const QString folder = recordingsFolder();
        if (folder.isEmpty() || !QDir(folder).exists())
            DYNCAL_SKIP_WITHOUT_DATA(
                "NOT TESTED: the folder of recordings is missing (DYNCAL_DATA); 0 files covered");
        int covered = 0;
        for (const QString &file : everyFile(folder)) {
            if (!file.endsWith(".json") && !file.endsWith(".xml"))
                continue;
            QVERIFY2(!readCapture(file.toStdString(), {}), qPrintable(file));
            ++covered;
        }
        qInfo("%d files covered", covered);
        QVERIFY(covered > 0);
    }
};

DYNCAL_TEST(TestEveryDataFile)
#include "tst_every_data_file.moc"
