-- expect: bad/box_dump\.lua:2: string.dump is not for case scripts \(hobe run --trust allows it\)$
string.dump(function() end)
