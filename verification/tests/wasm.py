"""Gives every file `*.in` of a folder to the WebAssembly module, and writes its results into a file `*.out`.

Arguments: the module, the folder.
"""

import sys
from pathlib import Path

from wasmtime import Engine, Instance, Module, Store

store = Store(Engine())
module = Module.from_file(store.engine, sys.argv[1])
# No imports: the module can do nothing but compute.
exports = Instance(store, module, []).exports(store)
memory, place, replace = exports["memory"], exports["place"], exports["replace"]
for path in sorted(Path(sys.argv[2]).glob("*.in")):
    text = path.read_bytes()
    memory.write(store, text, place(store, len(text)))
    length = replace(store)
    start = place(store, length)
    path.with_suffix(".out").write_bytes(memory.read(store, start, start + length))
