// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"
#include "tests/system/issued_job.h"

#include <QtTest>

#include <random>

namespace {

constexpr unsigned int kSeed = 20261127;

/// One job that is issued and then amended again and again, with a kill at a random moment of each
/// command; a command that was killed is given again until it is done.
class KilledIssuing
{
public:
    explicit KilledIssuing(const QString &recording)
        : m_isReady(m_job.begin(recording) && nextRecipe())
    {
    }
    bool isReady() const { return m_isReady; }

    /// Of a command that is not killed.
    bool finish()
    {
        return m_job.issue(amendment()).exitCode == 0 && m_job.verify(all()).exitCode == 1;
    }

    /// Kills a command after so many microseconds; empty, or what does not fit then.
    QString kill(std::uint64_t after_us)
    {
        QProcess process;
        process.start(qEnvironmentVariable("DYNCAL_BINARY"),
            QStringList{"issue", m_job.path("job.dyncal"), "-o", m_job.output(), "--registry",
                m_job.registry(), "--unsigned"}
                + amendment());
        if (!process.waitForStarted())
            return "the program does not start";
        QThread::usleep(static_cast<unsigned long>(after_us));
        process.kill();
        process.waitForFinished();
        return QFile::exists(m_job.registry()) ? look() : QString();
    }

    /// Empty, or what does not fit at the end: every number from 1 is issued, the last one in
    /// force, each with its folder, and nothing else lies there, hidden or not.
    QString faultAtTheEnd() const
    {
        const QJsonArray numbers = m_job.numbers();
        QStringList folders;
        for (qsizetype i = 0; i < numbers.size(); ++i) {
            folders << QString::number(i + 1);
            const QString state = numbers[i]["state"].toString();
            const bool isLast = i + 1 == numbers.size();
            if (numbers[i]["number"].toInt() != i + 1
                || state
                    != (!isLast      ? "replaced"
                            : i == 0 ? "issued"
                                     : "amended"))
                return QJsonDocument(numbers).toJson();
        }
        QStringList found = QDir(m_job.output())
                                .entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
        folders.sort();
        found.sort();
        if (found != folders)
            return found.join(' ');
        const QStringList beside
            = QDir(m_job.folder.path()).entryList(QDir::Files | QDir::Hidden, QDir::Name);
        if (beside != QStringList{"job.dyncal", "registry.sqlite", "shot.h5"})
            return beside.join(' ');
        const Answer verified = m_job.verify(all());
        return verified.exitCode == 1 ? QString() : QString::fromUtf8(verified.out);
    }

    int issued() const { return m_serial - 1; }
    int wereReserved() const { return m_wereReserved; }

private:
    QStringList all() const { return {m_job.output(), m_job.registry()}; }

    QStringList amendment() const
    {
        return m_inForce == 0
            ? QStringList()
            : QStringList{"--amends", QString::number(m_inForce), "--reason", "corrected"};
    }

    bool nextRecipe()
    {
        QJsonObject fields = completeFields();
        fields["sensor_serial"] = QString::number(m_serial++);
        QJsonObject recipe = completeRecipe();
        recipe["certificate"] = QJsonObject{{"fields", fields}};
        return m_job.writeProject(recipe);
    }

    /// The registry after a kill: whole, its numbers without gaps, at most the last one reserved,
    /// and none given twice.
    QString look()
    {
        const Answer verified = runDyncal({"verify", m_job.registry()});
        const QJsonArray numbers = m_job.numbers();
        if (verified.exitCode != 0 && !numbers.isEmpty())
            return QString::fromUtf8(verified.out + verified.err);
        int inForce = 0;
        for (qsizetype i = 0; i < numbers.size(); ++i) {
            const QString state = numbers[i]["state"].toString();
            const bool isLast = i + 1 == numbers.size();
            if (numbers[i]["number"].toInt() != i + 1 || (state == "reserved" && !isLast))
                return QJsonDocument(numbers).toJson();
            if (state == "issued" || state == "amended")
                inForce = static_cast<int>(i) + 1;
            m_wereReserved += state == "reserved" ? 1 : 0;
        }
        if (inForce < m_inForce)
            return QString("certificate %1 is lost").arg(m_inForce);
        if (inForce > m_inForce && !nextRecipe())
            return "the project cannot be written";
        m_inForce = inForce;
        return {};
    }

    IssuedJob m_job;
    int m_serial = 1;
    int m_inForce = 0;
    int m_wereReserved = 0;
    bool m_isReady;
};

} // namespace

/// `dyncal issue` itself, killed at random moments of numbering, issuing and amending.
class TestKilledIssue : public QObject
{
    Q_OBJECT

private slots:
    void killedAgainAndAgain_nothingIsLostOrMixed()
    {
        const QTemporaryDir recordings;
        const QString recording = recordings.filePath("shot.h5");
        QVERIFY(simulateShortCapture(recording, 7));
        QElapsedTimer whole;
        {
            KilledIssuing once(recording);
            QVERIFY(once.isReady());
            whole.start();
            QVERIFY(once.finish());
        }
        // A little more than a command takes: some come to their end, so that the next is another.
        const auto longest = static_cast<std::uint64_t>(whole.elapsed()) * 1100;
        KilledIssuing job(recording);
        QVERIFY(job.isReady());
        std::mt19937_64 random(kSeed);
        const int kills = dyncal::trials::count(30, 200);
        for (int i = 0; i < kills; ++i) {
            const QString fault = job.kill(random() % longest);
            QVERIFY2(fault.isEmpty(), qPrintable(QString("kill %1: %2").arg(i).arg(fault)));
        }
        QVERIFY(job.finish());
        const QString fault = job.faultAtTheEnd();
        QVERIFY2(fault.isEmpty(), qPrintable(fault));
        qInfo("%d kills, %d certificates, %d of the kills left a reserved number", kills,
            job.issued(), job.wereReserved());
        constexpr int kMany = 100; // so that some are killed between number and files
        QVERIFY(kills < kMany || job.wereReserved() > 0);
    }
};

DYNCAL_TEST(TestKilledIssue)
#include "tst_killed_issue.moc"
