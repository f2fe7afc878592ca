-- expect: bad/box_debug\.lua:2: debug.getregistry is not for case scripts \(hobe run --trust allows it\)$
debug.getregistry()
