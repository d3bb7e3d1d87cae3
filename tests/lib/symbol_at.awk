# SPDX-License-Identifier: MIT
# Index of the last symbol at or below an address: `start` has the addresses of `symbols`
# symbols in ascending order.
function symbol_at(address,    low, high, middle)
{
    low = 1
    high = symbols
    while (low < high) {
        middle = int((low + high + 1) / 2)
        if (start[middle] <= address)
            low = middle
        else
            high = middle - 1
    }
    return low
}
