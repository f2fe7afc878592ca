-- expect: bad/bomb_buffer\.lua:5: the script needs more than 16 MB of memory \(--memory-limit MB allows more\)$
-- args: --memory-limit 16
local t = {}
for i = 1, 1e5 do t[i] = "0123456789" end
local s = table.concat(t, ("x"):rep(1000))
