#include "io/recipe/scene_words.h"

namespace knead {

namespace {

template <class Items>
auto namedChoices(const Items& items)
{
    Choices<std::remove_cvref_t<decltype(items[0])>> choices;
    for (const auto item : items)
        choices.emplace_back(nameOf(item), item);
    return choices;
}

} // namespace

const Choices<BodyKind>& bodyKindWords()
{
    static const Choices<BodyKind> words{
        {"deformable", BodyKind::deformable}, {"rigid", BodyKind::rigid}, {"glue", BodyKind::glue}};
    return words;
}

const Choices<Integrator>& integratorWords()
{
    static const Choices<Integrator> words{{"semi-implicit-euler", Integrator::semiImplicitEuler},
                                           {"forward-euler", Integrator::forwardEuler},
                                           {"implicit-euler", Integrator::implicitEuler},
                                           {"automatic", Integrator::automatic}};
    return words;
}

const Choices<Pace>& paceWords()
{
    static const Choices<Pace> words{
        {"full", Pace::full}, {"rough", Pace::rough}, {"wide", Pace::wide}, {"exact", Pace::exact}};
    return words;
}

const Choices<Touching>& touchingWords()
{
    static const Choices<Touching> words{{"separate", Touching::separate}, {"glued", Touching::glued}};
    return words;
}

const Choices<ToolKind>& toolKindWords()
{
    static const Choices<ToolKind> words = namedChoices(toolKinds);
    return words;
}

const Choices<VicinityMethod>& vicinityWords()
{
    static const Choices<VicinityMethod> words = namedChoices(vicinityMethods);
    return words;
}

} // namespace knead
