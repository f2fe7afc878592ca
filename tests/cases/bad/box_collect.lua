-- expect: bad/box_collect\.lua:2: collectgarbage: only "count" is for case scripts, got "stop"$
collectgarbage("stop")
