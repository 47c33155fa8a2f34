#include "app/python/bindings.h"
#include "core/session/recipe_runner.h"
#include "core/task/task_control.h"

#include "app/commands/run_json.h"

#include <nlohmann/json.hpp>

#include <exception>
#include <stdexcept>

namespace py = pybind11;

namespace knead::python {

namespace {

PyObject* errorType = nullptr; ///< knead.Error; lives as long as the interpreter

/// A run that failed midway tells what is known of it.
void raiseWithReport(const RunFailed& failed)
{
    py::object error = py::reinterpret_borrow<py::object>(errorType)(readable(failed.what()));
    error.attr("report") = fromJson(jsonOf(failed.report));
    PyErr_SetObject(errorType, error.ptr());
}

/// Sentences of Knead become knead.Error; what pybind11 throws for Python's own errors passes.
void translate(std::exception_ptr thrown)
{
    try {
        if (thrown)
            std::rethrow_exception(thrown);
    } catch (const py::builtin_exception&) {
        throw;
    } catch (const RunFailed& failed) {
        raiseWithReport(failed);
    } catch (const std::runtime_error& error) {
        PyErr_SetObject(errorType, readable(error.what()).ptr());
    }
}

} // namespace

py::str readable(std::string_view text)
{
    PyObject* decoded = PyUnicode_DecodeUTF8(text.data(), static_cast<py::ssize_t>(text.size()), "replace");
    return decoded != nullptr ? py::reinterpret_steal<py::str>(decoded) : throw py::error_already_set();
}

py::object fromJson(const std::string& text)
{
    return py::module_::import("json").attr("loads")(text);
}

py::object fromJson(const nlohmann::ordered_json& json)
{
    return fromJson(json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

} // namespace knead::python

PYBIND11_MODULE(_knead, module)
{
    using namespace knead::python;
    module.doc() = "What knead is made of; import knead instead.";
    module.attr("__version__") = KNEAD_VERSION;
    errorType = PyErr_NewExceptionWithDoc(
        "knead.Error",
        "What went wrong, in a sentence that says what to do. `report` is what is known of a run that failed midway.",
        PyExc_RuntimeError, py::dict(py::arg("report") = py::none()).ptr());
    module.attr("Error") = py::reinterpret_borrow<py::object>(errorType);
    py::register_local_exception_translator(&translate);
    findOwnFiles();
    bindMaterial(module);
    bindParts(module);
    bindSimulation(module);
    bindFiles(module);
}
