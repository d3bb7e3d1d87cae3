# SPDX-License-Identifier: MIT
# The emulated Cortex-M4 with the counting plugin; read after tests/gates/lib.sh.

plugin=build/host/count.so

# emulate ELF SAID COUNTS: writes the program's output to SAID and the plugin's counts to
# COUNTS.
emulate()
{
    timeout 300 qemu-system-arm -M mps2-an386 -nographic -monitor none -serial null \
        -chardev file,id=said,path="$2" \
        -semihosting-config enable=on,target=native,chardev=said -kernel "$1" \
        -plugin $plugin 2>"$3" </dev/null
}
