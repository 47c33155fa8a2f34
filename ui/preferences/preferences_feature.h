#pragma once

#include "ui/frame/workbench.h"
#include "ui/preferences/preferences_dialog.h"
#include "ui/theme.h"

#include <QObject>
#include <QPointer>

class QAction;

namespace knead {

class Shortcuts;
class SystemTheme;

/// What a person prefers: the dialog for it, the theme and the language. Window thread only.
class PreferencesFeature final : public QObject {
    Q_OBJECT
public:
    /// What must hold before anything is said or made: language and unit. @return the preferences as they are kept
    static Preferences begin();

    struct Actions {
        explicit Actions(QWidget& window);

        QAction* preferences;
        QAction* shortcuts;
        QAction* lightTheme;
        QAction* darkTheme;
        QAction* systemTheme;
    };

    PreferencesFeature(const Workbench& bench, Preferences now);
    ~PreferencesFeature() override;

    /// Once all actions of the window are there: what keys they have, and which a person gave them.
    void takeKeys();

    const Actions& actions() const { return m_actions; }
    const Preferences& now() const { return m_now; }
    /// Keeps them, and does as they say at once.
    void set(const Preferences& wanted);
    void setTheme(Theme theme);
    void chooseThreads(int threads);
    void showDialog(PreferencesDialog::Page page);
    /// They were changed elsewhere: what the dialog shows is old.
    void followStored();

    void apply();     ///< all but the look
    void applyLook(); ///< theme, colors and size of texts

signals:
    /// What is wanted from now on, see apply().
    void applied(const knead::Preferences& now);
    /// The language or a unit is another one: what was put together of texts and numbers is old.
    void wordsChanged();

private:
    void chooseLook(Preferences::Look look);
    void choose(const Preferences& wanted);

    Workbench m_bench;
    Actions m_actions;
    Shortcuts* m_shortcuts = nullptr;
    SystemTheme* m_system;
    Preferences m_now;
    QPointer<PreferencesDialog> m_dialog;
};

} // namespace knead
