# SPDX-License-Identifier: BSD-3-Clause
"""Runs the programs, in sessions of their own: an interruption of the benchmark is passed on by stop(), not by the terminal."""
import pathlib
import signal
import subprocess
import threading

LOCK = threading.Lock()
RUNNING = set()
STOPPED = threading.Event()


def output_of(command, accepted=0):
    """The output of a program; what it says of its failure, or the signal that ended it, as a RuntimeError. An exit code above 0 is
    no failure if it is the accepted one."""
    with LOCK:
        if STOPPED.is_set():
            raise RuntimeError("interrupted")
        process = subprocess.Popen([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                   errors="replace", start_new_session=True)
        RUNNING.add(process)
    try:
        output, messages = process.communicate()
    finally:
        process.kill()  # if the communication was interrupted
        RUNNING.discard(process)
    name, code = pathlib.Path(command[0]).name, process.returncode
    if code < 0:
        raise RuntimeError(f"{name} was ended by signal {-code} ({signal.strsignal(-code)})")
    if code not in (0, accepted):
        raise RuntimeError((messages.strip().splitlines() or [f"{name} ended with {code}"])[-1])
    return output


def stop():
    """Ends the programs that run; no other one is started."""
    with LOCK:
        STOPPED.set()
        for process in RUNNING.copy():
            process.terminate()
