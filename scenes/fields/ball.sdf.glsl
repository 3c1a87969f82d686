// A ball that bounces for ever: one second up and down, flat when it hits, long when it flies.
// bounds[-0.9, -0.02, -0.9,  0.9, 2.9, 0.9]
uniform float radius;  // slider[0.1, 0.5, 0.6] Radius, m
uniform float height;  // slider[0.2, 1.6, 1.6] Height of the jump, m
uniform float squash;  // slider[0.0, 0.32, 0.4] How soft the ball is

float sdf(vec3 p) {
    // A parabola in the air; on the ground, for a fifth of the time, half a sine of squashing.
    float cycle = fract(time);
    float contact = 0.2;
    float air = clamp((cycle - contact) / (1.0 - contact), 0.0, 1.0);
    float hop = height * 4.0 * air * (1.0 - air);
    float press = cycle < contact ? sin(3.14159265 * cycle / contact) : 0.0;

    // Wider as it gets lower: the volume stays the same.
    float speed = cycle < contact ? 0.0 : abs(1.0 - 2.0 * air);
    float tall = 1.0 - squash * press + 0.35 * squash * speed * speed;
    float wide = inversesqrt(tall);

    vec3 axes = radius * vec3(wide, tall, wide);
    return sdEllipsoid(p - vec3(0.0, hop + axes.y, 0.0), axes);
}
