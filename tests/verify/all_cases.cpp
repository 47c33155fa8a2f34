#include "verify/cases.h"

namespace knead::book {

std::vector<Case> allCases()
{
    std::vector<Case> cases;
    addElasticCases(cases);
    addBendingCases(cases);
    addStressCases(cases);
    addStructureCases(cases);
    addPlasticCases(cases);
    addFormingCases(cases);
    addRubberCases(cases);
    addContactCases(cases);
    addMotionCases(cases);
    addMeasuredCases(cases);
    return cases;
}

} // namespace knead::book
