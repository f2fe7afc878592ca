-- expect: bad/box_remove\.lua:2: os.remove is not for case scripts \(hobe run --trust allows it\)$
os.remove("box_remove.lua")
