// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"

#ifdef QT_WIDGETS_LIB
#include <QApplication>
#else
#include <QCoreApplication>
#endif

#include <cstdio>
#include <filesystem>
#include <map>
#include <string>

namespace dyncal::testing {

namespace {

#ifdef QT_WIDGETS_LIB
using Application = QApplication;
#else
using Application = QCoreApplication;
#endif

std::map<std::string, RunTest> &registry()
{
    static std::map<std::string, RunTest> tests;
    return tests;
}

int sayWhatThereIs(const char *program)
{
    std::fprintf(stderr, "%s NAME [options of Qt Test], with NAME one of:", program);
    for (const auto &[name, run] : registry())
        std::fprintf(stderr, " %s", name.c_str());
    std::fprintf(stderr, "\n");
    return 2;
}

} // namespace

RegisteredTest::RegisteredTest(const char *sourceFile, RunTest run)
{
    const std::string stem = std::filesystem::path(sourceFile).stem().string();
    registry()[stem.substr(stem.find('_') + 1)] = run; // tst_NAME
}

} // namespace dyncal::testing

int main(int argc, char *argv[])
{
    using namespace dyncal::testing;
    const auto test = argc < 2 ? registry().end() : registry().find(argv[1]);
    if (test == registry().end())
        return sayWhatThereIs(argv[0]);
    argv[1] = argv[0];
    --argc;
    ++argv;
    // A name of its own, as settings and data folders of tests that run side by side hang on it.
    QCoreApplication::setApplicationName(
        QString::fromLatin1(DYNCAL_TEST_LAYER "_") + QString::fromStdString(test->first));
    QCoreApplication::setAttribute(Qt::AA_Use96Dpi);
    const Application application(argc, argv);
    return test->second(argc, argv);
}
