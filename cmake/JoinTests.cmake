# cmake -DOUTPUT=FILE -DNAMES=a;b -DSOURCES=a.cpp;b.cpp -P JoinTests.cmake: one source of several tests, each as it stands, with its
# own main(), in a namespace of its own; what they include comes before. Which of them runs is said by the name of the program, or,
# where that is none of theirs, by the one that has started its own program once more.
set(includes)
set(tests)
set(choices)
set(words)
foreach(name source IN ZIP_LISTS NAMES SOURCES)
    file(STRINGS ${source} lines REGEX "^#include ")
    list(FILTER lines EXCLUDE REGEX "\\.moc\"")
    list(APPEND includes ${lines})
    string(APPEND tests "namespace ${name}_of_many {\n#define main testMain\n#include \"${source}\"\n#undef main\n}\n")
    list(APPEND words "\"${name}\"")
    string(APPEND choices "    if (name == \"${name}\")\n        return ${name}_of_many::testMain(argc, argv);\n")
endforeach()
list(LENGTH NAMES count)
list(JOIN words ", " words)
list(REMOVE_DUPLICATES includes)
list(JOIN includes "\n" includes)
file(WRITE ${OUTPUT} "${includes}
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string_view>

${tests}
namespace {

constexpr std::array<std::string_view, ${count}> tests{${words}};
constexpr const char* variable = \"KNEAD_TEST\";

std::string_view nameOf(std::string_view path)
{
    path.remove_prefix(path.rfind('/') + 1);
    for (const std::string_view test : tests)
        if (test == path) {
            setenv(variable, test.data(), 1);
            return test;
        }
    const char* told = getenv(variable);
    return told == nullptr ? \"\" : told;
}

} // namespace

int main(int argc, char** argv)
{
    const std::string_view name = nameOf(argv[0]);
${choices}    std::fprintf(stderr, \"Run a test by its own name, which is a link to this program.\\n\");
    return 2;
}
")
