-- expect: bad/bomb_coroutine_memory\.lua:4: the script needs more than 16 MB of memory \(--memory-limit MB allows more\)$
-- args: --memory-limit 16
local keep = {}
while true do keep[#keep + 1] = coroutine.create(function() end) end
