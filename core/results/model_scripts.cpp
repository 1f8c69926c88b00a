// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/model_scripts.h"

#include "core/base/version.h"

namespace dyncal {
namespace {

enum class Kind { Step, Decay, Listing };

Kind kindOf(ResponseTreatment treatment)
{
    if (treatment == ResponseTreatment::StepAsImpulse)
        return Kind::Listing;
    return isStepTreatment(treatment) ? Kind::Step : Kind::Decay;
}

std::string headOf(Kind kind, const std::string &comment)
{
    std::string head = comment + "Sensor model, written by dyncal " + versionText()
        + ". Needs model.mat beside it.\n" + comment
        + "x(k+1) = A x(k) + B u(k), y(k) = C x(k) + D u(k), sampled every Ts seconds.\n";
    switch (kind) {
    case Kind::Step:
        return head + comment
            + "Its step response is c0 + sum c_i exp(s_i t), t in seconds from the onset, in units of the\n"
            + comment + "response as analysed (1 = the plateau, where it was remapped).\n";
    case Kind::Decay:
        return head + comment
            + "Its impulse response, one sample late (D = 0), is the free decay sum c_i exp(s_i t).\n";
    case Kind::Listing:
        return head + comment
            + "Its impulse response, one sample late (D = 0), is the recorded step response (y_model).\n";
    }
    return head;
}

const char *const kPythonLoad = R"py(
from pathlib import Path

import numpy as np
from scipy import signal
from scipy.io import loadmat

m = loadmat(Path(__file__).with_name("model.mat"))
Ts = m["Ts"].item()
system = signal.dlti(m["A"], m["B"], m["C"], m["D"], dt=Ts)
c0, c, s = m["c0"].item(), m["c"].ravel(), m["s"].ravel()


def exponentials(t):
    """c0 + sum c_i exp(s_i t)"""
    return c0 + (np.exp(np.outer(t, s)) @ c).real


def frequency_response(f):
    """Continuous response to pressure at the frequencies f in hertz"""
    jw = 2j * np.pi * np.asarray(f, dtype=float)[:, None]
    return c0 + (c * jw / (jw - s)).sum(axis=1)


if __name__ == "__main__":
    n = m["y_model"].shape[0]
)py";

const char *const kMatlabLoad = R"m(
m = load(fullfile(fileparts(mfilename('fullpath')), 'model.mat'));
% With the Control System Toolbox: sys = ss(m.A, m.B, m.C, m.D, m.Ts);
n = size(m.y_model, 1);
exponentials = @(t) m.c0 + real(exp(t(:) * m.s.') * m.c);
frequency_response = @(f) m.c0 + sum(m.c.' .* (2i * pi * f(:)) ./ (2i * pi * f(:) - m.s.'), 2);
x = zeros(size(m.A, 1), 1);
)m";

std::string pythonCheck(Kind kind)
{
    const std::string simulate = kind == Kind::Step
        ? "    t, (y,) = signal.dstep(system, n=n)\n    y = y[:, 0]\n"
        : "    t, (y,) = signal.dimpulse(system, n=n + 1)\n    y = y[1:, 0]\n";
    const std::string expected
        = kind == Kind::Listing ? "m[\"y_model\"][:, 0]" : "exponentials(np.arange(n) * Ts)";
    return simulate + "    print(\"largest difference:\", np.abs(y - " + expected + ").max())\n";
}

std::string matlabCheck(Kind kind)
{
    std::string text = "y = zeros(n, 1);\n";
    text += kind == Kind::Step
        ? "for k = 1:n % response to a unit step\n    y(k) = m.C * x + m.D;\n"
          "    x = m.A * x + m.B;\nend\n"
        : "x = m.B;\nfor k = 1:n % response to a unit impulse one sample earlier\n"
          "    y(k) = m.C * x;\n    x = m.A * x;\nend\n";
    text += kind == Kind::Listing ? "expected = m.y_model(:, 1);\n"
                                  : "expected = exponentials((0:n - 1) * m.Ts);\n";
    return text + "fprintf('largest difference: %g\\n', max(abs(y - expected)));\n";
}

/// The first `from` in the text becomes `to`.
std::string replaced(std::string text, const std::string &from, const std::string &to)
{
    const std::size_t at = text.find(from);
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

} // namespace

std::string matlabScript(ResponseTreatment treatment)
{
    const Kind kind = kindOf(treatment);
    std::string load = kMatlabLoad;
    if (kind == Kind::Decay)
        load = replaced(load, "m.c0 + sum(m.c.' .* (2i * pi * f(:)) ./", "sum(m.c.' ./");
    return headOf(kind, "% ") + load + matlabCheck(kind);
}

std::string pythonScript(ResponseTreatment treatment)
{
    const Kind kind = kindOf(treatment);
    std::string load = kPythonLoad;
    if (kind == Kind::Decay)
        load = replaced(load, "c0 + (c * jw / (jw - s))", "(c / (jw - s))");
    return headOf(kind, "# ") + load + pythonCheck(kind);
}

} // namespace dyncal
