#pragma once

#include <QtTest>

namespace skipping {

/// Whether the environment says that something is there: KNEAD_NO_SKIPS lists words, "display corpus slurm".
inline bool isPromised(const char* what)
{
    return qEnvironmentVariable("KNEAD_NO_SKIPS").split(' ').contains(QLatin1String(what));
}

} // namespace skipping

/// Skips a test where something is missing that not every machine has. Where it is promised, as by .ci/run, the test fails: else
/// nobody would see that it is no longer run.
/// @param what "display", "corpus", "slurm", "tools", "landlock" or "seccomp" @param sentence what is missing and what to do about it
#define KNEAD_SKIP_WITHOUT(what, sentence)                                                                             \
    do {                                                                                                               \
        if (skipping::isPromised(what))                                                                                \
            QFAIL(qPrintable(QStringLiteral("KNEAD_NO_SKIPS promises \"%1\" to this test. %2")                         \
                                 .arg(QLatin1String(what), QString::fromUtf8(sentence))));                             \
        QSKIP(sentence);                                                                                               \
    } while (false)
