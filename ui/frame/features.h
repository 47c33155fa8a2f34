#pragma once

#include "ui/deforming/deform_feature.h"
#include "ui/exporting/export_feature.h"
#include "ui/help/help_feature.h"
#include "ui/importing/import_feature.h"
#include "ui/interaction/hands_feature.h"
#include "ui/measuring/comparison_feature.h"
#include "ui/measuring/measuring_feature.h"
#include "ui/preferences/preferences_feature.h"
#include "ui/probes/probes_feature.h"
#include "ui/project/other_part_feature.h"
#include "ui/project/projects_feature.h"
#include "ui/project/recipes_feature.h"
#include "ui/recording/picture_feature.h"
#include "ui/recording/recording_feature.h"
#include "ui/selection/selection_feature.h"
#include "ui/simulation/simulation_feature.h"
#include "ui/tracing/trace_feature.h"
#include "ui/viewport/views_feature.h"

namespace knead {

/// What a window can do, a class each. They belong to the window.
struct Features {
    ProjectsFeature* projects = nullptr;
    RecipesFeature* recipes = nullptr;
    OtherPartFeature* otherPart = nullptr;
    ImportFeature* imports = nullptr;
    ExportFeature* exports = nullptr;
    PictureFeature* pictures = nullptr;
    ViewsFeature* views = nullptr;
    SelectionFeature* selection = nullptr;
    SimulationFeature* simulation = nullptr;
    HandsFeature* hands = nullptr;
    DeformFeature* deforming = nullptr;
    MeasuringFeature* measuring = nullptr;
    ComparisonFeature* comparison = nullptr;
    ProbesFeature* probes = nullptr;
    RecordingFeature* recording = nullptr;
    PreferencesFeature* preferences = nullptr;
    HelpFeature* help = nullptr;
    TraceFeature* trace = nullptr;
};

} // namespace knead
