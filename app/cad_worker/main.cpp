#include "io/worker/cad_worker.h"

int main(int argc, char** argv)
{
    return knead::workForParent(argc, argv);
}
