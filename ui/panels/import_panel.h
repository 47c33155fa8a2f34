#pragma once

#include "core/session/filled_model.h"
#include "ui/panels/place_rows.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;
class QTextBrowser;

namespace knead {

/// The report on what was opened: the unit, what was repaired part by part, what is missing or odd, and what a person may have
/// done otherwise. Rows about a part have a link that shows it; Tab goes from one to the next, Enter follows it.
class ImportPanel final : public QWidget {
    Q_OBJECT
public:
    explicit ImportPanel(QWidget* parent = nullptr);

    /// @param isAsRead parts are those of the files; else reading them again would lose what has become of them since
    void show(const FilledModel& content, bool isAsRead);
    void clear(); ///< nothing is open
    /// Whether there is more to say than that all went well.
    bool hasRemarks() const { return m_hasRemarks; }

signals:
    void unitChosen(const QString& unit); ///< lengths are to be taken in this unit
    void healingChosen(bool heal);        ///< the shapes are wanted repaired, or as they are in the file
    void fillingChosen();                 ///< surfaces that are not closed are to be filled all the same
    void placeWanted(const knead::ReportPlace& place);

protected:
    void changeEvent(QEvent* event) override;

private:
    void listRemarks(const FilledModel& content);

    QLabel* m_summary;
    QComboBox* m_unit;
    QPushButton* m_heal;
    QPushButton* m_fill;
    QTextBrowser* m_remarks;
    std::optional<FilledModel> m_content; ///< that is shown
    std::vector<ReportPlace> m_places;    ///< of the links, by their numbers
    bool m_hasRemarks = false;
    bool m_isAsRead = true;
    bool m_isHealed = true;
};

} // namespace knead
