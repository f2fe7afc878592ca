-- expect: reduce_no_scene\.lua:2: reduce: what is reduced must be a scene, hobe\.scene\{\.\.\.\}, got a table$
local hobe = require "hobe" hobe.reduce{ modes = 3 }
