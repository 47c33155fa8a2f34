#pragma once

#include "core/model/field_file.h"

#include <QStringList>
#include <QWidget>

#include <array>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace knead {

class QuantityField;

/// How a field deforms, as the page says it, and how that is looked at.
struct FieldForm {
    double factor = 1;            ///< of its displacements; -1: the other way
    double fade = 0;              ///< from the faces that stay [m]; 0: by the part
    std::array<bool, 3> locked{}; ///< along x, y, z nothing moves
    double exaggeration = 1;      ///< of what is looked at; nothing else
    bool showsArrows = true;
    bool showsColors = true;
};

/// Where it is said how the displacements of another program deform the parts. It shows a file and tells when a person has changed
/// something.
class FieldPage final : public QWidget {
    Q_OBJECT
public:
    explicit FieldPage(QWidget* parent = nullptr);

    /// Begins with it. @param nodes of its field, which need not be in it @param isInPlace of a scan: whether it lies where the part does
    void show(const FieldFile& file, std::size_t nodes, bool isInPlace);
    void showSentences(const QStringList& sentences); ///< that a person should know
    void showKept(std::size_t faces);                 ///< that stay
    void showLargest(double way);                     ///< of what is looked at, without exaggeration [m]
    const FieldForm& form() const { return m_form; }
    bool isChoosing() const; ///< faces that stay
    void endChoosing();

signals:
    void changed();                                   ///< another deformation
    void lookChanged();                               ///< the same, looked at otherwise
    void choiceChanged(const knead::FieldChoice& to); ///< the file is to be read again
    void keepToggled(bool on);                        ///< faces that stay are chosen in the view, or were
    void keepNothingClicked();

private:
    void fill(QComboBox* choice, const std::vector<std::string>& texts, std::size_t current);
    FieldChoice choice() const;

    FieldForm m_form;
    QLabel* m_file;
    QComboBox* m_step;
    QComboBox* m_name;
    QComboBox* m_unit;
    QCheckBox* m_inPlace;
    QuantityField* m_factor;
    QLabel* m_kept;
    QPushButton* m_keep;
    QPushButton* m_keepNothing;
    QuantityField* m_fade;
    std::array<QCheckBox*, 3> m_locks{};
    QuantityField* m_exaggeration;
    QCheckBox* m_arrows;
    QCheckBox* m_colors;
    QLabel* m_largest;
    QLabel* m_sentences;
};

} // namespace knead
