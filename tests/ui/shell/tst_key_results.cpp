// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/example_results.h"
#include "tests/support/test_program.h"
#include "tests/support/writable_result.h"
#include "ui/shell/key_results.h"

#include <QTest>

using namespace dyncal;

namespace {

QStringList namesOf(const std::vector<KeyResult> &results)
{
    QStringList names;
    for (const KeyResult &result : results)
        names << result.name;
    return names;
}

} // namespace

/// What the window says of the results is what the certificate says.
class TestKeyResults : public QObject
{
    Q_OBJECT

private slots:
    void withoutU_threeDigits()
    {
        const std::vector<KeyResult> results = keyResults(example::calibration(), {});
        QCOMPARE(results[0].text, QString::fromUtf8("S 12.5 µV/Pa"));
        QCOMPARE(results[1].text, QString::fromUtf8("f₀ 2.33000(41) MHz"));
    }

    void freeDecay_hasFrequencyAndDampingAlone()
    {
        CalibrationResults results = example::calibration();
        QCOMPARE(namesOf(keyResults(results, {})),
            (QStringList{"keySensitivity", "keyFrequency", "keyDamping", "keyStep"}));
        testing::writable(results.input).treatment = ResponseTreatment::Impulse;
        QCOMPARE(namesOf(keyResults(results, {})), (QStringList{"keyFrequency", "keyDamping"}));
    }
};

DYNCAL_TEST(TestKeyResults)
#include "tst_key_results.moc"
