// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/correction/filter_files.h"

#include "core/base/json_text.h"
#include "core/base/version.h"
#include "core/results/csv_table.h"
#include "core/results/json_record.h"
#include "core/results/mat_writer.h"

namespace dyncal {
namespace {

constexpr const char *kPythonOfFilter = R"py(from pathlib import Path

import numpy as np
from scipy.io import loadmat
from scipy.signal import fftconvolve

m = loadmat(Path(__file__).with_name("filter.mat"))
h, E = m["h"].ravel(), m["E"]
fs, delay, band = m["fs"].item(), int(m["delay"].item()), m["band"].item()


def correct(x):
    """Pressure in Pa of a record x at fs, its level without pressure taken off, and the standard
    uncertainty of it by the sensor's response. Value i belongs to sample i + len(h) - 1 - delay of x:
    those for which the filter would need samples beyond the ends of x are left out."""
    x = np.asarray(x, dtype=float).ravel()
    variance = sum(fftconvolve(x, e, mode="valid") ** 2 for e in E.T)
    return fftconvolve(x, h, mode="valid"), np.sqrt(variance)


def frequency_response(f):
    """Of the filter in Pa per unit of the record, its delay taken off, at f in hertz"""
    n = np.arange(len(h)) - delay
    return np.exp(-2j * np.pi * np.outer(np.atleast_1d(f), n) / fs) @ h


if __name__ == "__main__":
    print("gain at 0 Hz:", h.sum(), "delay in samples:", delay, "band in Hz:", band)
)py";

std::string filterJson(const CorrectionFilter &filter)
{
    const char *none = "Not finite.";
    JsonRecord root;
    root.set("schema", "dyncal-filter/1");
    root.set("software", std::string("dyncal ") + versionText());
    root.number("sample_rate_hz", filter.rate_Hz, none);
    root.set("low_pass", lowPassName(filter.lowPass.kind));
    root.number("band_hz", filter.lowPass.band_Hz, none);
    root.number("edge_hz", filter.lowPass.edge_Hz, none);
    root.set("delay_samples", filter.delaySamples);
    root.number("delay_s", filter.delay_s(), none);
    root.number("gain", filter.gain(), none);
    root.set("unit", filter.unit);
    root.number("pass_error", filter.passError, none);
    root.numbers("taps", filter.taps, none);
    root.numbers("u_taps", filter.u_taps(), none);
    return jsonText(root.take());
}

std::string tapsCsv(const CorrectionFilter &filter)
{
    CsvTable table;
    table.add("tap", filter.taps);
    table.add("u_tap", filter.u_taps());
    return table.text();
}

/// "1_noise", "2_noise" ...
std::string tapErrorsCsv(const CorrectionFilter &filter)
{
    CsvTable table;
    for (Index j = 0; j < filter.tapErrors.cols(); ++j)
        table.add(std::to_string(j + 1) + "_" + filter.errorNames[static_cast<std::size_t>(j)],
            filter.tapErrors.col(j));
    return table.text();
}

std::string filterMat(const CorrectionFilter &filter)
{
    MatWriter file;
    file.add("h", Eigen::MatrixXd(filter.taps));
    file.add("E", filter.tapErrors);
    file.add("fs", filter.rate_Hz);
    file.add("delay", static_cast<double>(filter.delaySamples));
    file.add("band", filter.lowPass.band_Hz);
    return file.bytes();
}

std::string filterScript()
{
    return std::string("# Correction filter, written by dyncal ") + versionText()
        + ". Needs filter.mat beside it.\n" + kPythonOfFilter;
}

} // namespace

std::vector<FilterFile> filterFiles(const CorrectionFilter &filter)
{
    return {{"filter.json", filterJson(filter)}, {"filter.csv", tapsCsv(filter)},
        {"filter_errors.csv", tapErrorsCsv(filter)}, {"filter.mat", filterMat(filter)},
        {"filter.py", filterScript()}};
}

const std::vector<std::string> &filterFileNames()
{
    static const std::vector<std::string> names{
        "filter.json", "filter.csv", "filter_errors.csv", "filter.mat", "filter.py"};
    return names;
}

} // namespace dyncal
