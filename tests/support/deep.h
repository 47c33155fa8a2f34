#pragma once

#include <QtTest>

/// Whether everything is tried, however long it takes: `./dev check deep` sets KNEAD_DEEP. Else what each change waits for: fewer
/// trials of the same kind, with the same bounds but for how long the window may be busy (window_watchdog.h).
inline bool isDeep()
{
    return qEnvironmentVariableIsSet("KNEAD_DEEP");
}

/// One of two loads of a test. @param daily where each change waits for it @param deep where it may take long
template <typename Load>
Load loadOf(Load daily, Load deep)
{
    return isDeep() ? deep : daily;
}
