-- expect: bad/box_dofile\.lua:2: dofile is not for case scripts \(hobe run --trust allows it\)$
dofile("bad/syntax.lua")
