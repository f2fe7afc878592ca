-- expect: bad/scene_empty\.lua:5: scene: there is no hobe.beam\{...\} or hobe.body\{...\} in it$
local hobe = require "hobe"
local section = hobe.rectangle{ width = 0.01, height = 0.02 }
local steel = { E = 210e9, nu = 0.3, rho = 7850 }
local scene = hobe.scene{}
