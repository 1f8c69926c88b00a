// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QTest>

/// The tests of one folder are one program, because linking each alone took half of the build. A
/// test puts its class into it with DYNCAL_TEST; `PROGRAM NAME [options of Qt Test]` runs the class
/// of tst_NAME.cpp with an application object of its own, and ctest calls it so for every file.
namespace dyncal::testing {

using RunTest = int (*)(int argc, char **argv);

/// Puts the class of a source file into the program; to be made before main().
class RegisteredTest
{
public:
    RegisteredTest(const char *sourceFile, RunTest run);
};

template <typename Test>
int runTest(int argc, char **argv)
{
    Test test;
    return QTest::qExec(&test, argc, argv);
}

} // namespace dyncal::testing

/// Registers the test class of this file; once per file, outside of every namespace.
#define DYNCAL_TEST(Test)                                                                          \
    static const dyncal::testing::RegisteredTest registeredTest(                                   \
        __FILE__, &dyncal::testing::runTest<Test>);
