#pragma once

#include "core/model/export_report.h"
#include "ui/deforming/deform_handles.h"
#include "ui/deforming/deform_stage.h"
#include "ui/deforming/number_form.h"
#include "ui/frame/workbench.h"

#include <QList>
#include <QObject>

#include <optional>

class QAction;
class QMenu;

namespace knead {

class DeformPanel;
class FieldDeforming;
class Modes;

/// Parts are deformed without forces: by numbers, between two planes that are dragged in the view or typed, or by a field of another
/// program. What comes of it is seen at once; Enter does it, Esc leaves everything as it is. Window thread only.
class DeformFeature final : public QObject {
    Q_OBJECT
public:
    struct Actions {
        explicit Actions(QWidget& window);

        QAction* deform; ///< on while a deformation is being said
        QList<QAction*> kinds;
        QAction* byField;
    };

    DeformFeature(const Workbench& bench, Modes& modes);

    const Actions& actions() const { return m_actions; }
    QMenu* newMenu() const; ///< of the kinds
    DeformHandles& handles() { return *m_handles; }

    /// Reads a field and begins with it.
    void openField(const QString& path);
    /// As Enter does.
    void apply();
    /// As Esc does.
    void leave();

signals:
    void applied(const knead::ExportReport& report); ///< on the faces that were deformed

private:
    void connectActions(Modes& modes);
    std::optional<QString> whyNot() const;
    void begin(NumberKind kind);
    void chooseKind(NumberKind kind);
    void askForField();
    void beginField();
    void switchOn(bool on);
    void end();
    void follow(Document::Change what);
    void followFrame();
    void takeParts();
    void take(const NumberForm& now);
    void drag(DeformHandle handle, double value);
    MeantParts meant() const;
    Box boxOfMeant() const;
    std::optional<Vec3> selectedNormal() const;

    Workbench m_bench;
    Actions m_actions;
    DeformPanel* m_panel;
    DeformStage* m_stage;
    DeformHandles* m_handles;
    FieldDeforming* m_byField;
    NumberKind m_kind = NumberKind::bend; ///< with which it begins
    bool m_isByField = false;
    std::optional<Vec3> m_normal;     ///< of the face that was selected when it began
    std::optional<NumberForm> m_form; ///< of the parts that are meant; none yet
    MeantParts m_meant;
    NumberSubject m_subject;
    TriangleMesh m_surface; ///< of these parts, as they are
};

} // namespace knead
