-- expect: bad/bomb_pcall_deep\.lua:3: the script spent more than 0.3 s in Lua itself \(--time-limit S allows more\)$
-- args: --time-limit 0.3
local function spin() while true do end end
while true do pcall(pcall, pcall, spin) end
