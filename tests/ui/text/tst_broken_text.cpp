// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/text/broken_text.h"

#include <QFont>
#include <QFontMetrics>
#include <QRandomGenerator>
#include <QStringList>
#include <QtTest>

using namespace dyncal;

namespace {

constexpr quint32 kSeed = 7;
constexpr int kTrials = 300;
constexpr int kWidth_px = 120;
constexpr qsizetype kLeastPart = 4;

QString wordOf(QRandomGenerator &random, qsizetype letters)
{
    QString word;
    for (qsizetype i = 0; i < letters; ++i)
        word += QChar('a' + random.bounded(26));
    return word;
}

/// The text as it was: hyphens and line breaks that are not its own taken away.
QString mended(QString broken)
{
    return broken.replace(QLatin1String("-\n"), QString()).replace(QChar('\n'), QChar(' '));
}

} // namespace

/// Text in lines that fit, as a narrow label shows it.
class TestBrokenText : public QObject
{
    Q_OBJECT

private:
    const QFontMetrics m_metrics{QFont()};

    bool fits(const QString &line) const
    {
        return m_metrics.size(Qt::TextShowMnemonic, line).width() <= kWidth_px;
    }

private slots:
    void whatFits_staysAsItIs()
    {
        for (const char *text : {"", "a", "two words"})
            QCOMPARE(brokenText(m_metrics, text, kWidth_px), QString(text));
    }

    void randomText_isWhole_inLinesThatFit()
    {
        QRandomGenerator random(kSeed);
        for (int trial = 0; trial < kTrials; ++trial) {
            QStringList words;
            for (int i = 0; i < 5; ++i)
                words += wordOf(random, 1 + random.bounded(60));
            const QString broken = brokenText(m_metrics, words.join(QChar(' ')), kWidth_px);
            QCOMPARE(mended(broken), words.join(QChar(' ')));
            for (const QString &line : broken.split(QChar('\n')))
                QVERIFY2(fits(line), qPrintable(line));
        }
    }

    /// No part could be longer, but for the letters that stay together behind it.
    void parts_areTheLongestThatFit()
    {
        QRandomGenerator random(kSeed + 1);
        for (int trial = 0; trial < kTrials; ++trial) {
            const QString word = wordOf(random, 8 + random.bounded(90));
            QString rest = word;
            const QStringList lines = brokenText(m_metrics, word, kWidth_px).split(QChar('\n'));
            for (qsizetype i = 0; i + 1 < lines.size(); ++i) {
                const qsizetype length = lines[i].size() - 1;
                QVERIFY(rest.size() - length >= kLeastPart);
                if (rest.size() - length > kLeastPart)
                    QVERIFY(!fits(rest.left(length + 1) + QChar('-')));
                rest.remove(0, length);
            }
        }
    }

    /// It once measured all of what was left for each letter of each line, which took minutes.
    void oneWordOf20000Letters_isBrokenLikeAnother()
    {
        QRandomGenerator random(kSeed + 2);
        const QString word = wordOf(random, 20000);
        const QString broken = brokenText(m_metrics, word, kWidth_px);
        QCOMPARE(mended(broken), word);
        const QString start = brokenText(m_metrics, word.left(200), kWidth_px);
        QVERIFY(broken.startsWith(start.left(100)));
    }

    void wherePartsOfFourDoNotFit_theyStandAllTheSame()
    {
        QCOMPARE(brokenText(m_metrics, "abcdefghij", 1), QString("abcd-\nefghij"));
        QCOMPARE(brokenText(m_metrics, "abcdefg", 1), QString("abcdefg"));
    }
};

DYNCAL_TEST(TestBrokenText)
#include "tst_broken_text.moc"
