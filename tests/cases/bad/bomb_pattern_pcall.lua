-- expect: bad/bomb_pattern_pcall\.lua:3: the script spent more than 0.3 s in Lua itself \(--time-limit S allows more\)$
-- args: --time-limit 0.3
while true do pcall(string.find, ("a"):rep(40), ("a*"):rep(30) .. "b") end
