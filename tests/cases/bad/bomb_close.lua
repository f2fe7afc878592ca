-- expect: bad/bomb_close\.lua:3: the script spent more than 0.3 s in Lua itself \(--time-limit S allows more\)$
-- args: --time-limit 0.3
local mt = { __close = function() while true do end end }
local x <close> = setmetatable({}, mt)
