-- expect: bad/box_finalizer\.lua:2: setmetatable: finalizers \(__gc\) are not for case scripts$
setmetatable({}, { __gc = function() while true do end end })
