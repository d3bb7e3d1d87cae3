# SPDX-License-Identifier: MIT
# The core keeps no state of its own: nothing in .data, .bss or thread-local storage.
# Constant tables of addresses (.data.rel.ro) do not count as state.
#
#   size -A libtidepool.a | awk -f tests/gates/state.awk
/ :$|ex / || /:$/ { file = $1 }
/^\.(data|bss|sdata|sbss|tdata|tbss|COMMON|\*COM\*)/ && !/^\.data\.rel\.ro/ && $2 > 0 {
    print file " " $1 ": " $2 " bytes of mutable state"
    bad = 1
}
/^\.text/ { code += $2 }
END {
    if (!code)
        print "no code at all"
    exit bad || !code
}
