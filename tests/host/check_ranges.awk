# SPDX-License-Identifier: MIT
# Computes rows of the tables read by tidepool check, in double precision, by the models'
# formulas.  Input: one line of parameters per row; each model names its parameters.
#     awk -v model=NAME [-v waves=... | -v ring=... | -v k=...] -f check_ranges.awk

BEGIN { OFS = ","; OFMT = CONVFMT = "%.17g"; PI = atan2(0, -1); G = 9.81; set_up() }

function tanh(x) { return x > 20 ? 1 : x < 1e-4 ? x : 1 - 2 / (exp(2 * x) + 1) }
function sinh(x) { return (exp(x) - exp(-x)) / 2 }
function pow(x, y) { return exp(y * log(x)) }
function at_least(x, least) { return x < least ? least : x }
function at_most(x, most) { return x > most ? most : x }

# -- waves over a depth: T h ... ---------------------------------------------------------

function depth_wave(period, h,    i, u)         # omega, kinf, k and its estimates
{
    omega = 2 * PI / period
    kinf = omega * omega / G
    eckart = kinf / sqrt(tanh(kinf * h))
    fenton = kinf / pow(tanh(pow(kinf * h, 0.75)), 2 / 3)
    for (k_ = eckart; i < 60; i++) {
        u = tanh(k_ * h)
        k_ -= (k_ * u - kinf) / (u + k_ * h * (1 - u * u))
        if (i == 0)
            newton = k_
    }
    celerity = omega / k_
    u = 2 * k_ * h
    group = celerity / 2 * (u > 40 ? 1 : 1 + u / sinh(u))
    ks = sqrt(G / omega / (2 * group))
}

model == "dispersion" {                         # T h
    depth_wave($1, $2)
    deep = $2 * k_ / (2 * PI)
    print $1, $2, omega, kinf, k_, eckart, fenton, newton, 2 * PI / k_, celerity, group, \
        ks, deep < 0.05 ? "shallow" : deep < 0.5 ? "transition" : "deep"
}

model == "shoaling_phase" {                     # T h theta x, a level floor
    depth_wave($1, $2)
    kz = kinf * sin($3 * PI / 180)
    straight = sqrt(k_ * k_ - kz * kz)
    for (i = 0; i < 2; i++)
        print $1, $2, 0, $3, i * $4, $2, k_, kz, atan2(kz, straight) * 180 / PI, \
            i * $4 * straight, 0
}

model == "breaking_criteria" {                  # T H0 h slope
    depth_wave($1, $3)
    high = $2 * ks
    miche = 0.142 * 2 * PI / k_ * tanh(k_ * $3)
    xi = $4 / sqrt($2 / (2 * PI / kinf))
    over_l = high * k_ / (2 * PI)
    print $1, $2, $3, $4, k_, ks, high, over_l, high / $3, (over_l > 1 / 7), \
        (high / $3 > 0.78), (high > miche), miche, xi, \
        xi < 0.5 ? "spilling" : xi < 3.3 ? "plunging" : "surging"
}

model == "wind_phase" {                         # r lambda theta
    it1 = $3 + $1 * $2 * cos($3)
    it2 = $3 + $1 * $2 * cos(it1)
    print $1, $2, $3, 0, it1, it2, $3 + $1 * $2 * cos(it2)
}

# -- swells ------------------------------------------------------------------------------

function set_up(    list, i, w)                 # waves: "L A Q degrees phase;..."
{
    count = waves ? split(waves, list, ";") : 0
    for (i = 0; i < count; i++) {
        split(list[i + 1], w, " ")
        k_of[i] = 2 * PI / w[1]; a_of[i] = w[2]; omega_of[i] = sqrt(G * k_of[i])
        dx_of[i] = sin(w[4] * PI / 180); dz_of[i] = -cos(w[4] * PI / 180)
        phase_of[i] = w[5]; q_of[i] = w[3] * k_of[i] * w[2]
        printf "# wave %d: L=%.17g k=%.17g omega=%.17g Dx=%.17g Dz=%.17g phase=%.17g" \
            " A=%.17g Q=%.17g (m, rad/m, rad/s, 1, 1, rad, m, 1)\n", i, w[1], k_of[i], \
            omega_of[i], dx_of[i], dz_of[i], w[5], w[2], w[3]
    }
    if (head)
        print head
    split(ring, ring_of, " ")
    split(k, orbit_k, " ")
}

function swells(x0, z0, t, sharp,    i, th, s, c, q)    # displaced point of rest position
{
    px = x0; py = 0; pz = z0; hx = hz = jxz = 0; jxx = jzz = 1
    for (i = 0; i < count; i++) {
        th = k_of[i] * (dx_of[i] * x0 + dz_of[i] * z0) - omega_of[i] * t + phase_of[i]
        s = sin(th); c = cos(th); q = sharp * q_of[i]
        px += q / k_of[i] * dx_of[i] * c
        pz += q / k_of[i] * dz_of[i] * c
        py += a_of[i] * s
        hx += k_of[i] * a_of[i] * dx_of[i] * c
        hz += k_of[i] * a_of[i] * dz_of[i] * c
        jxx -= q * dx_of[i] * dx_of[i] * s
        jxz -= q * dx_of[i] * dz_of[i] * s
        jzz -= q * dz_of[i] * dz_of[i] * s
    }
    nx = hz * jxz - hx * jzz; ny = jxx * jzz - jxz * jxz; nz = hx * jxz - hz * jxx
    size = sqrt(nx * nx + ny * ny + nz * nz)
    nx /= size; ny /= size; nz /= size
}

model == "sum_of_sines" {                       # x z t
    swells($1, $2, $3, 0)
    print $1, $2, $3, py, hx, hz, nx, ny, nz
}

model == "gerstner_sum" {                       # x0 z0 t
    swells($1, $2, $3, 1)
    print $1, $2, $3, px, py, pz, nx, ny, nz, jxx, hx, jxz, jxz, hz, jzz, 0
}

model == "buoyancy" {                           # x z t
    x0 = $1; z0 = $2
    for (i = 0; i < 3000; i++) {
        swells(x0, z0, $3, 1)
        if (i < 5)
            step[i] = py
        x0 += $1 - px; z0 += $2 - pz
    }
    print $1, $2, $3, x0, z0, py, step[0], step[1], step[2], step[3], step[4], nx, ny, nz
}

# L S degrees x0 z0 th turn: th is the phase, turn that of the normal, degrees
model == "gerstner_single" {
    wave_k = 2 * PI / $1; dx = sin($3 * PI / 180); dz = -cos($3 * PI / 180)
    t = (wave_k * (dx * $4 + dz * $5) - $6) / sqrt(G * wave_k)
    for (turn = 2 * PI / sqrt(G * wave_k); t < 0;)
        t += turn * int(1 - t / turn)
    th = wave_k * (dx * $4 + dz * $5) - sqrt(G * wave_k) * t
    a = $2 / wave_k
    tilt = atan2($2 * cos(th), 1 - $2 * sin(th)) + $7 * PI / 180
    print $1, $2, dx, dz, $4, $5, t, $4 + a * dx * cos(th), a * sin(th), \
        $5 + a * dz * cos(th), -dx * sin(tilt), cos(tilt), -dz * sin(tilt), 0
}

model == "sharp_sine" {                         # k A theta
    b = (sin($3) + 1) / 2
    mean = 2
    for (i = 1; i <= $1; i++)
        mean *= (2 * i - 1) / (2 * i)
    f = 2 * b ^ $1
    print $1, $2, $3, f, mean, $2 * (f - mean), $2 * $1 * b ^ ($1 - 1) * cos($3)
}

# -- rings and drops ---------------------------------------------------------------------

function eta(x, z, t,    age, rho, xi, rise)    # ring: cx cz t0 A L c tau p0 tr
{
    age = t - ring_of[3]
    rho = sqrt((x - ring_of[1]) ^ 2 + (z - ring_of[2]) ^ 2)
    xi = rho - ring_of[5] / 2 - ring_of[6] * age
    if (age <= 0 || xi * xi >= ring_of[5] * ring_of[5] / 4)
        return 0
    rise = ring_of[9] > 0 ? at_most(age / ring_of[9], 1) : 1
    return ring_of[4] * rise * rise * (3 - 2 * rise) * exp(-age / ring_of[7]) \
        / sqrt(1 + rho / ring_of[8]) * (1 + cos(2 * PI * xi / ring_of[5])) / 2
}

function slopes(x, z, t, d)
{
    sx = (eta(x + d, z, t) - eta(x - d, z, t)) / (2 * d)
    sz = (eta(x, z + d, t) - eta(x, z - d, t)) / (2 * d)
    size = sqrt(1 + sx * sx + sz * sz)
    return -sx / size "," 1 / size "," (-sz / size)
}

model == "droplet_waves" {                      # x z t
    five = slopes($1, $2, $3, 0.05)
    normal = slopes($1, $2, $3, 1e-5 * ring_of[5])
    print $1, $2, $3, eta($1, $2, $3), sx, sz, normal, five
}

model == "drop_bounce" {                        # y0 e eff rad density
    speed = sqrt(2 * G * $1)
    for (b = 0; b < 7; b++) {
        t = b ? t + 2 * speed / G : speed / G
        rad = $4 * pow(2, -b / 3)
        m = $5 * 4 * PI / 3 * rad ^ 3
        lost = m * speed * speed / 2 * (1 - $2 * $2 / 2)
        # [D4]: eff E_lost goes into a ring of length 8 rad.
        print NR - 1, $1, $2, $3, b, t, m, rad, speed, lost, 8 * rad, \
            speed * sqrt($3 * (1 - $2 * $2 / 2) * $5 * rad / (36000 * G))
        speed *= $2
    }
}

# -- orbits: r h gamma k ...; k: K0 Kx Ky ------------------------------------------------

function orbit(r, h, gamma, number, k0, kx, ky,    lack)
{
    deep = at_least(h, 1 / 16)
    lack = 1 - exp(-kx * deep)
    sin_a = at_least(sin(gamma), 0) * exp(-k0 * deep)
    cos_a = sqrt(1 - sin_a * sin_a)
    raw = 1 / lack
    s_x = at_most(raw, 0.95 / (number * r))
    s_y = (1 - exp(-ky * deep)) / lack
}

function particle(r, phi)
{
    along = r * s_x * sin(phi); up = -r * s_y * cos(phi)
    dx = along * cos_a - up * sin_a
    dy = along * sin_a + up * cos_a
}

model == "fr_orbit" {                           # r h gamma k Phi
    orbit($1, $2, $3, $4, orbit_k[1], orbit_k[2], orbit_k[3])
    particle($1, $5)
    print $1, $2, $3, $4, $5, sin_a, cos_a, raw, s_x, s_y, dx, dy
}

model == "breaking" {                           # r h gamma k St Ks Kd p
    orbit($1, $2, $3, $4, 0.1, 0.11, 0.09)
    lowest = -atan2(s_x * sin_a, s_y * cos_a)
    particle($1, lowest + $8)
    ramp = $8 < -PI / 3 ? (-$8 / PI - 1 / 3) * 1.5 : $8 > 7 * PI / 8 ? 8 * $8 / PI - 7 : 0
    alpha = atan2(sin_a, cos_a)
    angle = alpha + (-PI / 4 - alpha) * ramp
    gate = at_most(at_least((2 * $1 / $2 - 0.6) / 0.18, 0), 1)
    gate = gate * gate * (3 - 2 * gate)
    stretch = $5 * ($8 / PI) ^ 2
    lip = 2 * $1 * ramp
    out = gate * exp(-$6 * deep) * stretch
    over = gate * exp(-$7 * deep) * lip
    print $1, $2, $3, $4, $5, $6, $7, lowest + $8, lowest, $8, stretch, lip, angle, \
        gate, dx + out * cos_a + over * cos(angle), dy + out * sin_a + over * sin(angle)
}

# -- light: angle to the normal, degrees; d; all turned by an angle, degrees -------------

function turned(x, y)
{
    return (x * cos(tilt) - y * sin(tilt)) "," (x * sin(tilt) + y * cos(tilt))
}

model == "reflect_refract" {
    s = sin($1 * PI / 180); c = cos($1 * PI / 180); ts = s / 1.333
    tilt = $3 * PI / 180
    down = atan2(sqrt(1 - ts * ts), ts) - tilt
    print turned(s, -c), 0, turned(0, 1), 0, turned(s, c), 0, cos(down), -sin(down), 0, \
        $2, $2 * cos(down) / sin(down), 0
}
