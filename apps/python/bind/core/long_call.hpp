// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/casters.hpp"

#include <fretwork/base/control.hpp>

#include <memory>

namespace fretwork::python {

/// Long work of the framework, called from Python: without the GIL, with progress, and stopped within 50 ms
/// by Ctrl-C, by any other signal whose handler raises, or by an error of the progress function. Signals stop
/// only calls on the main thread of Python.
///
/// Python runs the handlers of signals only on its main thread, when this thread asks. If the main thread
/// makes the call, it asks every ten milliseconds. The framework's other threads read a flag that SIGINT
/// raises, because the calling thread may be waiting for them.
class LongCall {
  public:
    /// @param progress  called with the task, the number of steps done, and the number of all steps; None: no
    ///                  reports; True: a bar
    ///
    /// Throws TypeError if `progress` is anything else.
    explicit LongCall(py::object progress);
    LongCall(const LongCall&) = delete;
    LongCall& operator=(const LongCall&) = delete;
    ~LongCall();

    [[nodiscard]] base::Control control() const;

    /// Calls work(control) without the GIL, and returns its result, which must not be void. If Python raised
    /// an error meanwhile, this error is thrown in place of Stopped, and also if the work has returned.
    template <class Work>
    auto run(const Work& work) {
        try {
            auto result = without_gil(work);
            raise_kept();  // work that returns a part of its result throws no Stopped
            return result;
        } catch (const base::Stopped&) {
            raise_kept();
            raise_pending();
            throw;
        } catch (const py::error_already_set&) {
            raise_kept();  // the error may be a Stopped that passed through Python
            throw;
        }
    }

    /// The same for work that, when stopped, returns its result so far. If `was_stopped(result)`,
    /// KeyboardInterrupt is not raised, but any other error that Python raised is.
    template <class Work, class WasStopped>
    auto run_to_keep(const Work& work, const WasStopped& was_stopped) {
        return run([&](const base::Control& control) {
            auto result = work(control);
            if (was_stopped(result)) forget_interrupt();
            return result;
        });
    }

  private:
    class Impl;
    template <class Work>
    auto without_gil(const Work& work) {
        const py::gil_scoped_release released;
        return work(control());
    }
    /// Throws the first error that Python raised meanwhile, if any.
    void raise_kept();
    /// Runs the handlers of the signals that have arrived, then forgets KeyboardInterrupt if it was raised.
    /// Called without the GIL.
    void forget_interrupt();
    /// Lets Python handle the signals that have arrived.
    static void raise_pending();
    std::unique_ptr<Impl> impl_;
};

/// Runs work(control) as a LongCall.
template <class Work>
auto run_long(const py::object& progress, const Work& work) {
    LongCall call(progress);
    return call.run(work);
}

}  // namespace fretwork::python
