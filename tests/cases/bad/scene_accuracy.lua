-- expect: bad/scene_accuracy\.lua:6: scene: accuracy must be .*1.*, got 10$
local hobe = require "hobe"
local beam = hobe.beam{ name = "b", elements = 1, section = hobe.square{ side = 0.1 },
                        material = { E = 1e9, nu = 0.3 }, from = {0, 0, 0}, to = {1, 0, 0} }
local items = { beam, hobe.clamp{ "b", at = 0 } }
hobe.scene{ items[1], items[2], accuracy = 10 }
