-- expect: bad/bomb_coroutine\.lua:3: the script spent more than 0.3 s in Lua itself \(--time-limit S allows more\)$
-- args: --time-limit 0.3
while true do coroutine.wrap(function() while true do end end)() end
