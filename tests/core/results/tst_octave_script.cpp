// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The written MATLAB script, run by Octave beside the Python one. Octave is large: the long form
// needs it, the suite uses it where it is installed.

#include "core/results/model_export.h"
#include "tests/core/results/exported_model.h"
#include "tests/support/program_answer.h"
#include "tests/support/python_answer.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <cstdio>

using namespace dyncal;

namespace {

constexpr double kSame = 1e-11; ///< sums of a few hundred terms of order one
const char *const kOctave = "octave-cli";

/// What both scripts offer: real and imaginary parts at 1 kHz and 30 kHz, then two values over
/// time.
const char *const kAsked = "g = frequency_response([1e3 3e4]);"
                           "printf('%.17g ', real(g), imag(g), exponentials([0 1e-5]));";
const char *const kAskedOfPython
    = "import sys; sys.path.insert(0, sys.argv[1]); import model\n"
      "g = model.frequency_response([1e3, 3e4])\n"
      "print(*[repr(float(v)) for v in (*g.real, *g.imag, *model.exponentials([0, 1e-5]))])";

std::vector<double> numbersIn(const QByteArray &text)
{
    std::vector<double> numbers;
    for (const QByteArray &word : text.simplified().split(' '))
        numbers.push_back(word.toDouble());
    return numbers;
}

double lastNumber(const QByteArray &text)
{
    return text.simplified().split(' ').back().toDouble();
}

} // namespace

class TestOctaveScript : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void script_saysWhatPythonSays_data();
    void script_saysWhatPythonSays();

private:
    bool m_hasOctave = false;
};

void TestOctaveScript::initTestCase()
{
    const testing::ProgramAnswer version = testing::answerOf(kOctave, {"--version"});
    m_hasOctave = version.ran;
    if (!m_hasOctave)
        QVERIFY2(trials::count(1, 0) == 1, "The long form needs Octave (Debian package octave).");
    std::printf("%s\n",
        version.ran ? version.out.left(version.out.indexOf('\n')).constData()
                    : "Octave is not here: model.m is written, and run by .ci/long only");
}

void TestOctaveScript::script_saysWhatPythonSays_data()
{
    QTest::addColumn<int>("treatment");
    QTest::addColumn<int>("order");
    QTest::newRow("step") << int(ResponseTreatment::StepDeflated) << 2;
    QTest::newRow("step, higher order") << int(ResponseTreatment::StepDeflated) << 9;
    QTest::newRow("differenced") << int(ResponseTreatment::Differenced) << 2;
    QTest::newRow("thesis") << int(ResponseTreatment::StepAsImpulse) << 3;
    QTest::newRow("decay") << int(ResponseTreatment::Impulse) << 3;
}

void TestOctaveScript::script_saysWhatPythonSays()
{
    QFETCH(int, treatment);
    QFETCH(int, order);
    const auto files
        = modelFiles(testing::calibratedModel(static_cast<ResponseTreatment>(treatment), order));
    QVERIFY(!files.empty());
    const QTemporaryDir folder;
    testing::writeModelFiles(files, folder.path());
    if (!m_hasOctave)
        return;
    const testing::ProgramAnswer alone
        = testing::answerOf(kOctave, {"--quiet", folder.filePath("model.m")});
    QVERIFY2(alone.ran, alone.err);
    QVERIFY2(alone.out.startsWith("largest difference:"), alone.out);
    QVERIFY2(lastNumber(alone.out) < 1e-9, alone.out);

    const testing::ProgramAnswer asked = testing::answerOf(
        kOctave, {"--quiet", "--eval", "cd('" + folder.path() + "'); model; " + kAsked});
    QVERIFY2(asked.ran, asked.err);
    const testing::PythonAnswer python = testing::python({"-c", kAskedOfPython, folder.path()});
    QVERIFY2(python.ran, python.err);
    const std::vector<double> expected = numbersIn(python.out);
    const QByteArray answer = asked.out.mid(asked.out.indexOf('\n') + 1); // after the difference
    const std::vector<double> found = numbersIn(answer);
    QCOMPARE(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
        QVERIFY2(std::abs(found[i] - expected[i]) <= kSame * (1.0 + std::abs(expected[i])),
            answer.constData());
}

DYNCAL_TEST(TestOctaveScript)
#include "tst_octave_script.moc"
