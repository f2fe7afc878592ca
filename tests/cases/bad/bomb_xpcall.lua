-- expect: bad/bomb_xpcall\.lua:3: the script spent more than 0.3 s in Lua itself \(--time-limit S allows more\)$
-- args: --time-limit 0.3
local function again() while true do end end
xpcall(error, again)
