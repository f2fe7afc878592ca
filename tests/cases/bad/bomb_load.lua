-- expect: bad/bomb_load\.lua:3: the script spent more than 0.3 s in Lua itself \(--time-limit S allows more\)$
-- args: --time-limit 0.3
while true do load("return 1")() end
