// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Certificates that others wrote, read from where they lie: the folder DYNCAL_DCC_SAMPLES, else
// ../shared/dcc/samples beside the source tree. Nothing of them is part of the source tree.

#include "core/dcc_reading/certified_sensor.h"
#include "tests/support/measured_data.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

using namespace dyncal;
using testing::isNear;

namespace {

namespace fs = std::filesystem;

fs::path sharedSamples()
{
    return testing::dataFolder().parent_path() / "dcc" / "samples";
}

std::vector<fs::path> samples()
{
    const char *folder = std::getenv("DYNCAL_DCC_SAMPLES");
    std::vector<fs::path> files;
    std::error_code unknown;
    for (const auto &entry :
        fs::directory_iterator(folder ? fs::path(folder) : sharedSamples(), unknown))
        if (entry.path().extension() == ".xml")
            files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

std::string bytesOf(const fs::path &file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// Every quantity of the D-SI in a file, wherever it stands.
void findQuantities(const ParsedElement &element, std::vector<const ParsedElement *> &found)
{
    if (isDSiElement(element))
        return found.push_back(&element);
    for (const ParsedElement &child : element.children)
        findQuantities(child, found);
}

/// Reads all of them; how many were understood.
std::size_t understoodOf(const std::vector<const ParsedElement *> &quantities)
{
    std::size_t understood = 0;
    for (const ParsedElement *one : quantities) {
        const Result<DSiQuantity> quantity = readDSiQuantity(*one);
        if (quantity)
            ++understood;
        else
            qInfo("  %s", english(quantity.error().message).c_str());
    }
    return understood;
}

} // namespace

class TestDccSamples : public QObject
{
    Q_OBJECT

private slots:
    void everySample_isReadOrRefusedInWords()
    {
        if (samples().empty())
            DYNCAL_SKIP_WITHOUT_DATA("certificates that others wrote");
        for (const fs::path &file : samples()) {
            const Result<DccContents> contents = readDcc(bytesOf(file));
            if (!contents) {
                qInfo("%s: %s", file.filename().c_str(), english(contents.error().message).c_str());
                continue;
            }
            const CertifiedSensor sensor = certifiedSensor(*contents);
            qInfo("%s: DCC %s, number '%s', serial '%s', %zu lists, %zu single values",
                file.filename().c_str(), contents->version.c_str(), contents->number.c_str(),
                sensor.serial.c_str(), contents->tables.size(), contents->single.size());
            for (const Message &one : sensor.leftOut)
                qInfo("  %s", english(one).c_str());
            QVERIFY(!contents->tables.empty() || !contents->single.empty()
                || !contents->notUnderstood.empty());
        }
    }

    /// Files of quantities only, and the certificates: what is refused has its reason.
    void everyQuantity_isReadOrRefusedInWords()
    {
        if (samples().empty())
            DYNCAL_SKIP_WITHOUT_DATA("certificates that others wrote");
        for (const fs::path &file : samples()) {
            const Result<ParsedElement> root = readXml(bytesOf(file));
            if (!root)
                continue;
            std::vector<const ParsedElement *> quantities;
            findQuantities(*root, quantities);
            const std::size_t understood = understoodOf(quantities);
            qInfo("%s: %zu of %zu quantities", file.filename().c_str(), understood,
                quantities.size());
        }
    }

    /// The project's own sample, valid by XSD: its numbers as they stand in it.
    void theSharedSample_isRead()
    {
        const fs::path file = sharedSamples() / "own_shocktube_dcc.xml";
        if (!fs::exists(file))
            DYNCAL_SKIP_WITHOUT_DATA("the sample of shared/dcc");
        const Result<DccContents> contents = readDcc(bytesOf(file));
        QVERIFY(contents.has_value());
        const CertifiedSensor sensor = certifiedSensor(*contents);
        QCOMPARE(contents->number, std::string("DYN-2026-0001"));
        QCOMPARE(sensor.serial, std::string("SN123"));
        QVERIFY(sensor.response.has_value());
        QCOMPARE(sensor.response->frequency_Hz, (std::vector<double>{1e3, 1e4, 1e5}));
        QVERIFY(isNear(sensor.response->magnitude.values[2], 0.1125e-6, 1e-12));
        QVERIFY(isNear(sensor.response->magnitude.u[2], 0.0015e-6, 1e-12));
        QCOMPARE(sensor.response->magnitude.k[2], 2.0);
        QCOMPARE(sensor.response->phase_rad->values[2], -0.0150);
        QVERIFY(sensor.leftOut.empty());
    }
};

DYNCAL_TEST(TestDccSamples)
#include "tst_dcc_samples.moc"
