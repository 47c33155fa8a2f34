#include "ui/preferences/preferences_feature.h"

#include "ui/commands/make_action.h"
#include "ui/commands/shortcuts.h"
#include "ui/language/language.h"
#include "ui/preferences/system_theme.h"
#include "ui/units.h"
#include "ui/viewport/view_grid.h"
#include "ui/viewport/viewport_widget.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QMainWindow>

#include <utility>

namespace knead {

Preferences PreferencesFeature::begin()
{
    Preferences now = readPreferences();
    speak(languageFor(now.language));
    setLengthUnit(now.lengthUnit);
    return now;
}

PreferencesFeature::Actions::Actions(QWidget& window)
    : preferences(makeAction(window, {"preferences", QT_TRANSLATE_NOOP("Actions", "&Preferences..."), nullptr, "Ctrl+,",
                                      QT_TRANSLATE_NOOP("Actions", "Theme, language, units, memory, files, view")}))
    , shortcuts(makeAction(window, {"shortcuts", QT_TRANSLATE_NOOP("Actions", "&Keyboard shortcuts..."), nullptr, "",
                                    QT_TRANSLATE_NOOP("Actions", "Give commands other keys")}))
    , lightTheme(makeSwitch(window, {"lightTheme", QT_TRANSLATE_NOOP("Actions", "Light")}))
    , darkTheme(makeSwitch(window, {"darkTheme", QT_TRANSLATE_NOOP("Actions", "Dark")}))
    , systemTheme(makeSwitch(window, {"systemTheme", QT_TRANSLATE_NOOP("Actions", "As the system")}))
{
    auto* themes = new QActionGroup(&window);
    for (QAction* theme : {lightTheme, darkTheme, systemTheme})
        themes->addAction(theme);
}

PreferencesFeature::PreferencesFeature(const Workbench& bench, Preferences now)
    : QObject(&bench.window)
    , m_bench(bench)
    , m_actions(bench.window)
    , m_system(new SystemTheme(this))
    , m_now(std::move(now))
{
    const auto on = [this](QAction* action, auto slot) { connect(action, &QAction::triggered, this, slot); };
    on(m_actions.preferences, [this] { showDialog(PreferencesDialog::Page::General); });
    on(m_actions.shortcuts, [this] { showDialog(PreferencesDialog::Page::Keys); });
    on(m_actions.lightTheme, [this] { chooseLook(Preferences::Look::Light); });
    on(m_actions.darkTheme, [this] { chooseLook(Preferences::Look::Dark); });
    on(m_actions.systemTheme, [this] { chooseLook(Preferences::Look::System); });
    connect(m_system, &SystemTheme::changed, this, &PreferencesFeature::applyLook);
}

void PreferencesFeature::takeKeys()
{
    m_shortcuts = new Shortcuts(m_bench.window);
}

/// The dialog asks for the window's actions to the end.
PreferencesFeature::~PreferencesFeature()
{
    delete m_dialog;
}

void PreferencesFeature::showDialog(PreferencesDialog::Page page)
{
    if (m_dialog == nullptr) {
        m_dialog = new PreferencesDialog(readPreferences(), *m_shortcuts, m_bench.window);
        m_dialog->setAttribute(Qt::WA_DeleteOnClose);
        connect(m_dialog, &PreferencesDialog::changed, this, &PreferencesFeature::set);
    }
    m_dialog->show(page);
}

void PreferencesFeature::followStored()
{
    if (m_dialog != nullptr)
        m_dialog->setPreferences(readPreferences());
}

void PreferencesFeature::set(const Preferences& wanted)
{
    const Preferences before = std::exchange(m_now, wanted);
    writePreferences(wanted);
    apply();
    if (wanted.look != before.look || wanted.textPercent != before.textPercent)
        applyLook();
    if (wanted.language != before.language)
        speak(languageFor(wanted.language));
    if (wanted.language != before.language || wanted.lengthUnit != before.lengthUnit)
        emit wordsChanged();
}

void PreferencesFeature::apply()
{
    const auto bytes = [](int megabytes) { return static_cast<std::size_t>(megabytes) << 20U; };
    setLengthUnit(m_now.lengthUnit);
    m_bench.document.setFilmMemory(bytes(m_now.filmMegabytes));
    if (m_bench.services.limitThreads)
        m_bench.services.limitThreads(static_cast<unsigned>(m_now.threads));
    m_bench.views.setSamples(m_now.smoothing);
    m_bench.viewport.setTurningSmoothly(m_now.turnsSmoothly);
    m_bench.viewport.setNavigation(navigationPreset(m_now.navigation));
    emit applied(m_now);
}

void PreferencesFeature::choose(const Preferences& wanted)
{
    set(wanted);
    if (m_dialog != nullptr)
        m_dialog->setPreferences(wanted);
}

void PreferencesFeature::chooseLook(Preferences::Look look)
{
    Preferences chosen = readPreferences();
    chosen.look = look;
    choose(chosen);
}

void PreferencesFeature::chooseThreads(int threads)
{
    Preferences chosen = readPreferences();
    chosen.threads = threads;
    choose(chosen);
}

void PreferencesFeature::setTheme(Theme theme)
{
    chooseLook(theme == Theme::Dark ? Preferences::Look::Dark : Preferences::Look::Light);
}

void PreferencesFeature::applyLook()
{
    const Preferences::Look look = m_now.look;
    const bool isDark = look == Preferences::Look::Dark || (look == Preferences::Look::System && m_system->isDark());
    applyTheme(*qApp, isDark ? Theme::Dark : Theme::Light, m_now.textPercent);
    m_bench.viewport.setStyle(isDark ? darkScene() : lightScene());
    QAction* const actions[] = {m_actions.lightTheme, m_actions.darkTheme, m_actions.systemTheme};
    actions[static_cast<std::size_t>(look)]->setChecked(true);
}

} // namespace knead
