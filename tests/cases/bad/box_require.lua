-- expect: bad/box_require\.lua:2: require: only "hobe" is for case scripts, got "posix"
require "posix"
