#pragma once

#include "ui/preferences/preferences.h"

#include <QDialog>

#include <functional>
#include <vector>

class QComboBox;
class QFormLayout;
class QListWidget;
class QMainWindow;
class QSpinBox;
class QStackedWidget;
class QVBoxLayout;

namespace knead {

class Shortcuts;

/// What a person may choose for the program, in pages. Every change applies at once; the dialog does not block the window.
class PreferencesDialog final : public QDialog {
    Q_OBJECT
public:
    enum class Page { General, Memory, Files, View, Keys };

    PreferencesDialog(const Preferences& now, Shortcuts& shortcuts, QMainWindow& window);

    void show(Page page);
    /// They were changed elsewhere.
    void setPreferences(const Preferences& now);

signals:
    void changed(const knead::Preferences& now);

protected:
    void changeEvent(QEvent* event) override;

private:
    /// A row of a page: how a preference comes into its field.
    using Filling = std::function<void(const Preferences&)>;
    struct Choice {
        QString text;
        QVariant value;
    };

    QFormLayout* addPage(const QString& title);
    void addGeneralPage();
    void addMemoryPage();
    void addFilesPage();
    void addViewPage();
    void addButtons(QVBoxLayout* column);
    void addNote(QFormLayout* form, const QString& text);
    QComboBox* addChoice(QFormLayout* form, const QString& title, const char* name, const std::vector<Choice>& choices,
                         std::function<QVariant(const Preferences&)> get,
                         std::function<void(Preferences&, const QVariant&)> set);
    QSpinBox* addNumber(QFormLayout* form, const QString& title, const char* name, const QString& suffix, int least,
                        int most, int Preferences::*member);
    void addSwitch(QFormLayout* form, const QString& text, const char* name, bool Preferences::*member);
    void change(const std::function<void(Preferences&)>& edit);
    void restoreDefaults();

    Preferences m_now;
    Shortcuts& m_shortcuts;
    QListWidget* m_index;
    QStackedWidget* m_pages;
    std::vector<Filling> m_fillings;
    bool m_isFilling = false;
};

} // namespace knead
