-- expect: bad/box_loadfile\.lua:2: loadfile is not for case scripts \(hobe run --trust allows it\)$
loadfile("bad/syntax.lua")
