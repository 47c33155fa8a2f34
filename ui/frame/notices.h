#pragma once

#include <QObject>

#include <functional>

namespace knead {

class Banner;
class LogPanel;

/// What the window says of its own accord: in the banner over the view, and line by line in the log. Window thread
/// only.
class Notices final : public QObject {
    Q_OBJECT
public:
    using Remedy = std::function<void()>;

    Notices(Banner& banner, LogPanel& log, QObject* parent);

    /// In both.
    /// @param remedy what a click on the button of that text does
    void problem(const QString& sentence, const QString& remedyText = {}, Remedy remedy = {});
    /// The same with a second button, see otherClicked().
    void trouble(const QString& sentence, const QString& remedyText, Remedy remedy, const QString& other);
    /// In the banner alone: what is advised.
    void advise(const QString& sentence, const QString& remedyText, Remedy remedy);
    /// In the log, and in the banner, too, unless that has something worse to say, or a remedy.
    void remark(const QString& sentence);
    void note(const QString& sentence); ///< in the log
    void warn(const QString& sentence); ///< in the log, as a warning

    /// Something is wrong that remarks must not replace in the banner.
    void setGrave(bool isGrave) { m_isGrave = isGrave; }
    QString shown() const;                  ///< in the banner, also when that is hidden
    void hide();                            ///< the banner
    void withdraw(const QString& sentence); ///< from the banner, where it is that which is shown: it is no longer so

signals:
    void otherClicked();

private:
    Banner& m_banner;
    LogPanel& m_log;
    Remedy m_remedy;
    bool m_isGrave = false;
};

} // namespace knead
