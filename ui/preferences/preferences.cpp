#include "ui/preferences/preferences.h"

#include "ui/viewport/navigation.h"

#include <QSettings>
#include <QThread>

#include <algorithm>
#include <array>

namespace knead {

namespace {

constexpr std::array lookNames{"light", "dark", "system"}; // in the order of Preferences::Look

/// Every preference with its key: visited for reading and for writing.
template <class Visitor, class Values>
void visit(Visitor&& visitor, Values& values)
{
    visitor("language", values.language);
    visitor("units/length", values.lengthUnit);
    visitor("history/megabytes", values.historyMegabytes, 16, 1 << 16);
    visitor("film/megabytes", values.filmMegabytes, 16, 1 << 16);
    visitor("import/detail", values.detail, 1e-6, 0.1);
    visitor("import/minutes", values.importMinutes, 0, 10'000);
    visitor("import/gibibytes", values.importGibibytes, 0, 1'000);
    visitor("threads", values.threads, 0, 1024);
    visitor("view/smoothing", values.smoothing, 1, 16);
    visitor("view/turnsSmoothly", values.turnsSmoothly);
    visitor("view/navigation", values.navigation);
    visitor("textPercent", values.textPercent, 100, 150);
}

struct Reader {
    const QSettings& settings;

    template <class Value>
    void operator()(const char* key, Value& value) const
    {
        value = settings.value(key, QVariant::fromValue(value)).template value<Value>();
    }

    template <class Value>
    void operator()(const char* key, Value& value, Value least, Value most) const
    {
        bool isNumber = false;
        const double read = settings.value(key).toDouble(&isNumber);
        if (isNumber && read >= least && read <= most)
            value = static_cast<Value>(read);
    }
};

void keep(QSettings& settings, const char* key, const QVariant& value, const QVariant& usual)
{
    if (value == usual)
        settings.remove(key);
    else
        settings.setValue(key, value);
}

/// Values in the order in which they are visited.
struct ValueList {
    std::vector<std::pair<const char*, QVariant>> values;

    template <class Value>
    void operator()(const char* key, const Value& value, const Value& = {}, const Value& = {})
    {
        values.emplace_back(key, QVariant::fromValue(value));
    }
};

ValueList listed(const Preferences& preferences)
{
    ValueList listing;
    visit(listing, preferences);
    return listing;
}

} // namespace

int mostThreads()
{
    return std::max(1, QThread::idealThreadCount());
}

Preferences readPreferences()
{
    const QSettings settings;
    Preferences preferences;
    visit(Reader{settings}, preferences);
    preferences.navigation = navigationPreset(preferences.navigation).name;
    const auto look = std::ranges::find(lookNames, settings.value("theme").toString().toStdString());
    if (look != lookNames.end())
        preferences.look = static_cast<Preferences::Look>(look - lookNames.begin());
    int seconds = static_cast<int>(preferences.keepingInterval.count());
    Reader{settings}("recovery/seconds", seconds, 1, 60);
    preferences.keepingInterval = std::chrono::seconds(seconds);
    return preferences;
}

void writePreferences(const Preferences& preferences)
{
    QSettings settings;
    const Preferences usual;
    const ValueList now = listed(preferences);
    const ValueList before = listed(usual);
    for (std::size_t i = 0; i < now.values.size(); ++i)
        keep(settings, now.values[i].first, now.values[i].second, before.values[i].second);
    keep(settings, "recovery/seconds", static_cast<int>(preferences.keepingInterval.count()),
         static_cast<int>(usual.keepingInterval.count()));
    settings.setValue("theme", lookNames[static_cast<std::size_t>(preferences.look)]);
}

} // namespace knead
