// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The written scripts on models of closed form; whole exports: tst_model_export.cpp.

#include "core/realization/hankel/state_space_model.h"
#include "core/results/mat_writer.h"
#include "core/results/model_scripts.h"
#include "tests/support/python_answer.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_program.h"

#include <QStringList>
#include <QTest>

#include <cmath>
#include <complex>

using namespace dyncal;
using Complex = std::complex<double>;

namespace {

constexpr double kInterval_s = 1e-6;
constexpr int kSamples = 400;
constexpr double kRounding = 1e-11; ///< of a few hundred products
const Complex kPole(-9e3, 1.9e5);
const Complex kAmplitude(-0.5, 0.2);

/// One pair: c0 + 2 Re(c e^(s t)), c0 = 0 for a decay.
struct PairModel
{
    ResponseTreatment treatment;
    double c0 = 1.0;

    bool isDecay() const { return treatment == ResponseTreatment::Impulse; }
    double at(double t_s) const { return c0 + 2.0 * (kAmplitude * std::exp(kPole * t_s)).real(); }
    Complex response(double f_Hz) const
    {
        const Complex jw(0.0, 2.0 * M_PI * f_Hz);
        const auto share
            = [&](Complex c, Complex s) { return isDecay() ? c / (jw - s) : c * jw / (jw - s); };
        return c0 + share(kAmplitude, kPole) + share(std::conj(kAmplitude), std::conj(kPole));
    }

    /// model.mat as the export writes it; A is that of the pair in companion form.
    std::string matFile() const
    {
        const Complex z = std::exp(kPole * kInterval_s);
        const Eigen::Matrix2d A
            = (Eigen::Matrix2d() << z.real(), z.imag(), -z.imag(), z.real()).finished();
        // e^(k s dt) as the rotation above: x = (Re, -Im) of z^k times what drives it.
        const Complex drive = isDecay() ? Complex(1.0) : z - 1.0;
        MatWriter file;
        file.add("A", Eigen::MatrixXd(A));
        file.add("B", Eigen::MatrixXd(Eigen::Vector2d(drive.real(), -drive.imag())));
        file.add(
            "C", Eigen::MatrixXd(2.0 * Eigen::RowVector2d(kAmplitude.real(), kAmplitude.imag())));
        file.add("D", isDecay() ? 0.0 : at(0.0));
        file.add("Ts", kInterval_s);
        file.add("c0", c0);
        file.add("c", Eigen::MatrixXcd(Eigen::Vector2cd(kAmplitude, std::conj(kAmplitude))));
        file.add("s", Eigen::MatrixXcd(Eigen::Vector2cd(kPole, std::conj(kPole))));
        Eigen::MatrixXd y(kSamples, 2);
        for (int k = 0; k < kSamples; ++k)
            y.row(k).setConstant(at(k * kInterval_s));
        y.col(1).setConstant(1e9); // another shot: not what is compared
        file.add("y_model", y);
        return file.bytes();
    }
};

} // namespace

class TestModelScripts : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!testing::hasNumericalPython())
            QSKIP("/usr/bin/python3 with numpy and scipy is missing: no written script is run.");
    }

    void python_simulatesTheClosedForm_data()
    {
        QTest::addColumn<int>("treatment");
        QTest::newRow("step") << int(ResponseTreatment::StepDeflated);
        QTest::newRow("differenced") << int(ResponseTreatment::Differenced);
        QTest::newRow("decay") << int(ResponseTreatment::Impulse);
    }
    void python_simulatesTheClosedForm()
    {
        QFETCH(int, treatment);
        PairModel model{static_cast<ResponseTreatment>(treatment)};
        model.c0 = model.isDecay() ? 0.0 : 1.25;
        const testing::ScratchFolder folder;
        const std::string mat = model.matFile(), script = pythonScript(model.treatment);
        folder.write("model.mat", mat.data(), mat.size());
        folder.write("model.py", script.data(), script.size());
        const QString file = QString::fromStdString(folder.file("model.py"));
        const testing::PythonAnswer run = testing::python({file});
        QVERIFY2(run.ran, run.err);
        QVERIFY2(run.out.startsWith("largest difference:"), run.out);
        QVERIFY2(run.out.simplified().split(' ').back().toDouble() < kRounding, run.out);

        // What it offers to others: exponentials(t) and frequency_response(f), a list of each.
        const testing::PythonAnswer numbers = testing::python({"-c",
            "import sys; sys.path.insert(0, sys.argv[1]); import model\n"
            "y = model.exponentials([0, 1e-5]); g = model.frequency_response([1e3, 3e4])\n"
            "print(*[float(v).hex() for v in (*y, *g.real, *g.imag)])",
            QString::fromStdString(folder.file(""))});
        QVERIFY2(numbers.ran, numbers.err);
        std::vector<double> found;
        for (const QByteArray &word : numbers.out.simplified().split(' '))
            found.push_back(std::strtod(word.constData(), nullptr));
        QCOMPARE(found.size(), std::size_t(6));
        for (std::size_t i = 0; i < 2; ++i) {
            const double scale = std::max(1.0, std::abs(model.response(1e3)));
            QVERIFY(std::abs(found[i] - model.at(i == 0 ? 0.0 : 1e-5)) < kRounding);
            const Complex expected = model.response(i == 0 ? 1e3 : 3e4);
            QVERIFY(std::abs(Complex(found[2 + i], found[4 + i]) - expected) < kRounding * scale);
        }
    }

    void python_wrongModel_showsInTheDifference()
    {
        PairModel model{ResponseTreatment::StepDeflated, 1.0};
        const testing::ScratchFolder folder;
        const std::string mat = PairModel{ResponseTreatment::Impulse, 0.5}.matFile();
        const std::string script = pythonScript(model.treatment);
        folder.write("model.mat", mat.data(), mat.size());
        folder.write("model.py", script.data(), script.size());
        const testing::PythonAnswer run
            = testing::python({QString::fromStdString(folder.file("model.py"))});
        QVERIFY2(run.ran, run.err);
        QVERIFY(run.out.simplified().split(' ').back().toDouble() > 0.1);
    }

    void thesisMode_comparesWithTheSimulationInTheFile()
    {
        // Its impulse response one sample late, D = 0: here the decay's state space, whose y_model
        // is what is recorded.
        PairModel model{ResponseTreatment::Impulse, 0.0};
        const testing::ScratchFolder folder;
        const std::string mat = model.matFile();
        const std::string script = pythonScript(ResponseTreatment::StepAsImpulse);
        folder.write("model.mat", mat.data(), mat.size());
        folder.write("model.py", script.data(), script.size());
        const testing::PythonAnswer run
            = testing::python({QString::fromStdString(folder.file("model.py"))});
        QVERIFY2(run.ran, run.err);
        QVERIFY2(run.out.simplified().split(' ').back().toDouble() < kRounding, run.out);
    }

    void matlab_saysTheSameAsPython()
    {
        for (const ResponseTreatment treatment :
            {ResponseTreatment::StepDeflated, ResponseTreatment::Differenced,
                ResponseTreatment::Impulse, ResponseTreatment::StepAsImpulse}) {
            const QByteArray m = QByteArray::fromStdString(matlabScript(treatment));
            const QByteArray py = QByteArray::fromStdString(pythonScript(treatment));
            const bool isDecay = treatment == ResponseTreatment::Impulse;
            const bool isListing = treatment == ResponseTreatment::StepAsImpulse;
            QCOMPARE(py.contains("signal.dimpulse"), isDecay || isListing);
            QCOMPARE(m.contains("x = m.B;\nfor k"), isDecay || isListing);
            QCOMPARE(py.contains("(c / (jw - s))"), isDecay);
            QCOMPARE(m.contains("sum(m.c.' ./"), isDecay);
            QCOMPARE(m.contains("expected = m.y_model(:, 1)"), isListing);
            QCOMPARE(py.contains("m[\"y_model\"][:, 0]"), isListing);
            QCOMPARE(m.count("("), m.count(")"));
            for (const QByteArray &line : m.split('\n').mid(0, 2))
                QVERIFY(line.startsWith("% "));
        }
    }
};

DYNCAL_TEST(TestModelScripts)
#include "tst_model_scripts.moc"
