#pragma once

#include <QObject>

class QDBusVariant;

namespace knead {

/// Whether the desktop asks for a dark look, now and when it changes: as the XDG settings portal says (GNOME, KDE and others),
/// else by the colors that Qt began with. Nothing here waits. Window thread.
class SystemTheme final : public QObject {
    Q_OBJECT
public:
    /// @pre the program's colors have not been changed yet
    explicit SystemTheme(QObject* parent = nullptr);

    bool isDark() const { return m_isDark; }

    /// What the portal says: 1 asks for dark, 2 for light, anything else for nothing.
    void take(const QVariant& colorScheme);

signals:
    void changed();

private slots:
    void settingChanged(const QString& group, const QString& name, const QDBusVariant& value);

private:
    void ask();

    bool m_isDark;
};

} // namespace knead
