// A chess board on the ground plane of the object, without flicker in the distance: each square
// wave is replaced by its mean over the width of the pixel.
uniform vec3 light;  // color[0.80, 0.78, 0.74] Light squares
uniform vec3 dark;   // color[0.06, 0.07, 0.09] Dark squares
uniform float size;  // slider[0.05, 0.5, 2.0] Edge of a square, m

// The integral of a square wave of period 2 that is +1, then -1.
float waveIntegral(float x) { return abs(2.0 * fract(0.5 * x) - 1.0); }

float filteredWave(float x, float width) {
    return (waveIntegral(x - 0.5 * width) - waveIntegral(x + 0.5 * width)) / width;
}

void material(inout Surface s) {
    float width = max(s.footprint / size, 0.001);
    float a = filteredWave(s.localPosition.x / size, width);
    float b = filteredWave(s.localPosition.z / size, width);
    s.baseColor = mix(dark, light, 0.5 + 0.5 * a * b);
}
