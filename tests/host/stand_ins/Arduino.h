/* SPDX-License-Identifier: MIT */
/* A stand-in for Arduino: a serial port, connected to stderr. */
#ifndef STAND_IN_ARDUINO_H
#define STAND_IN_ARDUINO_H
#include <cstddef>
#include <cstdint>

struct HardwareSerial {
    void begin(unsigned long baud);
    size_t print(const char *text);
    size_t println(const char *text);
};
extern HardwareSerial Serial;
void setup();
void loop();
#endif
