-- expect: bad/bomb_while\.lua:3: the script spent more than 0.3 s in Lua itself \(--time-limit S allows more\)$
-- args: --time-limit 0.3
while true do end
